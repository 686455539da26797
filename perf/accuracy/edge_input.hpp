// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Images to what detectors are given: one edge map and one gradient for all of them.

#ifndef LINESPACE_ACCURACY_EDGE_INPUT_HPP
#define LINESPACE_ACCURACY_EDGE_INPUT_HPP

#include "detectors.hpp"

namespace accuracy {

struct EdgeSettings
{
    bool smooth;      //!< Gaussian 5 x 5, sigma 1.2, first
    double low, high; //!< thresholds of cv::Canny, aperture 3
};

//! @param image CV_8UC1.
EdgeInput edgeInput(const cv::Mat& image, const EdgeSettings& settings);

} // namespace accuracy

#endif // LINESPACE_ACCURACY_EDGE_INPUT_HPP
