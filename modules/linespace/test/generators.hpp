// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Edge maps for tests and measurements: CV_8UC1, the same on every machine for the same arguments.

#ifndef OPENCV_LINESPACE_TEST_GENERATORS_HPP
#define OPENCV_LINESPACE_TEST_GENERATORS_HPP

#include "opencv2/core.hpp"

namespace opencv_test {
namespace generators {

//! Independent edge pixels; their values are random in 1 .. 255, as any value but 0 is an edge.
cv::Mat1b randomEdges(const cv::Size& size, double density, unsigned seed);
cv::Mat1b whiteEdges(const cv::Size& size);
cv::Mat1b onePixel(const cv::Size& size, const cv::Point& pixel);

//! A straight line across the image by its real coefficients, one pixel for each column or row.
void addLine(cv::Mat1b& edges, double rho, double theta);
//! Lines that keep at least `margin` pixels and a sixth of a turn or 12 pixels from each other,
//! over noise.
cv::Mat1b linesInNoise(const cv::Size& size, int count, double noise, unsigned seed,
                       std::vector<cv::Vec2d>& lines);

//! The same map as a window of a larger white image: not contiguous, and reading outside it shows.
cv::Mat asWindow(const cv::Mat& edges);

/** Edges of one of OpenCV's sample photographs (building.jpg, ...), scaled to at most maxSide
pixels. The folder is that of the environment variable LINESPACE_SAMPLES_DATA. Without it the
calling test is skipped. */
cv::Mat1b photographEdges(const std::string& name, int maxSide);

} // namespace generators
} // namespace opencv_test

#endif // OPENCV_LINESPACE_TEST_GENERATORS_HPP
