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

    //! Votes of a chord of the frame; may be called from several threads at once, as countNear.
    int votes(Chord chord) const;
    //! The number of edge pixels that vote for it, whatever their weights.
    int pixels(Chord chord) const;

    //! Chords that are counted together at most.
    enum
    {
        MOST_NEAR = 32
    };
    /** Votes of chords whose ends are within two border points of those of `middle`, in either
    order; with AVX2, for chords of up to 8000 pixels, a little more than the time of one for all,
    else one after the other. `middle` need not be one of them. */
    void countNear(Chord middle, const Chord* chords, int count, int* votes) const;

    enum
    {
        PARALLEL = 16,    //!< chords that are counted like one
        MOST_PARALLEL = 8 //!< such groups at once
    };
    /** The chords (s + i, e - i), i = -before to PARALLEL - 1 - before, of one between opposite
    sides, s < e. They are parallel, and their rasters are the chord's, shifted by i pixels. */
    struct ParallelChords
    {
        Chord chord;
        int before;
    };
    /** PARALLEL votes for each of some groups, best near one another. What is said of chords that
    would leave the two sides has no meaning. */
    void countParallel(const ParallelChords* chords, int count, int* votes) const;

private:
    struct ParallelWalk;
    bool startParallel(const ParallelChords& chords, ParallelWalk& walk) const;
    void countOneByOne(const ParallelChords& chords, int* votes) const;
    int voteAcross(const EdgePlanes::Plane* planes, int column, int minor, int bin) const;
    bool countLanes(const Raster& guide, const Range& columns, const Raster* rasters,
                    const int* bins, int count, int* votes) const;

    const EdgePlanes& planes_;
    const Cell frame_;
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_CHORD_COUNTER_HPP
