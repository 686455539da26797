// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The directions that edge pixels vote for, on an OpenCL device: what directionBits finds on the
// host.

#ifndef OPENCV_LINESPACE_OCL_DIRECTIONS_HPP
#define OPENCV_LINESPACE_OCL_DIRECTIONS_HPP

#include "ocl_launch.hpp"

namespace cv {
namespace linespace {

//! Keeps its buffers between calls.
class DeviceDirections
{
public:
    /** As directionBits, of gradients on the device of one of its types; whether they are finite, read()
    tells. The result is valid until the next call. */
    UMat find(const DevicePixels& votes, const UMat& dx, const UMat& dy, double tolerance);

    //! The same, of gradients that are estimated from the map.
    UMat estimate(const DevicePixels& votes, double tolerance);

    //! Reads what votes with the directions that were found last, and gradients, if they are not
    //! empty; all at once.
    void read(const DevicePixels& votes, const UMat& dx, const UMat& dy, OrientedPixels& pixels);

private:
    void clearWrong();

    UMat bits_, slopes_;
    UMat pixels_; //!< what read() reads; begins with whether a gradient is not finite
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_OCL_DIRECTIONS_HPP
