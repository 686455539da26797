// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Exact votes of single chords and of neighbours, fast: the same numbers as chordVotes
// (stages.hpp).

#ifndef OPENCV_LINESPACE_CHORD_COUNTER_HPP
#define OPENCV_LINESPACE_CHORD_COUNTER_HPP

#include "edge_planes.hpp"

namespace cv {
namespace linespace {

//! Counts chords of a frame on planes, which must outlive it.
class ChordCounter
{
public:
    explicit ChordCounter(const EdgePlanes& planes) : planes_(planes), frame_(planes.frame()) {}

    //! Votes of a chord of the frame; may be called from several threads at once, as countSquare.
    int votes(Chord chord) const;
    //! The number of edge pixels that vote for it, whatever their weights.
    int pixels(Chord chord) const;

    enum
    {
        SQUARE = 8,
        PARALLEL = 16 //!< parallel chords that are counted like one, without AVX2
    };
    /** Votes of chords near one another, (first.s + i, first.e + j), i, j = 0 to SQUARE - 1: writes
    votes[i SQUARE + j] where that bit of `wanted` is set, which must be chords between the sides
    of `first`, s < e. With AVX2, for chords of up to 8192 pixels, 32 take a little more than the
    time of one; else those of each diagonal that are between opposite sides. */
    void countSquare(Chord first, uint64 wanted, int* votes) const;
    //! How many of a square take the time of one, however they lie.
    static int together();

private:
    void countDiagonals(Chord first, uint64 wanted, int* votes) const;
    bool countParallel(Chord chord, int* votes) const;
    int voteAcross(const EdgePlanes::Plane* planes, int column, int minor, int bin) const;

    const EdgePlanes& planes_;
    const Cell frame_;
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_CHORD_COUNTER_HPP
