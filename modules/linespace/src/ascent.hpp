// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// From the cascade's maxima to chords with the most exact votes (doc/algorithm.md, section 4.2).

#ifndef OPENCV_LINESPACE_ASCENT_HPP
#define OPENCV_LINESPACE_ASCENT_HPP

#include "vote_squares.hpp"

namespace cv {
namespace linespace {

enum
{
    MAX_ASCENT_RADIUS = 2 //!< a larger neighbourhood costs more counts than it finds lines
};

/** Moves candidates to maxima of the exact votes: to the strongest chord in the total order of the
(2 radius + 1)^2 ring neighbourhood, and so on until none is stronger.
@param radius 1 to MAX_ASCENT_RADIUS.
@param squares of the frame's planes, reset.
@param candidates with any votes; on return, in the total order, the maxima that they came to, each
once, with exact votes. */
void climbToMaxima(const Cell& frame, int radius, VoteSquares& squares,
                   std::vector<Candidate>& candidates);

//! Bytes that this takes for so many candidates, 0: for any number, but for the candidates; of a
//! plain map, without weights and directions, or of others.
double ascentMemory(const Cell& frame, bool isPlain, double candidates);

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_ASCENT_HPP
