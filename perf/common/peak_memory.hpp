// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Peak memory of a call.

#ifndef LINESPACE_MEASURE_PEAK_MEMORY_HPP
#define LINESPACE_MEASURE_PEAK_MEMORY_HPP

#include <functional>

namespace measure {

/** The rise of the peak of resident memory by one call, in KiB, in a child process that does nothing
else. A child of fork has no other threads: set cv::setNumThreads(1) first. */
long riseOfPeakMemory(const std::function<void()>& work);

} // namespace measure

#endif // LINESPACE_MEASURE_PEAK_MEMORY_HPP
