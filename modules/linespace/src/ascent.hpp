// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// From the cascade's maxima to chords with the most exact votes (doc/algorithm.md, section 4.2).

#ifndef OPENCV_LINESPACE_ASCENT_HPP
#define OPENCV_LINESPACE_ASCENT_HPP

#include "chord_counter.hpp"
#include "peaks.hpp"

namespace cv {
namespace linespace {

/** Moves candidates to maxima of the exact votes: to the first stronger chord, in the total order,
of the (2 radius + 1)^2 ring neighbourhood, the nearest looked at first, and so on until there is
none.
@param candidates with exact votes; on return, in the total order, the maxima that they came to, each
once. */
void climbToMaxima(const ChordCounter& counter, const Cell& frame, int radius,
                   std::vector<Candidate>& candidates);

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_ASCENT_HPP
