// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// ChordCounter::countSquare: puts neighbouring chords into the lanes of chord_lanes.hpp; without
// them, or where they do not fit, counts diagonals of the square (parallel_chords.cpp) or one chord
// after the other.

#include "chord_counter.hpp"
#include "chord_lanes.hpp"
#include "vectors.hpp"

#include <climits>

namespace cv {
namespace linespace {

namespace {

const int SQUARE = ChordCounter::SQUARE;

static_assert((int)LaneMap::WINDOW <= (int)EdgePlanes::MARGIN, "reads beyond a row");
static_assert(SQUARE <= 2 * ChordLanes::REACH, "the guide is in the middle");

//! SQUARE consecutive border points, of which those of the first one's side are meant.
struct BorderRun
{
    Point first, step; //!< in doubled coordinates
    int middle;

    BorderRun(const Cell& frame, int point) : first(frame.borderPoint(point))
    {
        static const int STEPS[4][2] = {{2, 0}, {0, 2}, {-2, 0}, {0, -2}};
        const int side = frame.sideOf(point);
        step = Point(STEPS[side][0], STEPS[side][1]);
        const int last = frame.firstPoint(side) + frame.pointCount(side) - 1;
        middle = std::min<int>(ChordLanes::REACH, last - point);
    }
    Point at(int i) const { return first + i * step; }
};

//! Puts the chords of a square into lanes.
class SquareLanes
{
public:
    SquareLanes(const ChordCounter& counter, const EdgePlanes& planes, Chord first, int* votes)
        : counter_(counter), planes_(planes), first_(first), votes_(votes),
          begin_(planes.frame(), first.s), end_(planes.frame(), first.e)
    {
        const Point across = end_.at(end_.middle) - begin_.at(begin_.middle);
        isOneBin_ = !planes.isOriented() || haveOneBin(directionBin(across.x, across.y));
        bin_ = planes.isOriented() ? directionBin(across.x, across.y) : 0;
        // From here on x is the major axis of the middle chord, and the run at its lower end first.
        xMajor_ = std::abs(across.x) >= std::abs(across.y);
        if (!xMajor_)
        {
            transpose(begin_);
            transpose(end_);
        }
        isReversed_ = (xMajor_ ? across.x : across.y) < 0;
        if (isReversed_)
            std::swap(begin_, end_);
        origin_ = begin_.at(begin_.middle).y / 2;
        guide_ = lineOf(begin_.middle, end_.middle);
    }

    void count(uint64 wanted)
    {
        const bool isUniform = isOneBin_ && areAlike();
        for (; wanted != 0; wanted &= wanted - 1)
        {
            const int place = lowestBit(wanted), i = place / SQUARE, j = place % SQUARE;
            const LaneLine line = isReversed_ ? lineOf(j, i) : lineOf(i, j);
            if (isUniform)
            {
                add(line, place, bin_);
                continue;
            }
            const Chord chord = {first_.s + i, first_.e + j};
            if (fits(guide_) && fits(line))
                add(line, place, isOneBin_ ? bin_ : directionBin(planes_.frame(), chord));
            else
                votes_[place] = counter_.votes(chord);
        }
        for (int k = 0; k < 4; ++k)
            if (groups_[k].lanes.count > 0)
                finish(k);
    }

private:
    //! Lanes over the same plane that all fall or do not, and whose votes they are.
    struct Group
    {
        ChordLanes lanes;
        uchar places[ChordLanes::COUNT];
        int firstColumn, lastColumn;
        Group() { clear(); }
        void clear()
        {
            lanes.count = 0;
            firstColumn = INT_MAX;
            lastColumn = -1;
        }
    };

    static int lowestBit(uint64 bits)
    {
        const unsigned low = (unsigned)bits;
        return (int)(low != 0 ? trailingZeros32(low)
                              : 32 + trailingZeros32((unsigned)(bits >> 32)));
    }
    static void transpose(BorderRun& run)
    {
        std::swap(run.first.x, run.first.y);
        std::swap(run.step.x, run.step.y);
    }

    //! An end that moves along a side turns the chord one way, so the directions of all chords are
    //! between those of the outermost.
    bool haveOneBin(int bin) const
    {
        for (int corner = 0; corner < 4; ++corner)
        {
            const Point across =
                end_.at(corner & 1 ? SQUARE - 1 : 0) - begin_.at(corner & 2 ? SQUARE - 1 : 0);
            if (directionBin(across.x, across.y) != bin)
                return false;
        }
        return true;
    }

