// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The order of the stages, which is the same for every back end.

#include "stages.hpp"

namespace cv {
namespace linespace {

namespace {

/** Counters of a byte where the most votes that a level can have do not fit, but those that images have
do: only a nearly straight row of edge pixels from border to border of a cell has as many. */
bool mergeNarrow(Executor& executor, const EdgeMap& edges, const Plan& plan, int level,
                 const VoteTable& child, VoteTable& parent)
{
    const int most = UCHAR_MAX + UCHAR_MAX / 4;
    if (edges.weighted || child.depth > 1 || parent.depth == 1 || plan.level(level).maxVotes > most)
        return false;
    const int depth = parent.depth;
    parent.depth = 1;
    if (executor.mergeCellsNarrow(plan, level, child, parent))
        return true;
    parent.depth = depth;
    return false;
}

} // namespace

void countVotes(Executor& executor, const EdgeMap& edges, const Plan& plan, bool exact, int level,
                VoteTables& tables, StageTimes& times)
{
    VoteTable& first = tables.of(0);
    executor.allocate(plan.level(0), edges.depthFor(plan.level(0).maxVotes), first);
    if (exact)
        executor.exactVotes(edges, plan, first);
    else
        executor.firstCells(edges, plan, first);
    executor.endStage("level 0", times);
    mergeVotes(executor, edges, plan, 0, level, tables, times);
}

void mergeVotes(Executor& executor, const EdgeMap& edges, const Plan& plan, int from, int to,
                VoteTables& tables, StageTimes& times)
{
    for (int l = from + 1; l <= to; ++l)
    {
        const VoteTable& child = tables.of(l - 1);
        VoteTable& parent = tables.of(l);
        executor.allocate(plan.level(l), edges.depthFor(plan.level(l).maxVotes), parent);
        if (!mergeNarrow(executor, edges, plan, l, child, parent))
            executor.mergeCells(plan, l, child, parent);
        executor.endStage(format("level %d", l), times);
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
    // Votes: a byte each, without and with the mask and in the back end's frame or order.
    // Directions: two bytes each in all of these but the first; estimating them takes 11 bytes for
    // a while. And where each cell of level 0 begins.
    return most[0] + most[1] + (oriented ? 3 + 11 : 3) * pixels +
           (double)plan.level(0).cellCount() * sizeof(size_t);
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
