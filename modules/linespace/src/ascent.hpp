// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// From the cascade's maxima to chords with the most exact votes (doc/algorithm.md, section 4.2).

#ifndef OPENCV_LINESPACE_ASCENT_HPP
#define OPENCV_LINESPACE_ASCENT_HPP

#include "peaks.hpp"
#include "stages.hpp"

namespace cv {
namespace linespace {

/** Counts the candidates exactly. The `climbers` strongest by the votes that they came with then
move, while one of the eight neighbours on the ring is stronger by exact votes in the total order,
to the strongest of these, `steps` times at most. Those that meet become one.
@param candidates votes of the cascade; on return exact votes, in the total order. */
void climbToExactMaxima(Executor& executor, const EdgeMap& edges, const Plan& plan, int steps,
                        size_t climbers, std::vector<Candidate>& candidates);

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_ASCENT_HPP
