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

//! Photograph, size, angle step in degrees, implementation.
typedef tuple<std::string, cv::Size, double, ImplementationName> HoughParameters;
typedef perf::TestBaseWithParam<HoughParameters> HoughLines_Photograph;

PERF_TEST_P(HoughLines_Photograph, time,
            testing::Combine(testing::Values("building.jpg", "home.jpg"),
                             testing::Values(cv::Size(64, 64), cv::Size(128, 128),
                                             cv::Size(256, 256), cv::Size(512, 512),
                                             cv::Size(1024, 1024), cv::Size(640, 480),
                                             cv::Size(1280, 720), cv::Size(1920, 1080)),
                             testing::Values(1., 0.1), ImplementationName::all()))
{
    const cv::Mat edges = photographEdges(get<0>(GetParam()), get<1>(GetParam()));
    const double theta = get<2>(GetParam()) * CV_PI / 180;
    const bool ours = get<3>(GetParam()) == LINESPACE;
    // A fifth of the shorter side: some dozens to thousands of lines.
    const int threshold = std::min(edges.cols, edges.rows) / 5;
    std::vector<cv::Vec2f> lines;
    TEST_CYCLE()
    {
        if (ours)
            cv::linespace::HoughLines(edges, lines, 1, theta, threshold);
        else
            cv::HoughLines(edges, lines, 1, theta, threshold);
    }
    EXPECT_FALSE(lines.empty());
    SANITY_CHECK_NOTHING();
}

} // namespace
} // namespace opencv_test
