// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Exact votes of chords between opposite sides, counted when they are asked for, by strips of
// parallel ones. The longest chords are of this kind, so most candidates are.

#ifndef OPENCV_LINESPACE_VOTE_STRIPS_HPP
#define OPENCV_LINESPACE_VOTE_STRIPS_HPP

#include "chord_counter.hpp"

namespace cv {
namespace linespace {

/** A chord between opposite sides has the positions u of s and v of e along these sides, 0 to their
length - 1. Those with equal u - v are parallel; a strip is PARALLEL of these, u from a multiple of
PARALLEL on. */
class VoteStrips
{
public:
    //! Forgets all votes.
    void reset(const Cell& frame);
    void clear();
    //! Bytes kept, besides those of the strips that were counted.
    static double memory(const Cell& frame);
    //! Bytes of so many strips, or of all there are.
    static double stripMemory(const Cell& frame, double strips);

    //! Whether all chords (s + i, e + j), |i|, |j| <= radius, are in strips; s < e.
    bool hasNeighbourhood(Chord chord, int radius) const;

    //! Asks for the strips of such a neighbourhood; not thread-safe.
    void want(Chord chord, int radius);
    //! Counts what is wanted, in parallel.
    void countWanted(const ChordCounter& counter);

    /** Calls visit(votes, s, e) for a neighbourhood that was counted; may be called from several
    threads at once. */
    template<class Visit>
    void forEachAround(Chord chord, int radius, Visit visit) const
    {
        const Place place = placeOf(chord);
        for (int i = -radius; i <= radius; ++i)
            for (int j = -radius; j <= radius; ++j)
            {
                const int u = place.u + i;
                const int slot = slots_[stripOf(place, u, i + j)];
                CV_DbgAssert(slot >= 0);
                visit(votes_[(size_t)slot * ChordCounter::PARALLEL + u % ChordCounter::PARALLEL],
                      chord.s + i, chord.e + j);
            }
    }

private:
    //! A pair of opposite sides: top and bottom, or right and left.
    struct Pair
    {
        int length, blocks;
        size_t firstStrip;
        int firstS, lastE; //!< the border points with u = 0 and with v = 0
    };
    struct Place
    {
        const Pair* pair;
        int u, family; //!< family: u - v + length - 1
    };

    Place placeOf(Chord chord) const
    {
        const Pair& pair = pairs_[chord.s >= pairs_[1].firstS];
        const Place place = {&pair, chord.s - pair.firstS,
                             chord.s - pair.firstS - (pair.lastE - chord.e) + pair.length - 1};
        return place;
    }
    static size_t stripOf(const Place& place, int u, int familyOffset)
    {
        return place.pair->firstStrip + (size_t)(place.family + familyOffset) * place.pair->blocks +
               u / ChordCounter::PARALLEL;
    }
    ChordCounter::ParallelChords chordsOf(size_t strip) const;

    Cell frame_;
    Pair pairs_[2];
    std::vector<int> slots_; //!< of each strip, where its votes stand; -1: not counted
    std::vector<size_t> wanted_;
    std::vector<int> votes_;
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_VOTE_STRIPS_HPP
