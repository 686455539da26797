// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Which back end runs.

#ifndef OPENCV_LINESPACE_BACKENDS_HPP
#define OPENCV_LINESPACE_BACKENDS_HPP

#include "stages.hpp"

namespace cv {
namespace linespace {

/** The executor of a back end.
@param backend one of enum Backend. BACKEND_AUTO takes the process-wide default where it can run,
else the CPU path.
@param kept an executor from an earlier call, returned again if it is of the right kind; may be
empty. Throws cv::Exception with the reason if a back end that was named cannot run. */
Ptr<Executor> executorFor(int backend, const Ptr<Executor>& kept);

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_BACKENDS_HPP
