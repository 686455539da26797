// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Executors of devices between calls of functions that have no object to keep them: programs,
// tables of an image size and buffers are there for the next call, whichever thread it comes from.

#ifndef OPENCV_LINESPACE_EXECUTOR_POOL_HPP
#define OPENCV_LINESPACE_EXECUTOR_POOL_HPP

#include "backends.hpp"

namespace cv {
namespace linespace {

//! One of a back end that was given back and can run in this thread's context, or an empty one; it
//! is the caller's alone.
Ptr<Executor> takeExecutor(int backend);

//! Keeps the executor of a device for a later call, without the map that it counted. One whose call
//! threw is better dropped.
void giveExecutor(const Ptr<Executor>& executor);

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_EXECUTOR_POOL_HPP
