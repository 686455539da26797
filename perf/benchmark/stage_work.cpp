// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "stage_work.hpp"

// The library's own geometry, compiled into this program, since it is not exported.
#include "merge_rectangles.hpp"
#include "plan.hpp"

#include <algorithm>
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

//! Calls visit(chord) for all chords of a cell.
template<class Visit>
void forEachChord(const ls::Cell& cell, Visit visit)
{
    for (int s = 0; s < cell.firstPoint(ls::SIDE_LEFT); ++s)
        for (int e = cell.firstPartner(cell.sideOf(s)); e < cell.borderCount(); ++e)
            visit(ls::Chord{s, e});
}

//! Pixels of all chords.
double pixelsOfChords(const ls::Cell& cell)
{
    double pixels = 0;
    forEachChord(cell, [&](ls::Chord chord) { pixels += ls::Raster(cell, chord).count; });
    return pixels;
}

double wordsOfChord(const ls::Level& level)
{
    return std::max(1., (double)level.cellCount() * bytesPerVote(level) / 4);
}

bool isCrossing(const ls::Merge& merge, int p, int q)
{
    return merge.childOf(p) != merge.childOf(q);
}

/** Parts that tiles of 8 x 8 chords of a rectangle load, at either end, as ../opengl_ways does: along a
row and along a column the run of crossings, up to 8 of them, and what is beyond once more for each
chord. */
double partsOfTiles(const ls::Merge& merge, const ls::MergeRectangle& all, int s0, int e0)
{
    if (!all.isCrossing)
        return (double)all.rows * all.columns;
    enum
    {
        SIDE = 8
    };
    double parts = 0;
    // Of the chords of one row or column of a tile.
    const auto addLine = [&](int s, int e, int stepS, int stepE, int count)
    {
        const auto crossing = [&](int i)
        {
            return merge.crossing(s + i * stepS, e + i * stepE);
        };
        const int least = std::min(crossing(0), crossing(count - 1)),
                  most = std::max(crossing(0), crossing(count - 1));
        parts += std::min<int>(SIDE, most - least + 1);
        for (int i = 0; i < count; ++i)
            parts += crossing(i) >= least + SIDE;
    };
    for (int a = 0; a < all.rows; a += SIDE)
        for (int b = 0; b < all.columns; b += SIDE)
        {
            const int rows = std::min<int>(SIDE, all.rows - a),
                      columns = std::min<int>(SIDE, all.columns - b);
            for (int i = 0; i < rows; ++i)
                addLine(s0 + a + i, e0 + b, 0, 1, columns);
            for (int k = 0; k < columns; ++k)
                addLine(s0 + a, e0 + b + k, 1, 0, rows);
        }
    return parts;
}

WordWork mergeInWords(const ls::Plan& plan, int l)
{
    const ls::Merge merge = plan.merge(l);
    const double words = wordsOfChord(plan.level(l));
    WordWork work = {"level " + std::to_string(l), 0, 0, 0, 0, 0};
    const bool hasBelow = l > 1;
    const ls::Merge below = hasBelow ? plan.merge(l - 1) : ls::Merge();
    const auto partsBelow = [&](int p, int q)
    {
        return hasBelow && isCrossing(below, p, q) ? 2 : 1;
    };
    forEachChord(merge.parent,
                 [&](ls::Chord chord)
                 {
                     const int p = merge.childPoint(chord.s), q = merge.childPoint(chord.e);
                     work.stores += words;
                     if (!isCrossing(merge, chord.s, chord.e))
                     {
                         work.loads += words;
                         work.fusedLoads += words * partsBelow(p, q);
                         return;
                     }
                     const int m = merge.crossing(chord.s, chord.e);
                     work.loads += 2 * words;
                     work.adds += words;
                     work.fusedLoads +=
                         words * (partsBelow(p, merge.sharedPoint(merge.childOf(chord.s), m)) +
                                  partsBelow(q, merge.sharedPoint(merge.childOf(chord.e), m)));
                 });
    if (!hasBelow)
        work.fusedLoads = 0;
    for (const ls::MergeRectangle& rectangle : ls::mergeRectangles(merge))
    {
        // Its first chord, from its index.
        int s = 0;
        while (s + 1 < merge.parent.firstPoint(ls::SIDE_LEFT) &&
               merge.parent.rowStart(s + 1) <= rectangle.start)
            ++s;
        const int e = merge.parent.firstPartner(merge.parent.sideOf(s)) +
                      (int)(rectangle.start - merge.parent.rowStart(s));
        work.sharedLoads += words * partsOfTiles(merge, rectangle, s, e);
    }
    return work;
}

} // namespace

std::vector<WordWork> wordWork(cv::Size image, int cellSize)
{
    const cv::Ptr<const ls::Plan> exact = ls::Plan::exact(image),
                                  plan = ls::Plan::cascaded(image, cellSize);
    const double pixels = pixelsOfChords(exact->frame());
    const ls::Level& first = plan->level(0);
    const double words = wordsOfChord(first), firstPixels = pixelsOfChords(first.cell) * words;
    std::vector<WordWork> work = {
        {"exact", pixels, (double)exact->frame().chordCount(), pixels, 0, 0},
        {"level 0", firstPixels, (double)first.cell.chordCount() * words, firstPixels, 0, 0}};
    for (int l = 1; l < plan->levelCount(); ++l)
        work.push_back(mergeInWords(*plan, l));
    return work;
}

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
