// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The pictures that the program makes.

#ifndef LINESPACE_SAMPLES_DRAW_HPP
#define LINESPACE_SAMPLES_DRAW_HPP

#include <string>
#include <vector>

#include "opencv2/core.hpp"

namespace program {

//! A photograph with lines across it, each with a dark seam so that it shows on any ground.
cv::Mat drawOver(const cv::Mat& colors, const std::vector<cv::Vec3f>& lines,
                 const cv::Scalar& color);

//! Two pictures of one size side by side, each with a caption below.
cv::Mat sideBySide(const cv::Mat& left, const std::string& leftCaption, const cv::Mat& right,
                   const std::string& rightCaption);

//! A table of votes as a grey picture: black is 0, white the largest entry.
cv::Mat lineSpacePicture(const cv::Mat& table);

extern const cv::Scalar ourColor, theirColor;

} // namespace program

#endif // LINESPACE_SAMPLES_DRAW_HPP
