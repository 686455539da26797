// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// For which directions a pixel votes (doc/algorithm.md, section 6), for the naive cascade.

#ifndef LINESPACE_CASCADE_DIRECTIONS_HPP
#define LINESPACE_CASCADE_DIRECTIONS_HPP

#include "opencv2/core.hpp"

namespace cascade {

//! The bin, 0 to 15, of a direction of either sign; not of (0, 0).
int directionBin(cv::Point direction);

/** The bits of the bins that each pixel votes for: all for an edge pixel if the gradients are empty.
The tolerance is the detector's default, 22.5 degrees. */
cv::Mat1w votersOf(const cv::Mat1b& edges, const cv::Mat1s& dx = {}, const cv::Mat1s& dy = {});

} // namespace cascade

#endif // LINESPACE_CASCADE_DIRECTIONS_HPP
