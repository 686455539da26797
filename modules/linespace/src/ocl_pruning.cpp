// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "ocl_pruning.hpp"

#include <cvconfig.h>

#ifdef HAVE_OPENCL

#include "ocl_launch.hpp"
#include "ocl_segments.hpp"

#include <climits>

namespace cv {
namespace linespace {

namespace {

//! Chords of a frame for which bounds are worth their launches.
const size_t LEAST_CHORDS = 1 << 14;
//! Of the last level's blocks, in percent: where more are needed whole tables are faster.
const int MOST_COUNTED = 50;

//! Blocks of a row that a work item takes where it takes more than a chord.
int blocksPerItem()
{
    return isProcessor() ? 16 : 1;
}

//! As in pruning.cl.
struct BlockSegment : RunOfChords
{
    DeviceCrossings least, most;
};

BlockSegment blockSegment(const Merge& merge, int block, int s, const Segment& segment)
{
    BlockSegment result;
    static_cast<RunOfChords&>(result) = runOfChords(segment);
    CrossingRun least, most; // of nothing, if it does not cross
    if (segment.isCrossing)
        outermostCrossings(merge, block, block * s, block * segment.firstEnd, least, most);
    result.least = deviceCrossings(least, block, segment.count);
    result.most = deviceCrossings(most, block, segment.count);
    return result;
}

} // namespace

int DevicePruning::baseLevel(const Plan& plan, bool weighted)
{
    const int last = plan.levelCount() - 1, base = last - MOST_LEVELS;
    if (base < 0 || plan.frame().chordCount() < LEAST_CHORDS)
        return -1;
    const Level& level = plan.level(base);
    // A chord crosses fewer cells than there are in a row and a column.
    const double most =
        (double)level.maxVotes * (weighted ? 255 : 1) * (level.grid.width + level.grid.height);
    return level.cell.width % BLOCK == 0 && level.cell.height % BLOCK == 0 && most < USHRT_MAX
               ? base
               : -1;
}

bool DevicePruning::isWorthATry()
{
    if (rest_ == 0)
        return true;
    --rest_;
    return false;
}

void DevicePruning::learn(int neededCount)
{
    const double blocks = (double)levels_[top_].coarse.chordCount();
    if (neededCount * 100. > blocks * MOST_COUNTED)
        pause_ = rest_ = std::min(16, std::max(1, 2 * pause_));
    else
        pause_ = 0;
}

void DevicePruning::list(const Plan& plan, int base)
{
    base_ = -1; // until all is there
    top_ = plan.levelCount() - 1 - base;
    for (int l = 0; l <= top_; ++l)
    {
        BlockLevel& level = levels_[l];
        const Level& shape = plan.level(base + l);
        level.coarse = Cell(shape.cell.width / BLOCK, shape.cell.height / BLOCK);
        level.cells = (int)shape.cellCount();
        const size_t blocks = level.coarse.chordCount() * level.cells;
        allocateOn(level.bounds, blocks * sizeof(ushort));
        level.rowCount = level.coarse.firstPoint(SIDE_LEFT);
        level.longestRow = level.coarse.rowLength(SIDE_TOP);
        if (l == 0)
            continue;
        allocateOn(level.required, blocks * sizeof(int));
        allocateOn(level.needed, level.coarse.chordCount() * sizeof(int));
        const Merge merge = plan.merge(base + l), coarse(levels_[l - 1].coarse, merge.horizontal);
        std::vector<BorderRow> rows = rowsOf(level.coarse);
        std::vector<BlockSegment> segments(level.rowCount * MAX_SEGMENTS);
        for (int s = 0; s < level.rowCount; ++s)
        {
            Segment own[MAX_SEGMENTS];
            rows[s].segments = rowSegments(coarse, s, own);
            for (int k = 0; k < rows[s].segments; ++k)
                segments[s * MAX_SEGMENTS + k] = blockSegment(merge, BLOCK, s, own[k]);
        }
        upload(rows, level.rows);
        upload(segments, level.segments);
    }
    base_ = base;
}

void DevicePruning::bound(const Plan& plan, int base, const VoteTable& table)
{
    if (base_ != base)
        list(plan, base);
    const Cell& cell = plan.level(base).cell;
    const BlockLevel& whole = levels_[0];
    Launch(PRUNING_PROGRAM, "poolBlocks",
           format("-D POOL -D BLOCK=%d -D CELLS=%d -D CHILD=%s", (int)BLOCK, whole.cells,
                  typeOf(table.depth)))
        .with(in(table.device), cell.width, cell.height, out(whole.bounds))
        .run(whole.longestRow, whole.rowCount);
}

void DevicePruning::count(const VoteTable& table, const std::vector<Votes>& above, int cut,
                          int sample)
{
    const int run = blocksPerItem();
    const auto optionsOf = [&](const BlockLevel& level)
    {
        return format("-D BLOCK=%d -D CELLS=%d -D MAX_SEGMENTS=%d -D RUN=%d", (int)BLOCK,
                      level.cells, MAX_SEGMENTS, run);
    };
    const auto runs = [&](const BlockLevel& level)
    {
        return (level.longestRow + run - 1) / run;
    };
    for (int l = 1; l <= top_; ++l)
    {
        const BlockLevel& level = levels_[l];
        Launch(PRUNING_PROGRAM, "boundBlocks", optionsOf(level) + " -D BOUND")
            .with(in(level.segments), in(level.rows), level.rowCount, in(levels_[l - 1].bounds),
                  out(level.bounds), out(level.required))
            .run(runs(level), level.rowCount, run > 1);
    }
    for (int l = top_; l > 1; --l)
    {
        const BlockLevel &level = levels_[l], &child = levels_[l - 1];
        Launch(PRUNING_PROGRAM, "requireBlocks",
               optionsOf(level) + " -D REQUIRE" + (l == top_ ? " -D TOP" : ""))
            .with(in(level.segments), in(level.rows), level.rowCount, in(level.bounds),
                  in(level.required), cut, sample, in(child.bounds), inOut(child.required),
                  out(level.needed))
            .run(runs(level), level.rowCount, run > 1);
    }
    for (int l = 1; l <= top_; ++l)
    {
        const BlockLevel& level = levels_[l];
        const Votes& votes = above[l - 1];
        const UMat& child = l == 1 ? table.device : above[l - 2].table;
        const int childDepth = l == 1 ? table.depth : above[l - 2].depth;
        const bool isItemOfBlocks = isProcessor();
        const int width = isItemOfBlocks ? runs(level) : level.longestRow * BLOCK;
        const int height = isItemOfBlocks ? level.rowCount : level.rowCount * BLOCK;
        Launch(PRUNING_PROGRAM, "mergeBlocks",
               optionsOf(level) +
                   format(" -D MERGE -D ENDS=%d -D CHILD=%s -D PARENT=%s",
                          isItemOfBlocks ? (int)BLOCK : 1, typeOf(childDepth),
                          typeOf(votes.depth)) +
                   (l == 1 ? " -D FROM_WHOLE" : ""))
            .with(in(level.segments), in(level.rows), level.rowCount, in(votes.segments),
                  in(votes.rows), in(l == 1 ? level.required : level.needed), in(child),
                  out(votes.table))
            .run(width, height, isItemOfBlocks);
    }
}

} // namespace linespace
} // namespace cv

#endif // HAVE_OPENCL
