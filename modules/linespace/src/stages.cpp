// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The order of the stages, which is the same for every back end.

#include "stages.hpp"

namespace cv {
namespace linespace {

void countVotes(Executor& executor, const EdgeMap& edges, const Plan& plan, bool exact, int level,
                VoteTable& spare, VoteTable& result, StageTimes& times)
{
    // The tables alternate such that the last level's is `result`.
    VoteTable* current = level % 2 == 0 ? &result : &spare;
    VoteTable* next = level % 2 == 0 ? &spare : &result;
    current->allocate(plan.level(0), edges.depthFor(plan.level(0).maxVotes));
    if (exact)
        executor.exactVotes(edges, plan, *current);
    else
        executor.firstCells(edges, plan, *current);
    times.end("level 0");
    for (int l = 1; l <= level; ++l)
    {
        next->allocate(plan.level(l), edges.depthFor(plan.level(l).maxVotes));
        executor.mergeCells(plan, l, *current, *next);
        std::swap(current, next);
        times.end(format("level %d", l));
    }
}

double workingMemory(const Plan& plan, bool weighted, bool oriented, int level)
{
    EdgeMap edges;
    edges.weighted = weighted;
    double most[2] = {0, 0};
    for (int l = 0; l <= level; ++l)
    {
        const double bytes =
            (double)plan.level(l).tableSize() * edges.depthFor(plan.level(l).maxVotes);
        most[l % 2] = std::max(most[l % 2], bytes);
    }
    const double pixels = (double)plan.frame().width * plan.frame().height;
    // Votes: a byte each, without and with the mask and in the back end's order. Directions: two
    // bytes each in all of these but the first; estimating them takes 11 bytes for a while.
    return most[0] + most[1] + (oriented ? 3 + 11 : 3) * pixels;
}

int chordVotes(const EdgeMap& edges, const Cell& frame, Chord chord)
{
    const Mat& votes = edges.votes;
    const bool isOriented = edges.isOriented();
    const ushort bit = isOriented ? directionBit(frame, chord) : 0;
    int sum = 0;
    Raster(frame, chord)
        .forEachPixel(
            [&](int x, int y)
            {
                if (x < votes.cols && y < votes.rows &&
                    (!isOriented || (edges.directions.ptr<ushort>(y)[x] & bit)))
                    sum += votes.ptr<uchar>(y)[x];
            });
    return sum;
}

} // namespace linespace
} // namespace cv
