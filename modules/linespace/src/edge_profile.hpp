// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Sub-pixel lines from the gradients around an edge (doc/algorithm.md, section 5.2).

#ifndef OPENCV_LINESPACE_EDGE_PROFILE_HPP
#define OPENCV_LINESPACE_EDGE_PROFILE_HPP

#include "line_covariance.hpp"

namespace cv {
namespace linespace {

/** The gradients as fitGradients reads them: CV_16SC2 (dx, dy), at most 2^12 in size each. CV_16S
is shifted right, rounding down, if a component is larger; CV_32F is multiplied by the power of two that takes
the largest component of the image to [2^11, 2^12), and rounded to the nearest integers. */
Mat profileGradients(const Mat& dx, const Mat& dy);

/** Where the gradients along a line have their maxima.

Each column of the line with a supporting edge pixel within a pixel of the line gives the gradients'
components along the line's normal, of the sign that the edge has there, at the pixels within three
pixels of the line, weighted by how near they are. The line is moved until their weighted distances
and the products of these with the column sum up to 0.
@param gradients from profileGradients.
@param bit as for refineLine.
@return false if that does not end, or too few columns support the line. */
bool fitGradients(const EdgeMap& edges, const Mat& gradients, ushort bit, const Line& line,
                  FittedLine& fitted);

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_EDGE_PROFILE_HPP
