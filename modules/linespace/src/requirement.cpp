// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "requirement.hpp"

#include "acontrario.hpp"

#include <climits>

namespace cv {
namespace linespace {

namespace {

//! How many edge pixels vote for the chords of each bin; of a map that is not oriented, for all.
//! Estimated directions follow the pixels of the chord itself, so they are no independent evidence
//! against chance: all pixels, to be on the safe side.
std::vector<int> votersOf(const EdgeMap& edges)
{
    if (!edges.isOriented() || edges.isEstimated)
        return std::vector<int>(1, edges.voters >= 0 ? edges.voters : countNonZero(edges.votes));
    std::vector<int> voters(DIRECTION_BINS, 0);
    for (int y = 0; y < edges.directions.rows; ++y)
    {
        const ushort* bits = edges.directions.ptr<ushort>(y);
        for (int x = 0; x < edges.directions.cols; ++x)
            for (int bin = 0; bits[x] >> bin; ++bin)
                voters[bin] += bits[x] >> bin & 1;
    }
    return voters;
}

//! One less than the votes of the first length that can be significant; INT_MAX: none can.
int leastSignificant(const std::vector<int>& votes)
{
    for (int length = 0; length < (int)votes.size(); ++length)
        if (votes[length] <= length)
            return std::max(0, votes[length] - 1);
    return INT_MAX;
}

} // namespace

std::vector<std::vector<int>> Requirement::leastVotes(double ratio) const
{
    std::vector<std::vector<int>> least = pixels;
    for (std::vector<int>& byLength : least)
        for (int& votes : byLength)
            votes = cvCeil(ratio * votes);
    return least;
}

Requirement moreVotesThan(int threshold)
{
    Requirement requirement;
    requirement.threshold = threshold;
    return requirement;
}

Requirement significance(const EdgeMap& edges, double pixels, const Plan& plan, double falseAlarms)
{
    Requirement requirement = moreVotesThan(INT_MAX);
    const int longest = std::max(plan.imageSize().width, plan.imageSize().height);
    const double chords = (double)plan.frame().chordCount();
    const std::vector<int> voters = votersOf(edges);
    for (size_t bin = 0; bin < voters.size(); ++bin)
    {
        const double density = pixels > 0 ? voters[bin] / pixels : 0;
        requirement.pixels.push_back(significantVotes(longest, density, chords, falseAlarms));
        // Nothing with fewer votes needs to be looked at.
        requirement.threshold =
            std::min(requirement.threshold, leastSignificant(requirement.pixels.back()));
    }
    return requirement;
}

} // namespace linespace
} // namespace cv
