// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Exact votes of single chords and of neighbours, fast: the same numbers as chordVotes
// (stages.hpp).

#ifndef OPENCV_LINESPACE_CHORD_COUNTER_HPP
#define OPENCV_LINESPACE_CHORD_COUNTER_HPP

#include "stages.hpp"

namespace cv {
namespace linespace {

/** Counts chords of a frame on a copy of an edge map, of which pixels can be taken out. The copy is
padded to the frame, so that no chord needs clipping, and kept with x and y exchanged as well, so
that chords of any slope run along rows or across them as suits. */
class ChordCounter
{
public:
    ChordCounter() : oriented_(false), weighted_(false) {}

    //! Copies the map. Memory is kept from call to call.
    void reset(const EdgeMap& edges, const Cell& frame);
    void clear();
    //! Bytes that reset() allocates.
    static double memory(const Cell& frame, bool weighted, bool oriented);

    //! Votes of a chord of the frame; may be called from several threads at once, as countNear.
    int votes(Chord chord) const;

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

    //! Takes out an edge pixel.
    void remove(Point pixel);

private:
    //! One byte per pixel; rows of the frame's, or of its transpose's.
    struct Plane
    {
        Buffer buffer;
        ptrdiff_t stride;
        Plane() : stride(0) {}
        uchar* row(int y) const { return buffer.data() + MARGIN + y * stride; }
    };
    //! Votes where they are needed, and the low and high byte of an oriented map's bits.
    enum
    {
        VOTES,
        LOW_BITS,
        HIGH_BITS,
        PLANES
    };
    enum
    {
        MARGIN = 16 //!< of zeros around each row, for LaneMap and countParallel
    };

    bool uses(int plane) const { return plane == VOTES ? weighted_ || !oriented_ : oriented_; }
    struct ParallelWalk;
    bool startParallel(const ParallelChords& chords, ParallelWalk& walk) const;
    void countOneByOne(const ParallelChords& chords, int* votes) const;
    //! The pixels across the chords of a major axis: its columns are the plane's rows.
    const Plane* across(bool xMajor) const { return xMajor ? transposed_ : upright_; }
    int voteAcross(const Plane* planes, int column, int minor, int bin) const;
    bool countLanes(const Raster& guide, const Range& columns, const Raster* rasters,
                    const int* bins, int count, int* votes) const;

    Cell frame_;
    bool oriented_, weighted_;
    Plane upright_[PLANES], transposed_[PLANES];
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_CHORD_COUNTER_HPP
