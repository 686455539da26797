// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// ChordCounter::countNear: puts neighbouring chords into the lanes of chord_lanes.hpp, and counts
// what does not fit there one by one.

#include "chord_counter.hpp"
#include "chord_lanes.hpp"

#include <climits>

namespace cv {
namespace linespace {

namespace {

//! A raster at one of its columns.
struct Walk
{
    int column, minor, remainder;

    Walk(const Raster& raster, int at)
        : column(at), minor(raster.minor), remainder(raster.remainder)
    {
        if (at == raster.first)
            return;
        const int64 numerator = (int64)raster.minor * raster.modulus + raster.remainder +
                                (int64)(at - raster.first) * raster.step;
        minor = (int)(numerator / raster.modulus);
        remainder = (int)(numerator % raster.modulus);
    }
    void next(const Raster& raster)
    {
        ++column;
        raster.next(minor, remainder);
    }
};

static_assert((int)LaneMap::WINDOW <= (int)EdgePlanes::MARGIN, "reads beyond a row");

} // namespace

int ChordCounter::voteAcross(const EdgePlanes::Plane* planes, int column, int minor, int bin) const
{
    if (planes_.isOriented() &&
        !(planes[EdgePlanes::planeOf(bin)].row(column)[minor] & EdgePlanes::bitOf(bin)))
        return 0;
    return planes_.has(EdgePlanes::VOTES) ? planes[EdgePlanes::VOTES].row(column)[minor] : 1;
}

bool ChordCounter::countLanes(const Raster& guide, const Range& columns, const Raster* rasters,
                              const int* bins, int count, int* votes) const
{
    const EdgePlanes::Plane* const planes = planes_.across(guide.xMajor);
    LaneMap map;
    if (!guide.fixedPoint(map.start, map.increment))
        return false;
    map.start += (columns.start - guide.first) * map.increment;
    map.columns = columns.size();
    map.below = LaneMap::belowFor(guide.step < 0);
    map.weighted = planes_.isWeighted();
    const int window = (int)(map.start >> 32) - map.below;

    ChordLanes lanes;
    for (int i = 0; i < ChordLanes::COUNT; ++i)
    {
        const int lane = std::min(i, count - 1); // the rest are copies that nobody asks for
        const Raster& raster = rasters[lane];
        Walk walk(raster, raster.first);
        int before = 0;
        for (; walk.column < columns.start; walk.next(raster))
            before += voteAcross(planes, walk.column, walk.minor, bins[lane]);
        const bool falls = raster.step < 0;
        CV_DbgAssert(std::abs(walk.minor - window - map.below) <= ChordLanes::REACH);
        lanes.position[i] = (uchar)(walk.minor - window);
        lanes.direction[i] = falls ? 255 : 1;
        lanes.step[i] = (short)std::abs(raster.step);
        lanes.modulus[i] = (short)raster.modulus;
        lanes.rest[i] = (short)(falls ? raster.modulus - 1 - walk.remainder : walk.remainder);
        votes[i] = before;
    }

    // Of an oriented map, chords of neighbouring bins may have their bits in different planes.
    for (int p = planes_.isOriented() ? EdgePlanes::LOW_BITS : EdgePlanes::VOTES;
         p <= (planes_.isOriented() ? EdgePlanes::HIGH_BITS : EdgePlanes::VOTES); ++p)
    {
        bool isUsed = !planes_.isOriented();
        for (int i = 0; i < ChordLanes::COUNT; ++i)
        {
            const int bin = bins[std::min(i, count - 1)];
            const bool isOwn = planes_.isOriented() && EdgePlanes::planeOf(bin) == p;
            lanes.bit[i] = isOwn ? EdgePlanes::bitOf(bin) : 0;
            isUsed = isUsed || isOwn;
        }
        if (!isUsed)
            continue;
        map.votes =
            planes_.has(EdgePlanes::VOTES) ? planes[EdgePlanes::VOTES].row(columns.start) : 0;
        map.bits = planes_.isOriented() ? planes[p].row(columns.start) : 0;
        map.stride = planes[p].stride;
        countChordLanes(lanes, map, votes);
    }

    for (int i = 0; i < count; ++i)
    {
        const int end = rasters[i].first + rasters[i].count;
        if (end > columns.end)
            for (Walk walk(rasters[i], columns.end); walk.column < end; walk.next(rasters[i]))
                votes[i] += voteAcross(planes, walk.column, walk.minor, bins[i]);
    }
    return true;
}

void ChordCounter::countNear(Chord middle, const Chord* chords, int count, int* votes) const
{
    static_assert((int)MOST_NEAR <= (int)ChordLanes::COUNT, "a lane for each chord");
    CV_DbgAssert(count <= MOST_NEAR);
    const Raster guide(frame_, middle);
    Raster rasters[MOST_NEAR];
    int bins[MOST_NEAR], where[MOST_NEAR], sums[ChordLanes::COUNT];
    const bool fits = hasChordLanes() && guide.modulus <= SHRT_MAX - 64;
    int begin = guide.first, end = guide.first + guide.count, together = 0;
    for (int i = 0; i < count; ++i)
    {
        const Raster raster(frame_, chords[i]);
        if (!fits || raster.xMajor != guide.xMajor)
        {
            votes[i] = this->votes(chords[i]);
            continue;
        }
        begin = std::max(begin, raster.first);
        end = std::min(end, raster.first + raster.count);
        bins[together] = planes_.isOriented() ? directionBin(frame_, chords[i]) : 0;
        where[together] = i;
        rasters[together++] = raster;
    }
    if (together == 0)
        return;
    const bool counted = end - begin >= LaneMap::MIN_COLUMNS &&
                         countLanes(guide, Range(begin, end), rasters, bins, together, sums);
    for (int i = 0; i < together; ++i)
        votes[where[i]] = counted ? sums[i] : this->votes(chords[where[i]]);
}

} // namespace linespace
} // namespace cv
