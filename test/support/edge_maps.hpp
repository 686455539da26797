// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Edge maps that several programs compare or measure on: photographs through the Canny detector,
// and noise. The same on every machine with the same version of OpenCV.

#ifndef LINESPACE_SUPPORT_EDGE_MAPS_HPP
#define LINESPACE_SUPPORT_EDGE_MAPS_HPP

#include <stdexcept>
#include <string>

#include "opencv2/core.hpp"

namespace support {

//! An image that the caller asked for is not there; what() names it and says why.
struct MissingImage : std::runtime_error
{
    using std::runtime_error::runtime_error;
};

struct CannyThresholds
{
    double low = 50, high = 150;
};

//! The photograph in shades of grey; an empty folder is one that nobody gave.
cv::Mat1b readPhotograph(const std::string& folder, const std::string& name);

//! Scales to the size first; an empty size is the photograph's own.
cv::Mat1b scaled(const cv::Mat1b& photograph, cv::Size size);
cv::Mat1b cannyEdges(const cv::Mat1b& photograph, CannyThresholds thresholds = {});

//! Independent edge pixels.
cv::Mat1b randomEdges(cv::Size size, double density, unsigned seed);

} // namespace support

#endif // LINESPACE_SUPPORT_EDGE_MAPS_HPP
