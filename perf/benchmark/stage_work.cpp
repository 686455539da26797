// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "stage_work.hpp"

// The library's own geometry, compiled into this program, since it is not exported.
#include "plan.hpp"

#include <climits>

namespace benchmark {

namespace {

namespace ls = cv::linespace;

int bytesPerVote(const ls::Level& level)
{
    return level.maxVotes <= UCHAR_MAX ? 1 : level.maxVotes <= USHRT_MAX ? 2 : 4;
}

double tableBytes(const ls::Level& level)
{
    return (double)level.tableSize() * bytesPerVote(level);
}

//! Every chord of every cell is a sum over pixels, of which there is a plane of bytes each.
StageWork firstCells(const ls::Level& level)
{
    const ls::Cell cell = level.cell;
    double loads = 0, adds = 0;
    for (int s = 0; s < cell.firstPoint(ls::SIDE_LEFT); ++s)
        for (int e = cell.firstPartner(cell.sideOf(s)); e < cell.borderCount(); ++e)
        {
            const ls::Chord chord = {s, e};
            int pixels = 0;
            ls::Raster(cell, chord).forEachPixel([&](int, int) { ++pixels; });
            loads += pixels;
            adds += std::max(pixels - 1, 0);
        }
    const double cells = (double)level.cellCount();
    return {"level 0",
            cells * cell.width * cell.height,
            tableBytes(level),
            loads * cells,
            tableBytes(level),
            adds * cells,
            1};
}

StageWork mergeOf(const ls::Plan& plan, int l)
{
    const ls::Level &child = plan.level(l - 1), &parent = plan.level(l);
    const ls::Merge merge = plan.merge(l);
    double sums = 0;
    ls::Segment segments[ls::MAX_SEGMENTS];
    for (int s = 0; s < merge.parent.firstPoint(ls::SIDE_LEFT); ++s)
        for (int i = 0, count = ls::rowSegments(merge, s, segments); i < count; ++i)
            if (segments[i].isCrossing)
                sums += segments[i].count;
    const double adds = sums * (double)parent.cellCount();
    const double loads = (double)parent.tableSize() + adds; // a copy is one load, a sum are two
    return {"level " + std::to_string(l), tableBytes(child),  tableBytes(parent),
            loads * bytesPerVote(child),  tableBytes(parent), adds,
            bytesPerVote(parent)};
}

} // namespace

std::vector<StageWork> stageWork(cv::Size image, int cellSize)
{
    const cv::Ptr<const ls::Plan> plan = ls::Plan::cascaded(image, cellSize);
    const double pixels = (double)image.area();
    std::vector<StageWork> work = {{"edge map", pixels, pixels, pixels, pixels, 0, 1},
                                   firstCells(plan->level(0))};
    for (int l = 1; l < plan->levelCount(); ++l)
        work.push_back(mergeOf(*plan, l));
    // Every vote is looked at once at least.
    const double last = tableBytes(plan->level(plan->levelCount() - 1));
    work.push_back({"candidates", last, 0, last, 0, 0, 1});
    return work;
}

} // namespace benchmark
