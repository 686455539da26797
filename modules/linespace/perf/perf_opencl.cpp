// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// cv::UMat in, beside cv::HoughLines on it. Each cycle waits for the device.

#include "edge_maps.hpp"

#include "opencv2/ts/ocl_perf.hpp"

namespace opencv_test {
namespace ocl {

namespace ls = cv::linespace;

typedef ::perf::TestBaseWithParam<tuple<std::string, cv::Size>> LinespacePhotograph;

#define LINESPACE_PHOTOGRAPHS                                                                      \
    testing::Combine(testing::Values("building.jpg", "home.jpg"), LINESPACE_SIZES)

static UMat onDevice(const Mat& edges)
{
    UMat result;
    edges.copyTo(result);
    return result;
}

//! The 100 strongest lines above a fixed threshold, refined.
OCL_PERF_TEST_P(LinespacePhotograph, detect, LINESPACE_PHOTOGRAPHS)
{
    const UMat edges = onDevice(photographEdges(get<0>(GetParam()), get<1>(GetParam())));
    const Ptr<ls::LineSpaceDetector> detector =
        ls::LineSpaceDetector::create(std::min(edges.cols, edges.rows) / 5, 100);
    UMat lines;
    OCL_TEST_CYCLE() detector->detect(edges, lines);
    EXPECT_FALSE(lines.empty());
    SANITY_CHECK_NOTHING();
}

//! A detector's first image.
OCL_PERF_TEST_P(LinespacePhotograph, detect_first, LINESPACE_PHOTOGRAPHS)
{
    const UMat edges = onDevice(photographEdges(get<0>(GetParam()), get<1>(GetParam())));
    const int threshold = std::min(edges.cols, edges.rows) / 5;
    UMat lines;
    OCL_TEST_CYCLE() ls::LineSpaceDetector::create(threshold, 100)->detect(edges, lines);
    EXPECT_FALSE(lines.empty());
    SANITY_CHECK_NOTHING();
}

//! The whole table, of up to 140 MiB.
OCL_PERF_TEST_P(LinespacePhotograph, compute,
                testing::Combine(testing::Values("building.jpg"),
                                 testing::Values(Size(512, 512), Size(1024, 1024), Size(640, 480),
                                                 Size(1920, 1080))))
{
    const UMat edges = onDevice(photographEdges(get<0>(GetParam()), get<1>(GetParam())));
    const Ptr<ls::LineSpaceDetector> detector = ls::LineSpaceDetector::create();
    UMat table;
    OCL_TEST_CYCLE() detector->compute(edges, table);
    EXPECT_FALSE(table.empty());
    SANITY_CHECK_NOTHING();
}

OCL_PERF_TEST_P(LinespacePhotograph, cv_HoughLines, LINESPACE_PHOTOGRAPHS)
{
    const UMat edges = onDevice(photographEdges(get<0>(GetParam()), get<1>(GetParam())));
    UMat lines;
    OCL_TEST_CYCLE()
    cv::HoughLines(edges, lines, 1, CV_PI / 180, std::min(edges.cols, edges.rows) / 5);
    EXPECT_FALSE(lines.empty());
    SANITY_CHECK_NOTHING();
}

OCL_PERF_TEST_P(LinespacePhotograph, HoughLines, LINESPACE_PHOTOGRAPHS)
{
    const UMat edges = onDevice(photographEdges(get<0>(GetParam()), get<1>(GetParam())));
    UMat lines;
    OCL_TEST_CYCLE()
    ls::HoughLines(edges, lines, 1, CV_PI / 180, std::min(edges.cols, edges.rows) / 5);
    EXPECT_FALSE(lines.empty());
    SANITY_CHECK_NOTHING();
}

} // namespace ocl
} // namespace opencv_test
