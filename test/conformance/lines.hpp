// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The words that the conformance test is written in.

#ifndef LINESPACE_CONFORMANCE_LINES_HPP
#define LINESPACE_CONFORMANCE_LINES_HPP

#include <vector>

#include "opencv2/core.hpp"

namespace conformance {

//! (rho, theta, votes)
using Lines = std::vector<cv::Vec3f>;

//! The arguments of HoughLines, in pixels and radians.
struct Arguments
{
    double rho = 1, theta = CV_PI / 180;
    double minTheta = 0, maxTheta = CV_PI;
    bool weighted = false; //!< use_edgeval
};

} // namespace conformance

#endif // LINESPACE_CONFORMANCE_LINES_HPP
