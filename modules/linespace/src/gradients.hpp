// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The gradients that a user gives, or asks to estimate.

#ifndef OPENCV_LINESPACE_GRADIENTS_HPP
#define OPENCV_LINESPACE_GRADIENTS_HPP

#include "orientation.hpp"

namespace cv {
namespace linespace {

/** Whose directions vote; none for a map that is not oriented. Empty gradients are estimated from
the edge map. */
struct Gradients
{
    bool isOriented;
    Mat dx, dy;

    //! Throws unless both are empty, or both of this size, of one of the two types, and finite.
    void check(Size size) const;
    //! The directions that pixels vote for (directionBits), tolerance in degrees.
    void findBits(const Mat& votes, double tolerance, EstimatedGradients& estimated,
                  Mat& bits) const;
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_GRADIENTS_HPP
