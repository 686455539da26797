// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Sub-pixel lines from the gradients around an edge (doc/algorithm.md, section 5.2).

#ifndef OPENCV_LINESPACE_EDGE_PROFILE_HPP
#define OPENCV_LINESPACE_EDGE_PROFILE_HPP

#include "line_covariance.hpp"

namespace cv {
namespace linespace {

/** Where the gradients of the map along a line have their maxima.

Each column of the line with a supporting edge pixel gives the gradients' components along the
line's normal, of the sign that the edge has there, at the pixels within three pixels of the line,
weighted by how near they are. The line is moved until their weighted distances and the products of
these with the column sum up to 0.
@param edges with gradients.
@param planes of the same map.
@param bin as for refineLine.
@param fitted keeps the covariance of the given line where the columns do not determine another.
@return false if that does not end, or fewer than half of the columns that support the line have
gradients. */
bool fitGradients(const EdgeMap& edges, const EdgePlanes& planes, int bin, const FittedLine& line,
                  FittedLine& fitted);

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_EDGE_PROFILE_HPP
