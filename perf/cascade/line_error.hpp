// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The distance between two lines of an image.

#ifndef LINESPACE_CASCADE_LINE_ERROR_HPP
#define LINESPACE_CASCADE_LINE_ERROR_HPP

#include <vector>

#include "opencv2/core.hpp"

namespace cascade {

/** Line error in pixels: the largest orthogonal distance from the two points where the true line
enters and leaves the image to the other line.
@param ends (x1, y1, x2, y2) of the true line, as of cv::linespace::lineEndPoints.
@param line (rho, theta, votes). */
double lineError(const cv::Vec4f& ends, const cv::Vec3f& line);

//! The smallest line error of the first `count` of the lines; infinite if there are none.
double leastError(const cv::Vec4f& ends, const std::vector<cv::Vec3f>& lines, std::size_t count);

//! How many of the true lines have one of the first `count` lines within SAME_LINE.
int countFound(const std::vector<cv::Vec4f>& ends, const std::vector<cv::Vec3f>& lines,
               std::size_t count);

//! Two lines are the same one if their line error is at most so many pixels.
constexpr double SAME_LINE = 1.5;

} // namespace cascade

#endif // LINESPACE_CASCADE_LINE_ERROR_HPP
