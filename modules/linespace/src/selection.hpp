// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// From candidates with exact votes to reported lines (doc/algorithm.md, sections 4.3 to 4.5).

#ifndef OPENCV_LINESPACE_SELECTION_HPP
#define OPENCV_LINESPACE_SELECTION_HPP

#include "chord_counter.hpp"
#include "line_covariance.hpp"
#include "orientation.hpp"
#include "peaks.hpp"

#include <functional>

namespace cv {
namespace linespace {

/** What a chord must have to be reported: more votes than a number, and for the statistical rule at
least as many as its length asks for. */
struct Requirement
{
    int threshold; //!< votes must be more than this, for any chord
    //! Empty, or by the chord's bin (one for all if the map is not oriented) and its number of
    //! pixels in the image.
    std::vector<std::vector<int>> pixels;

    /** For the cascade's votes: whether the chord can meet the requirement.
    @param ratio share of the required votes that is enough, 0 to 1. Weights are at least 1, so
    weighted votes are never fewer than the pixels that the statistical rule asks for. */
    bool canBeMet(const Plan& plan, const Candidate& candidate, double ratio) const
    {
        return candidate.votes > cvFloor(ratio * threshold) &&
               (pixels.empty() || candidate.votes >= ratio * pixelsNeeded(plan, candidate));
    }

    //! For exact votes. The statistical rule counts pixels, whatever their weights.
    bool isMet(const EdgePlanes& planes, const Plan& plan, const Candidate& candidate) const
    {
        if (!canBeMet(plan, candidate, 1))
            return false;
        return pixels.empty() || !planes.isWeighted() ||
               ChordCounter(planes).pixels(candidate.chord()) >= pixelsNeeded(plan, candidate);
    }

private:
    int pixelsNeeded(const Plan& plan, const Candidate& candidate) const
    {
        const Chord chord = candidate.chord();
        const int bin = pixels.size() > 1 ? directionBin(plan.frame(), chord) : 0;
        return pixels[bin][plan.visibleLength(chord)];
    }
};

//! A line that was taken: its chord with exact votes, and the line to report, refined or not.
struct Selected
{
    Candidate candidate;
    FittedLine fitted;
};

//! How lines are chosen among the candidates.
struct SelectionRule
{
    Requirement requirement;
    bool explain;    //!< SELECT_EXPLAIN
    double distance; //!< within which a line is a duplicate, pixels
    size_t most;     //!< lines to take
    //! The line to report for a chord; called from several threads at once.
    std::function<FittedLine(Chord)> refine;
};

/** Takes the candidates in the total order and drops those whose two ends inside the image, before
or after the refinement, are both within rule.distance of a line taken before; at most rule.most
lines.

With rule.explain, the edge pixels along a line taken do not vote for the lines after it: the next
line is the one with the most of the pixels that are left, and it must still meet the requirement.
@param candidates with exact votes.
@param planes of the map; with rule.explain, what is explained is taken out of them.
@return in the total order of their votes among all edge pixels. */
std::vector<Selected> selectLines(const Plan& plan, const SelectionRule& rule,
                                  const std::vector<Candidate>& candidates, EdgePlanes& planes);

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_SELECTION_HPP
