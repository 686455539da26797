// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The OpenGL path: the stages as compute shaders, in the caller's context or in one without a
// window.

#ifndef OPENCV_LINESPACE_GL_CASCADE_HPP
#define OPENCV_LINESPACE_GL_CASCADE_HPP

#include "stages.hpp"

namespace cv {
namespace linespace {

/** Throws DeviceFailure where there is no OpenGL 4.3 or OpenGL ES 3.1; its executor does where they
cannot do what is asked for. */
Ptr<Executor> createOpenGlExecutor();

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_GL_CASCADE_HPP
