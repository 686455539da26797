// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "vote_squares.hpp"

namespace cv {
namespace linespace {

namespace {

const int SQUARE = VoteSquares::SQUARE;
static_assert(SQUARE == 8, "a square's chords are the bits of 64");

Cell runsOf(const Cell& frame)
{
    return Cell((frame.width + SQUARE - 1) / SQUARE, (frame.height + SQUARE - 1) / SQUARE);
}

//! The rows, or columns, of a square from one to another.
inline uint64 rowsFrom(int first, int last)
{
    return ~(uint64)0 << SQUARE * first & ~(uint64)0 >> SQUARE * (SQUARE - 1 - last);
}
inline uint64 columnsFrom(int first, int last)
{
    return (uint64)(0xff << first & 0xff >> (SQUARE - 1 - last)) * 0x0101010101010101;
}

//! The part of positions first to last that is in the k-th run.
inline void clipToRun(int k, int& first, int& last)
{
    first = std::max(first - SQUARE * k, 0);
    last = std::min(last - SQUARE * k, SQUARE - 1);
}

} // namespace

double VoteSquares::memory(const Cell& frame)
{
    return (double)runsOf(frame).chordCount() * sizeof(int);
}

double VoteSquares::squareMemory(const Cell& frame, double squares)
{
    // A vector that grows holds its old contents as well for a moment.
    return std::min(squares, (double)runsOf(frame).chordCount()) *
           (3 * sizeof(Square) + 2 * sizeof(int));
}

void VoteSquares::clear()
{
    std::vector<int>().swap(slots_);
    std::vector<Square>().swap(squares_);
    std::vector<int>().swap(wanted_);
}

void VoteSquares::reset(const Cell& frame)
{
    frame_ = frame;
    runs_ = runsOf(frame);
    slots_.assign(runs_.chordCount(), -1);
    squares_.clear();
    wanted_.clear();
}

VoteSquares::Place VoteSquares::placeOf(Chord chord) const
{
    const int sideS = frame_.sideOf(chord.s), sideE = frame_.sideOf(chord.e);
    const int u = chord.s - frame_.firstPoint(sideS), v = chord.e - frame_.firstPoint(sideE);
    const Place place = {runs_.chordIndex(runs_.firstPoint(sideS) + u / SQUARE,
                                          runs_.firstPoint(sideE) + v / SQUARE),
                         u % SQUARE, v % SQUARE};
    return place;
}

VoteSquares::Square& VoteSquares::squareAt(size_t index, int s, int e)
{
    int& slot = slots_[index];
    if (slot < 0)
    {
        slot = (int)squares_.size();
        squares_.push_back(Square());
        squares_.back().s = s;
        squares_.back().e = e;
    }
    return squares_[slot];
}

bool VoteSquares::mark(Chord chord)
{
    const Place place = placeOf(chord);
    Square& square = squareAt(place.square, chord.s - place.row, chord.e - place.column);
    const uint64 bit = (uint64)1 << (SQUARE * place.row + place.column);
    const bool isNew = (square.marked & bit) == 0;
    square.marked |= bit;
    return isNew;
}

void VoteSquares::wantOf(Square& square, uint64 chords)
{
    chords &= ~square.counted;
    if (square.wanted == 0 && chords != 0)
        wanted_.push_back((int)(&square - &squares_[0]));
    square.wanted |= chords;
}

VoteSquares::Around VoteSquares::around(Chord chord, int radius) const
{
    const int sideS = frame_.sideOf(chord.s), sideE = frame_.sideOf(chord.e);
    const int u = chord.s - frame_.firstPoint(sideS), v = chord.e - frame_.firstPoint(sideE);
    const Around result = {sideS, sideE, u - radius, u + radius, v - radius, v + radius};
    return result;
}

bool VoteSquares::isInside(const Around& around) const
{
    return std::min(around.firstU, around.firstV) >= 0 &&
           around.lastU < frame_.pointCount(around.sideS) &&
           around.lastV < frame_.pointCount(around.sideE);
}

//! Calls visit(p, q), in either order, for the chords of a neighbourhood across corners.
template<class Visit>
void VoteSquares::forEachOnRing(Chord chord, int radius, Visit visit) const
{
    const int points = frame_.borderCount();
    for (int i = -radius; i <= radius; ++i)
        for (int j = -radius; j <= radius; ++j)
        {
            const int p = (chord.s + i + points) % points, q = (chord.e + j + points) % points;
            const Chord neighbour = {std::min(p, q), std::max(p, q)};
            if (frame_.isChord(p, q))
                visit(neighbour);
        }
}

void VoteSquares::want(Chord chord, int radius)
{
    const Around own = around(chord, radius);
    if (!isInside(own))
    {
        forEachOnRing(chord, radius,
                      [this](Chord neighbour)
                      {
                          const Place place = placeOf(neighbour);
                          Square& square = squareAt(place.square, neighbour.s - place.row,
                                                    neighbour.e - place.column);
                          wantOf(square, (uint64)1 << (SQUARE * place.row + place.column));
                      });
        return;
    }
    const int runS = runs_.firstPoint(own.sideS), runE = runs_.firstPoint(own.sideE);
    const int firstS = frame_.firstPoint(own.sideS), firstE = frame_.firstPoint(own.sideE);
    for (int k = own.firstU / SQUARE; k <= own.lastU / SQUARE; ++k)
        for (int l = own.firstV / SQUARE; l <= own.lastV / SQUARE; ++l)
        {
            int top = own.firstU, bottom = own.lastU, left = own.firstV, right = own.lastV;
            clipToRun(k, top, bottom);
            clipToRun(l, left, right);
            wantOf(squareAt(runs_.chordIndex(runS + k, runE + l), firstS + SQUARE * k,
                            firstE + SQUARE * l),
                   rowsFrom(top, bottom) & columnsFrom(left, right));
        }
}

void VoteSquares::countWanted(const ChordCounter& counter)
{
    const auto countRange = [&](const Range& range)
    {
        for (int i = range.start; i < range.end; ++i)
        {
            Square& square = squares_[wanted_[i]];
            const Chord first = {square.s, square.e};
            counter.countSquare(first, square.wanted, square.votes);
            square.counted |= square.wanted;
            square.wanted = 0;
        }
    };
    const Range all(0, (int)wanted_.size());
    if (all.end < 8) // not worth waking up other threads
        countRange(all);
    else
        parallel_for_(all, countRange, 8 * std::max(1, getNumThreads()));
    wanted_.clear();
}

Candidate VoteSquares::strongestAround(Chord chord, int radius) const
{
    Candidate best = {-1, 0, 0};
    const Around own = around(chord, radius);
    if (!isInside(own))
    {
        forEachOnRing(chord, radius,
                      [&](Chord neighbour)
                      {
                          const Place place = placeOf(neighbour);
                          const Square& square = squares_[slots_[place.square]];
                          const int bit = SQUARE * place.row + place.column;
                          CV_DbgAssert(square.counted >> bit & 1);
                          const Candidate other = {square.votes[bit], neighbour.s, neighbour.e};
                          if (isStronger(other, best))
                              best = other;
                      });
        return best;
    }
    // Votes, and below them what orders equal ones: the first one has the most.
    int64 strongest = -1;
    const int side = 2 * radius + 1;
    const int runS = runs_.firstPoint(own.sideS), runE = runs_.firstPoint(own.sideE);
    for (int k = own.firstU / SQUARE; k <= own.lastU / SQUARE; ++k)
        for (int l = own.firstV / SQUARE; l <= own.lastV / SQUARE; ++l)
        {
            int top = own.firstU, bottom = own.lastU, left = own.firstV, right = own.lastV;
            clipToRun(k, top, bottom);
            clipToRun(l, left, right);
            const Square& square = squares_[slots_[runs_.chordIndex(runS + k, runE + l)]];
            for (int i = top; i <= bottom; ++i)
                for (int j = left; j <= right; ++j)
                {
                    CV_DbgAssert(square.counted >> (SQUARE * i + j) & 1);
                    const int row = SQUARE * k + i - own.firstU,
                              column = SQUARE * l + j - own.firstV;
                    strongest = std::max(strongest, (int64)square.votes[SQUARE * i + j] * 32 + 31 -
                                                        (row * side + column));
                }
        }
    const int place = 31 - (int)(strongest % 32);
    best.votes = (int)(strongest / 32);
    best.s = chord.s - radius + place / side;
    best.e = chord.e - radius + place % side;
    return best;
}

} // namespace linespace
} // namespace cv
