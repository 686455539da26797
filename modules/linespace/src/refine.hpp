// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Sub-pixel lines from the edge pixels along a chord (doc/algorithm.md, section 5).

#ifndef OPENCV_LINESPACE_REFINE_HPP
#define OPENCV_LINESPACE_REFINE_HPP

#include "line_covariance.hpp"

namespace cv {
namespace linespace {

/** The line of a chord as it is: what is known of it is that its ends are within half a border
edge. */
FittedLine chordLine(const Cell& frame, Chord chord);

/** Sub-pixel position of the line of a chord.

Total least squares on the edge pixels within one pixel of the line, repeated with the pixels of the
new line until they stay the same, ten times at most; then, where the map has gradients,
fitGradients from there. The pixels are those within three pixels of the chord's line, collected
once. Either step moves the ends of the chord's line inside the image by less than a pixel: a result
that is farther away is approached as far as that, one of more than two pixels is left out.
@param planes of the same map.
@param bin of the line's chord: of an oriented map, only pixels that carry its bit count.
@return the given line if neither step determines one. */
FittedLine refineLine(const EdgeMap& edges, const EdgePlanes& planes, int bin,
                      const FittedLine& line);

class EdgeBits; // edge_bits.hpp

//! The same of a map that is not oriented and has no gradients.
FittedLine refineLine(Size image, const EdgeBits& bits, const FittedLine& line);

//! The edge pixels that a line explains: those within two pixels of it that carry the bin's bit.
std::vector<Point> explainedPixels(const EdgePlanes& planes, Size image, int bin, const Line& line);

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_REFINE_HPP
