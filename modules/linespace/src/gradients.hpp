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
    UMat dxOnDevice, dyOnDevice; //!< in their place, where both are on OpenCV's device

    static Gradients none();
    static Gradients of(InputArray dx, InputArray dy);

    bool areOnDevice() const { return !dxOnDevice.empty(); }
    bool areEstimated() const { return isOriented && dx.empty() && !areOnDevice(); }

    //! Brings dx and dy to the host, if they are on the device.
    Gradients onHost() const;

    /** Throws unless both are empty, or both of this size, of one of the two types, and finite;
    those on the device are looked at when their directions are found. */
    void check(Size size) const;
    //! The directions that pixels vote for (directionBits), tolerance in degrees, of gradients on the
    //! host.
    void findBits(const Mat& votes, double tolerance, EstimatedGradients& estimated,
                  Mat& bits) const;
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_GRADIENTS_HPP
