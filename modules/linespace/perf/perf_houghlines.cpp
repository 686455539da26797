// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// cv::HoughLines and its drop-in on the same edge maps, at the same steps.

#include "edge_maps.hpp"

namespace opencv_test {
namespace {

enum Implementation
{
    OPENCV,
    LINESPACE
};
CV_ENUM(ImplementationName, OPENCV, LINESPACE)

typedef perf::TestBaseWithParam<tuple<std::string, cv::Size, double, ImplementationName>>
    HoughLines_Photograph; // angle step in degrees
typedef perf::TestBaseWithParam<tuple<std::string, cv::Size, ImplementationName>> HoughLines_Fair;
//! Seconds each: a filter can leave them out by their name.
typedef HoughLines_Fair HoughLines_FairLarge;
typedef HoughLines_Photograph HoughLines_PhotographLarge;

//! Runs one implementation. A fifth of the shorter side as threshold: some dozens to thousands of
//! lines.
void houghLines(int implementation, const cv::Mat& edges, double theta,
                std::vector<cv::Vec2f>& lines)
{
    const int threshold = std::min(edges.cols, edges.rows) / 5;
    if (implementation == LINESPACE)
        cv::linespace::HoughLines(edges, lines, 1, theta, threshold);
    else
        cv::HoughLines(edges, lines, 1, theta, threshold);
}

//! The angle step that samples lines as finely as the Line Space does.
double fairStep(const cv::Mat& edges)
{
    return 0.5 / std::max(edges.cols, edges.rows);
}

PERF_TEST_P(HoughLines_Photograph, time,
            testing::Combine(testing::Values("building.jpg", "home.jpg"), LINESPACE_SIZES,
                             testing::Values(1.), ImplementationName::all()))
{
    const cv::Mat edges = photographEdges(get<0>(GetParam()), get<1>(GetParam()));
    std::vector<cv::Vec2f> lines;
    TEST_CYCLE() houghLines(get<3>(GetParam()), edges, get<2>(GetParam()) * CV_PI / 180, lines);
    EXPECT_FALSE(lines.empty());
    SANITY_CHECK_NOTHING();
}

PERF_TEST_P(HoughLines_PhotographLarge, fine_angles,
            testing::Combine(testing::Values("building.jpg", "home.jpg"), LINESPACE_SIZES,
                             testing::Values(0.1), ImplementationName::all()))
{
    const cv::Mat edges = photographEdges(get<0>(GetParam()), get<1>(GetParam()));
    std::vector<cv::Vec2f> lines;
    TEST_CYCLE() houghLines(get<3>(GetParam()), edges, get<2>(GetParam()) * CV_PI / 180, lines);
    EXPECT_FALSE(lines.empty());
    SANITY_CHECK_NOTHING();
}

PERF_TEST_P(HoughLines_Fair, time,
            testing::Combine(testing::Values("building.jpg", "home.jpg"),
                             testing::Values(cv::Size(64, 64), cv::Size(128, 128),
                                             cv::Size(256, 256)),
                             ImplementationName::all()))
{
    const cv::Mat edges = photographEdges(get<0>(GetParam()), get<1>(GetParam()));
    std::vector<cv::Vec2f> lines;
    TEST_CYCLE() houghLines(get<2>(GetParam()), edges, fairStep(edges), lines);
    EXPECT_FALSE(lines.empty());
    SANITY_CHECK_NOTHING();
}

PERF_TEST_P(HoughLines_FairLarge, time,
            testing::Combine(testing::Values("home.jpg"),
                             testing::Values(cv::Size(512, 512), cv::Size(1024, 1024),
                                             cv::Size(640, 480), cv::Size(1280, 720),
                                             cv::Size(1920, 1080)),
                             ImplementationName::all()))
{
    declare.time(120).iterations(3);
    const cv::Mat edges = photographEdges(get<0>(GetParam()), get<1>(GetParam()));
    std::vector<cv::Vec2f> lines;
    TEST_CYCLE() houghLines(get<2>(GetParam()), edges, fairStep(edges), lines);
    EXPECT_FALSE(lines.empty());
    SANITY_CHECK_NOTHING();
}

} // namespace
} // namespace opencv_test
