// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// What is a local maximum of votes on the ring of border points (doc/algorithm.md, section 4.1),
// wherever the votes are kept: votes(p, q) gives those of any two border points, in either order,
// and
// 0 for two on one side.

#ifndef OPENCV_LINESPACE_RING_MAXIMA_HPP
#define OPENCV_LINESPACE_RING_MAXIMA_HPP

#include "peaks.hpp"

namespace cv {
namespace linespace {

//! Whether the chord of two border points, which may be beyond the ring's ends, is stronger.
template<class VotesOf>
bool isStrongerAt(const VotesOf& votes, const Cell& frame, int p, int q, const Candidate& candidate)
{
    const int points = frame.borderCount();
    p = p < 0 ? p + points : p >= points ? p - points : p;
    q = q < 0 ? q + points : q >= points ? q - points : q;
    const Candidate other = {votes(p, q), std::min(p, q), std::max(p, q)};
    return isStronger(other, candidate);
}

template<class VotesOf>
bool isRingMaximum(const VotesOf& votes, const Cell& frame, const Candidate& candidate, int radius)
{
    for (int i = -radius; i <= radius; ++i)
        for (int j = -radius; j <= radius; ++j)
            if (isStrongerAt(votes, frame, candidate.s + i, candidate.e + j, candidate))
                return false;
    return true;
}

template<class VotesOf>
bool isParallelMaximum(const VotesOf& votes, const Cell& frame, const Candidate& candidate)
{
    return !isStrongerAt(votes, frame, candidate.s + 1, candidate.e - 1, candidate) &&
           !isStrongerAt(votes, frame, candidate.s - 1, candidate.e + 1, candidate);
}

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_RING_MAXIMA_HPP
