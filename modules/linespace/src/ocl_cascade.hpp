// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The OpenCL path: the stages on the device that OpenCV uses.

#ifndef OPENCV_LINESPACE_OCL_CASCADE_HPP
#define OPENCV_LINESPACE_OCL_CASCADE_HPP

#include "stages.hpp"

namespace cv {
namespace linespace {

//! Whether OpenCV uses an OpenCL device, in this thread.
bool isOpenClActive();

//! Its executor throws DeviceFailure where the device cannot do what is asked for.
Ptr<Executor> createOpenClExecutor();

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_OCL_CASCADE_HPP
