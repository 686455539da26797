// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The same test on every back end, by --perf_impl=plain, opencl or opengl, so that OpenCV's summary.py
// sets the reports of three runs beside each other.

#include "edge_maps.hpp"

namespace opencv_test {
namespace {

namespace ls = cv::linespace;

typedef perf::TestBaseWithParam<tuple<std::string, cv::Size>> Implementation_Photograph;

int selectedBackend()
{
    const std::string name = perf::TestBase::getSelectedImpl();
    return name == "opencl"   ? ls::BACKEND_OPENCL
           : name == "opengl" ? ls::BACKEND_OPENGL
                              : ls::BACKEND_CPU;
}

//! Ends the test if the back end does not run here.
void warmUp(ls::LineSpaceDetector& detector, const cv::Mat& edges)
{
    try
    {
        std::vector<cv::Vec3f> lines;
        detector.detect(edges, lines);
    }
    catch (const cv::Exception& exception)
    {
        throw cvtest::SkipTestException(exception.err);
    }
}

//! The 100 strongest lines above a fixed threshold, refined; on OpenCL of a UMat.
PERF_TEST_P(Implementation_Photograph, detect,
            testing::Combine(testing::Values("building.jpg", "home.jpg"), LINESPACE_SIZES))
{
    const cv::Mat edges = photographEdges(get<0>(GetParam()), get<1>(GetParam()));
    const cv::Ptr<ls::LineSpaceDetector> detector = ls::LineSpaceDetector::create(
        std::min(edges.cols, edges.rows) / 5, 100, ls::METHOD_CASCADED, 8, selectedBackend());
    warmUp(*detector, edges);
    cv::UMat onDevice;
    edges.copyTo(onDevice);
    std::vector<cv::Vec3f> lines;
    TEST_CYCLE()
    {
        if (selectedBackend() == ls::BACKEND_OPENCL)
            detector->detect(onDevice, lines);
        else
            detector->detect(edges, lines);
    }
    EXPECT_FALSE(lines.empty());
    EXPECT_EQ(selectedBackend(), detector->getActiveBackend());
    SANITY_CHECK_NOTHING();
}

} // namespace
} // namespace opencv_test
