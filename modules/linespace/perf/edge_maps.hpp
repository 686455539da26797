// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Edge maps of photographs, the same for every implementation that is timed.

#ifndef OPENCV_LINESPACE_PERF_EDGE_MAPS_HPP
#define OPENCV_LINESPACE_PERF_EDGE_MAPS_HPP

#include "perf_precomp.hpp"

#include <cstdlib>

namespace opencv_test {

#define LINESPACE_SIZES                                                                            \
    testing::Values(cv::Size(64, 64), cv::Size(128, 128), cv::Size(256, 256), cv::Size(512, 512),  \
                    cv::Size(1024, 1024), cv::Size(2048, 2048), cv::Size(4096, 4096),              \
                    cv::Size(640, 480), cv::Size(1280, 720), cv::Size(1920, 1080))

/** One of OpenCV's sample photographs in grey, scaled to the size. The folder is that of the
environment variable LINESPACE_SAMPLES_DATA, without which the test is skipped. */
inline cv::Mat greyPhotograph(const std::string& name, cv::Size size)
{
    const char* folder = std::getenv("LINESPACE_SAMPLES_DATA");
    if (!folder || !*folder)
        throw cvtest::SkipTestException("LINESPACE_SAMPLES_DATA is not set: no photographs");
    const cv::Mat grey = cv::imread(std::string(folder) + "/" + name, cv::IMREAD_GRAYSCALE);
    if (grey.empty())
        throw cvtest::SkipTestException("cannot read " + name + " in LINESPACE_SAMPLES_DATA");
    cv::Mat scaled;
    cv::resize(grey, scaled, size, 0, 0, cv::INTER_AREA);
    return scaled;
}

//! Its Canny edges (50/150); never an empty image.
inline cv::Mat photographEdges(const std::string& name, cv::Size size)
{
    cv::Mat edges;
    cv::Canny(greyPhotograph(name, size), edges, 50, 150);
    CV_Assert(cv::countNonZero(edges) > 0);
    return edges;
}

} // namespace opencv_test

#endif // OPENCV_LINESPACE_PERF_EDGE_MAPS_HPP
