// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "grid_support.hpp"

#include <cmath>

namespace cv {
namespace linespace {

namespace {

//! Tables larger than this are not made: all lines of the grid are counted then.
const double MOST_TABLE_BYTES = 2048. * (1 << 20);

/** Share of the threshold that the votes of the chords near a line must have for it to be counted.
The band of a line holds pixels that no single chord holds, and the cascade's polylines miss some
that a chord holds. Measured by test/conformance: at 0.3 to 0.5 about one line in a thousand of the
worst case is lost, at 0.6 whole cases are. */
const double CHORD_SHARE = 0.4;

//! The number of the border point that a line meets on a side, as a real number affine in the
//! line's rho.
struct BorderCrossing
{
    double offset, slope;
    int first, last; //!< border points of the side
};

//! Crossings of the lines of one normal with a side of the frame, rho and coordinates relative to
//! its corner.
BorderCrossing crossingWith(const Cell& frame, int side, double c, double s)
{
    const double w = frame.width, h = frame.height;
    BorderCrossing crossing;
    crossing.first = frame.firstPoint(side);
    crossing.last = crossing.first + frame.pointCount(side) - 1;
    switch (side)
    {
    case SIDE_TOP: // x = rho / c
        crossing.slope = 1 / c;
        crossing.offset = 0;
        break;
    case SIDE_RIGHT: // y = (rho - w c) / s
        crossing.slope = 1 / s;
        crossing.offset = w - w * c / s;
        break;
    case SIDE_BOTTOM: // x = (rho - h s) / c, from right to left
        crossing.slope = -1 / c;
        crossing.offset = w + h + w + h * s / c;
        break;
    default: // y = rho / s, upwards
        crossing.slope = -1 / s;
        crossing.offset = 2 * w + h + h;
    }
    return crossing;
}

/** A number of border points in the fixed point of the runs. Samples of a run are on a side but
for rounding, whatever the slope, so all their numbers are below 2^31. */
int64 fixedPoint(double value)
{
    return (int64)std::floor(value * ((int64)1 << SAMPLE_FRACTION));
}

int pointAt(int64 position, int first, int last)
{
    return (int)std::min<int64>(std::max<int64>(position >> SAMPLE_FRACTION, first), last);
}

//! The most votes among the chords of the points that a sample meets and their neighbours.
template<class Votes>
int mostVotesNear(const Votes* table, const Cell& frame, const SampleRun& run, int64 from, int64 to)
{
    const int s = pointAt(from, run.fromFirst, run.fromLast);
    const int e = pointAt(to, run.toFirst, run.toLast);
    const int s0 = std::max(s - 1, run.fromFirst), s1 = std::min(s + 1, run.fromLast);
    const int e0 = std::max(e - 1, run.toFirst), e1 = std::min(e + 1, run.toLast);
    const int side = frame.sideOf(s), firstPartner = frame.firstPartner(side);
    const ptrdiff_t rowLength = frame.rowLength(side);
    const Votes* row = table + frame.rowStart(s0);
    Votes most = 0;
    for (int p = s0; p <= s1; ++p, row += rowLength)
        most = std::max(most, std::max(row[e - firstPartner],
                                       std::max(row[e0 - firstPartner], row[e1 - firstPartner])));
    return (int)most;
}

template<class Votes>
void supportedDistancesOf(const VoteTable& table, const Cell& frame, const HoughGrid& grid,
                          int angle, int needed, std::vector<int>& distances)
{
    const Votes* votes = table.ptr<Votes>();
    const int samples = samplesPerLine(grid);
    int first, last;
    grid.distanceRange(angle, first, last);
    std::vector<int> support((size_t)(last - first + 1), 0);
    SampleRun runs[MOST_RUNS];
    findSampleRuns(frame, grid, angle, runs);
    for (const SampleRun& run : runs)
    {
        int64 from = run.from, to = run.to;
        size_t line = (size_t)(run.begin / samples);
        int sample = (int)(run.begin % samples);
        for (int64 f = run.begin; f < run.end; ++f, from += run.fromStep, to += run.toStep)
        {
            support[line] += mostVotesNear(votes, frame, run, from, to);
            if (++sample == samples)
            {
                sample = 0;
                ++line;
            }
        }
    }
    distances.clear();
    for (size_t i = 0; i < support.size(); ++i)
        if (support[i] >= needed)
            distances.push_back(first + (int)i);
}

} // namespace

bool countsAllLines(const Plan& plan, const HoughGrid& grid, bool weighted, size_t edgePixels)
{
    // A band as wide as the image holds most pixels anyway.
    if (grid.rho >= std::max(grid.image.width, grid.image.height))
        return true;
    // The time, in that of a pixel at one angle: every pixel at every angle, or the cascade and a
    // look at its table for every line of the grid (measured on photographs, doc/performance.md).
    const double chords = (double)plan.frame().chordCount(), angles = grid.angles;
    const double sides = (double)grid.image.width + grid.image.height;
    return edgePixels * angles < 7 * chords + 40 * sides * angles ||
           workingMemory(plan, weighted, false, plan.levelCount() - 1) > MOST_TABLE_BYTES;
}

int neededSupport(int threshold)
{
    return std::max(1, cvFloor(CHORD_SHARE * threshold));
}

int samplesPerLine(const HoughGrid& grid)
{
    return std::max(1, cvCeil(grid.rho));
}

void findSampleRuns(const Cell& frame, const HoughGrid& grid, int angle, SampleRun runs[MOST_RUNS])
{
    const double c = std::cos(grid.thetas[angle]), s = std::sin(grid.thetas[angle]);
    const int samples = samplesPerLine(grid);
    // The line's own rho is in the middle of its samples.
    const double spacing = grid.rho / samples,
                 shift = 0.5 * (c + s) - 0.5 * (samples - 1) * spacing;
    int first, last;
    grid.distanceRange(angle, first, last);
    const double start = first * grid.rho + shift;
    const double count = ((double)last - first + 1) * samples;

    // Between the corners of the frame in the order of their rho, the lines meet the same two
    // sides.
    const double w = frame.width, h = frame.height;
    double corners[4] = {0, w * c, h * s, w * c + h * s};
    std::sort(corners, corners + 4);
    const double low[4] = {std::min(0., w * c), std::min(w * c, w * c + h * s),
                           std::min(h * s, w * c + h * s), std::min(0., h * s)};
    const double high[4] = {std::max(0., w * c), std::max(w * c, w * c + h * s),
                            std::max(h * s, w * c + h * s), std::max(0., h * s)};
    for (int k = 0; k < MOST_RUNS; ++k)
    {
        SampleRun& run = runs[k];
        run = SampleRun();
        if (corners[k + 1] - corners[k] < 1e-6)
            continue;
        const double middle = 0.5 * (corners[k] + corners[k + 1]);
        int sides[4], n = 0;
        for (int side = SIDE_TOP; side <= SIDE_LEFT; ++side)
            if (low[side] < middle && middle < high[side])
                sides[n++] = side;
        if (n != 2) // the middle is a corner up to rounding
            continue;
        const double begin =
            std::min(count, std::max(0., std::ceil((corners[k] - start) / spacing)));
        const double end =
            std::min(count, std::max(0., std::ceil((corners[k + 1] - start) / spacing)));
        if (begin >= end)
            continue;
        const BorderCrossing from = crossingWith(frame, sides[0], c, s),
                             to = crossingWith(frame, sides[1], c, s);
        const double rho = start + begin * spacing;
        run.begin = (int64)begin;
        run.end = (int64)end;
        run.from = fixedPoint(from.offset + from.slope * rho);
        run.to = fixedPoint(to.offset + to.slope * rho);
        if (end - begin > 1) // a step that leads out of the side may be of any size
        {
            run.fromStep = fixedPoint(from.slope * spacing);
            run.toStep = fixedPoint(to.slope * spacing);
        }
        run.fromFirst = from.first;
        run.fromLast = from.last;
        run.toFirst = to.first;
        run.toLast = to.last;
    }
}

void supportedDistances(const VoteTable& table, const Cell& frame, const HoughGrid& grid, int angle,
                        int needed, std::vector<int>& distances)
{
    if (table.depth == 1)
        supportedDistancesOf<uchar>(table, frame, grid, angle, needed, distances);
    else if (table.depth == 2)
        supportedDistancesOf<ushort>(table, frame, grid, angle, needed, distances);
    else
        supportedDistancesOf<int>(table, frame, grid, angle, needed, distances);
}

} // namespace linespace
} // namespace cv
