// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// What a line must have to be reported: a number of votes, or what chance would hardly give
// (doc/algorithm.md, section 7).

#ifndef OPENCV_LINESPACE_REQUIREMENT_HPP
#define OPENCV_LINESPACE_REQUIREMENT_HPP

#include "chord_counter.hpp"
#include "orientation.hpp"
#include "peaks.hpp"

namespace cv {
namespace linespace {

/** What a chord must have to be reported: more votes than a number, and for the statistical rule at
least as many as its length asks for. */
struct Requirement
{
    int threshold; //!< votes must be more than this, for any chord
    //! Empty, or by the chord's bin (one for all if the map is not oriented) and its number of
    //! pixels in the image, with which it does not decrease.
    std::vector<std::vector<int>> pixels;

    /** For the cascade's votes: whether the chord can meet the requirement.
    @param ratio share of the required votes that is enough, 0 to 1. Weights are at least 1, so
    weighted votes are never fewer than the pixels that the statistical rule asks for. */
    bool canBeMet(const Plan& plan, const Candidate& candidate, double ratio) const
    {
        if (candidate.votes <= cvFloor(ratio * threshold))
            return false;
        if (pixels.empty())
            return true;
        // Bounds of the chord's length decide on nearly all.
        const Chord chord = candidate.chord();
        const std::vector<int>& needed = pixelsFor(plan, chord);
        const int most = std::min(plan.mostVisibleLength(chord), (int)needed.size() - 1);
        int least;
        plan.leastVisibleLengths(chord.s, chord.e, 1, 1, 0, &least);
        if (candidate.votes < ratio * needed[least])
            return false;
        return candidate.votes >= ratio * needed[most] ||
               candidate.votes >= ratio * needed[plan.visibleLength(chord)];
    }

    //! `pixels` times the ratio: with fewer votes canBeMet() is false, with more than the threshold
    //! and at least as many it is true.
    std::vector<std::vector<int>> leastVotes(double ratio) const;

    //! For exact votes. The statistical rule counts pixels, whatever their weights.
    bool isMet(const EdgePlanes& planes, const Plan& plan, const Candidate& candidate) const
    {
        if (!canBeMet(plan, candidate, 1))
            return false;
        return pixels.empty() || !planes.isWeighted() ||
               ChordCounter(planes).pixels(candidate.chord()) >=
                   pixelsNeeded(plan, candidate.chord());
    }

private:
    const std::vector<int>& pixelsFor(const Plan& plan, Chord chord) const
    {
        return pixels[pixels.size() > 1 ? directionBin(plan.frame(), chord) : 0];
    }
    int pixelsNeeded(const Plan& plan, Chord chord) const
    {
        return pixelsFor(plan, chord)[plan.visibleLength(chord)];
    }
};

//! More votes than the threshold, whatever the chord.
Requirement moreVotesThan(int threshold);

/** The statistical rule: on average, chance gives fewer than falseAlarms lines.
@param pixels of the image that could vote; a chord's length counts the others as well, which is on
the safe side. */
Requirement significance(const EdgeMap& edges, double pixels, const Plan& plan, double falseAlarms);

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_REQUIREMENT_HPP