    //! Whether all chords fit and fall, or none: dx and dy are largest and least at the corners.
    bool areAlike() const
    {
        bool result = fits(guide_);
        for (int corner = 0; corner < 4; ++corner)
        {
            const LaneLine line = lineOf(corner & 1 ? SQUARE - 1 : 0, corner & 2 ? SQUARE - 1 : 0);
            result = result && fits(line) && (line.dy < 0) == (guide_.dy < 0);
        }
        return result;
    }

    LaneLine lineOf(int beginIndex, int endIndex) const
    {
        const Point p = begin_.at(beginIndex), q = end_.at(endIndex);
        const LaneLine line = {p.x, p.y - 2 * origin_, q.x - p.x, q.y - p.y};
        return line;
    }

    bool fits(const LaneLine& line) const
    {
        return line.dx >= ChordLanes::LEAST_DX && line.dx <= ChordLanes::MOST_DX &&
               line.dy < line.dx && (xMajor_ ? -line.dy <= line.dx : -line.dy < line.dx);
    }

    void add(const LaneLine& line, int place, int bin)
    {
        const int which =
            2 * (planes_.isOriented() && EdgePlanes::planeOf(bin) == EdgePlanes::HIGH_BITS) +
            (line.dy < 0);
        Group& group = groups_[which];
        group.places[group.lanes.count] = (uchar)place;
        group.lanes.add(line, EdgePlanes::bitOf(bin));
        group.firstColumn = std::min(group.firstColumn, line.x / 2);
        group.lastColumn = std::max(group.lastColumn, (line.x + line.dx - 1) / 2);
        if (group.lanes.count == ChordLanes::COUNT)
            finish(which);
    }

    void finish(int which)
    {
        Group& group = groups_[which];
        ChordLanes& lanes = group.lanes;
        const int count = lanes.count;
        while (lanes.count < ChordLanes::COUNT) // copies that nobody asks for
            lanes.add(lanes.line(0), 0);
        const EdgePlanes::Plane* const planes = planes_.across(xMajor_);
        const int plane = !planes_.isOriented() ? EdgePlanes::VOTES
                          : which >= 2          ? EdgePlanes::HIGH_BITS
                                                : EdgePlanes::LOW_BITS;
        LaneMap map;
        map.votes = planes_.has(EdgePlanes::VOTES) ? planes[EdgePlanes::VOTES].row(0) + origin_ : 0;
        map.bits = planes_.isOriented() ? planes[plane].row(0) + origin_ : 0;
        map.weighted = planes_.isWeighted();
        map.stride = planes[plane].stride;
        map.firstColumn = group.firstColumn;
        map.columns = group.lastColumn + 1 - group.firstColumn;
        map.guide = guide_;
        map.falling = which % 2 == 1;
        int sums[ChordLanes::COUNT];
        countChordLanes(lanes, map, sums);
        for (int k = 0; k < count; ++k)
            votes_[group.places[k]] = sums[k];
        group.clear();
    }

    const ChordCounter& counter_;
    const EdgePlanes& planes_;
    const Chord first_;
    int* const votes_;
    BorderRun begin_, end_;
    bool xMajor_, isReversed_, isOneBin_;
    int bin_, origin_;
    LaneLine guide_;
    Group groups_[4];
};

} // namespace

void ChordCounter::countSquare(Chord first, uint64 wanted, int* votes) const
{
    if (hasChordLanes())
        SquareLanes(*this, planes_, first, votes).count(wanted);
    else
        countDiagonals(first, wanted, votes);
}

int ChordCounter::together()
{
    return hasChordLanes() ? (int)ChordLanes::COUNT : 1;
}

void ChordCounter::countDiagonals(Chord first, uint64 wanted, int* votes) const
{
    const bool areParallel = frame_.sideOf(first.e) == frame_.sideOf(first.s) + 2;
    for (int diagonal = 0; diagonal < 2 * SQUARE - 1; ++diagonal)
    {
        const int begin = std::max(0, diagonal - (SQUARE - 1)),
                  end = std::min(diagonal, SQUARE - 1);
        int lowest = -1, highest = -1;
        for (int i = begin; i <= end; ++i)
            if (wanted >> (i * SQUARE + diagonal - i) & 1)
            {
                lowest = lowest < 0 ? i : lowest;
                highest = i;
            }
        if (lowest < 0)
            continue;
        int parallel[PARALLEL];
        const Chord chord = {first.s + lowest, first.e + diagonal - lowest};
        const bool isCounted = areParallel && highest > lowest && countParallel(chord, parallel);
        for (int i = lowest; i <= highest; ++i)
            if (wanted >> (i * SQUARE + diagonal - i) & 1)
            {
                const Chord one = {first.s + i, first.e + diagonal - i};
                votes[i * SQUARE + diagonal - i] =
                    isCounted ? parallel[i - lowest] : this->votes(one);
            }
    }
}

} // namespace linespace
} // namespace cv
