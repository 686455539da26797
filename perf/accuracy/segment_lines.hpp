// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Lines from the segments of a segment detector.

#ifndef LINESPACE_ACCURACY_SEGMENT_LINES_HPP
#define LINESPACE_ACCURACY_SEGMENT_LINES_HPP

#include "detectors.hpp"

namespace accuracy {

/** Fits lines to segments. The longest segment that is left begins a line; all whose two ends are
within 2 pixels of it join, and the line is fitted to them by total least squares, each segment
weighted by its length, twice. Segments shorter than 20 pixels begin no line.
@param segments x1, y1, x2, y2 in pixels.
@return strongest first; votes are the summed lengths in pixels. */
std::vector<DetectedLine> fittedLines(const std::vector<cv::Vec4f>& segments);

} // namespace accuracy

#endif // LINESPACE_ACCURACY_SEGMENT_LINES_HPP
