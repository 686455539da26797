// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// What is asked of a list of lines: that it holds another list's, each once, with honest votes.

#ifndef LINESPACE_CONFORMANCE_COMPARISON_HPP
#define LINESPACE_CONFORMANCE_COMPARISON_HPP

#include "lines.hpp"

namespace conformance {

//! Lines of `wanted` that have one of `lines` within one cell with at least 98 % of their votes.
int countFound(const Lines& wanted, const Lines& lines, const Arguments& arguments);

//! Lines that have another one of the same list within one cell.
int countCrowded(const Lines& lines, const Arguments& arguments);

//! The fewest and the most votes that a line can have: a pixel on the boundary may count or not.
struct VoteRange
{
    int fewest, most;
};

/** The votes of each line by definition, the edge pixels within rho / 2, counted one by one. On the
boundary is what rounding the line to float can move over it. */
std::vector<VoteRange> countVotes(const Lines& lines, const cv::Mat1b& edges,
                                  const Arguments& arguments);

//! The votes of a line of the grid (i rho, min_theta + j theta), free of rounding to float; pixels
//! at a distance of exactly rho / 2 count.
std::vector<int> countVotesOnGrid(const Lines& lines, const cv::Mat1b& edges,
                                  const Arguments& arguments);

//! Lines whose votes are not in the range.
int countWrongVotes(const Lines& lines, const std::vector<VoteRange>& counted);

} // namespace conformance

#endif // LINESPACE_CONFORMANCE_COMPARISON_HPP
