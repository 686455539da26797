// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// From the table of votes to candidates (doc/algorithm.md, section 4.1): threshold, suppression of
// neighbouring chords, and the total order that makes every result unique.

#ifndef OPENCV_LINESPACE_PEAKS_HPP
#define OPENCV_LINESPACE_PEAKS_HPP

#include "stages.hpp"

#include <functional>
#include <limits>

namespace cv {
namespace linespace {

struct Candidate
{
    int votes, s, e;
    Chord chord() const
    {
        const Chord result = {s, e};
        return result;
    }
};

inline bool isSameChord(const Candidate& a, const Candidate& b)
{
    return a.s == b.s && a.e == b.e;
}

//! The total order: votes descending, then s, then e ascending.
inline bool isStronger(const Candidate& a, const Candidate& b)
{
    return a.votes != b.votes ? a.votes > b.votes : a.s != b.s ? a.s < b.s : a.e < b.e;
}

//! Which candidates are asked for.
struct Wanted
{
    int threshold; //!< more votes than this
    size_t most;   //!< only so many, the strongest in the total order
    //! Candidates that it refuses do not count; empty: it takes all.
    std::function<bool(const Candidate&)> accepts;
    //! What it asks for, for those who cannot call it: by the chord's bin (directionBin; one for all
    //! if the map is not oriented), then by its number of pixels in the image, with which it does
    //! not decrease, how many votes. Empty: none.
    std::vector<std::vector<int>> leastVotes;
    //! And that the chord is one of these (AngleEnds); null: of all.
    const std::vector<Vec4i>* ends;

    Wanted() : threshold(0), most(std::numeric_limits<size_t>::max()), ends(0) {}
};

//! A radius, but on a ring of few points: there a neighbourhood would meet itself.
int mostRadius(const Cell& frame, int radius);

//! Of the blocks of SUPPRESS_BLOCKS.
int blockSide(int radius);

//! Keeps the strongest of the wanted number, in no particular order.
void keepStrongest(std::vector<Candidate>& candidates, size_t count);

/** The chords of a table of one cell with more than the wanted votes that survive a suppression.
@param suppression one of enum Suppression. SUPPRESS_RING keeps the chords that are stronger, in the
total order, than all others (s + i, e + j), |i|, |j| <= radius, on the ring of border points; the
mirrored entry (e, s) is the same chord. SUPPRESS_BLOCKS keeps the strongest chord of each block of
[s][e], aligned at multiples of the smallest power of two of at least 2 radius + 1. SUPPRESS_GREEDY
takes the chords strongest first and deletes the ring neighbourhood of each.
@return in no particular order but the same for any number of threads. */
std::vector<Candidate> findCandidates(const VoteTable& table, const Cell& frame,
                                      const Wanted& wanted, int suppression, int radius);

//! The same for SUPPRESS_GREEDY from all chords with more than the wanted votes.
std::vector<Candidate> greedyCandidates(std::vector<Candidate> above, const Cell& frame,
                                        const Wanted& wanted, int radius);

/** The chords with more than the wanted votes that are stronger, in the total order, than the two
that run parallel to them on either side, (s + 1, e - 1) and (s - 1, e + 1): fewer are lost than by
SUPPRESS_RING where the votes are those of the cascade, which errs by more from one chord to the
next than the lines nearby differ. */
std::vector<Candidate> findParallelMaxima(const VoteTable& table, const Cell& frame,
                                          const Wanted& wanted);

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_PEAKS_HPP
