// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// From candidates with exact votes to reported lines (doc/algorithm.md, sections 4.3 to 4.5).

#ifndef OPENCV_LINESPACE_SELECTION_HPP
#define OPENCV_LINESPACE_SELECTION_HPP

#include "line_covariance.hpp"
#include "requirement.hpp"

#include <functional>

namespace cv {
namespace linespace {

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
