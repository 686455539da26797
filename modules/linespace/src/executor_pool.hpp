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

struct PooledExecutor
{
    Ptr<Executor> executor; //!< may be empty
    Ptr<VoteTables> tables; //!< for votes that it counts
};

//! One of a back end that was given back and can run in this thread's context, or none, and tables
//! in any case; it is the caller's alone.
PooledExecutor takeExecutor(int backend);

//! Keeps the executor of a device for a later call, and its tables, if they are not very large. One
//! whose call threw is better dropped.
void giveExecutor(const PooledExecutor& pooled);

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_EXECUTOR_POOL_HPP
