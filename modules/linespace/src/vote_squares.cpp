// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "vote_squares.hpp"

#include "vectors.hpp"

namespace cv {
namespace linespace {

namespace {

const int SQUARE = VoteSquares::SQUARE;
const int PARALLEL = EdgePieces::PARALLEL;
// Opposite sides are worth their pieces from so many squares on; these take what some tens take.
const size_t LEAST_SQUARES = 64;
static_assert(PARALLEL % SQUARE == 0, "a strip is of whole runs");
static_assert(SQUARE == 8, "a square's chords are the bits of 64");

Cell runsOf(const Cell& frame)
{
    return Cell((frame.width + SQUARE - 1) / SQUARE, (frame.height + SQUARE - 1) / SQUARE);
}

//! Words with a bit for each strip of a family, of a side's length at most.
size_t wordsOf(int length)
{
    return ((size_t)length + 64 * PARALLEL - 1) / (64 * PARALLEL);
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

const int DIAGONALS = 2 * SQUARE - 1;

//! The chords (i, k - i) of a square, which are parallel between opposite sides.
inline uint64 diagonal(int k)
{
    // The longest one, shifted by as many columns, without what leaves the square.
    const uint64 longest = 0x0102040810204080;
    return k < SQUARE ? longest >> SQUARE * (SQUARE - 1 - k) : longest << SQUARE * (k - SQUARE + 1);
}

inline int lowestBit(uint64 bits)
{
    const unsigned low = (unsigned)bits;
    return (int)(low != 0 ? trailingZeros32(low) : 32 + trailingZeros32((unsigned)(bits >> 32)));
}

//! The part of positions first to last that is in the k-th run.
inline void clipToRun(int k, int& first, int& last)
{
    first = std::max(first - SQUARE * k, 0);
    last = std::min(last - SQUARE * k, SQUARE - 1);
}

} // namespace

double VoteSquares::memory(const Cell& frame, bool hasPieces)
{
    double bytes = (double)runsOf(frame).chordCount() * sizeof(int);
    if (hasPieces)
        for (int pair = 0; pair < 2; ++pair)
            bytes += EdgePieces::memory(frame, pair == 0) +
                     (2. * frame.pointCount(pair) - 1) * wordsOf(frame.pointCount(pair)) *
                         sizeof(uint64);
    return bytes;
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
    std::vector<int>().swap(alone_);
    for (int i = 0; i < 2; ++i)
    {
        pairs_[i].pieces.clear();
        std::vector<uint64>().swap(pairs_[i].strips);
    }
}

void VoteSquares::reset(const EdgePlanes& planes)
{
    planes_ = &planes;
    frame_ = planes.frame();
    runs_ = runsOf(frame_);
    slots_.assign(runs_.chordCount(), -1);
    squares_.clear();
    wanted_.clear();
    resetPair(SIDE_TOP);
    resetPair(SIDE_RIGHT);
}

void VoteSquares::resetPair(int side)
{
    Pair& pair = pairs_[side];
    pair.mayHavePieces = EdgePieces::suits(*planes_, side == SIDE_TOP);
    pair.hasPieces = false;
    pair.length = frame_.pointCount(side);
    pair.columns = frame_.pointCount(1 - side);
    pair.firstSquare = runs_.chordIndex(runs_.firstPoint(side), runs_.firstPoint(side + 2));
    pair.rowSquares = runs_.rowLength(side);
    pair.words = wordsOf(pair.length);
    pair.strips.assign(pair.mayHavePieces ? (2 * (size_t)pair.length - 1) * pair.words : 0, 0);
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

void VoteSquares::countWanted()
{
    size_t counts[2] = {0, 0};
    for (size_t i = 0; i < wanted_.size(); ++i)
    {
        const int pair = pairOf(squares_[wanted_[i]]);
        if (pair >= 0)
            ++counts[pair];
    }
    for (int i = 0; i < 2; ++i)
        if (pairs_[i].mayHavePieces && !pairs_[i].hasPieces && counts[i] >= LEAST_SQUARES)
        {
            pairs_[i].pieces.reset(*planes_, i == SIDE_TOP);
            pairs_[i].hasPieces = true;
        }
    alone_.clear();
    for (size_t i = 0; i < wanted_.size(); ++i)
    {
        const Square& square = squares_[wanted_[i]];
        const int pair = pairOf(square);
        if (pair >= 0 && pairs_[pair].hasPieces)
            wantStrips(pairs_[pair], square);
        else
            alone_.push_back(wanted_[i]);
    }
    for (int i = 0; i < 2; ++i)
        if (counts[i] > 0 && pairs_[i].hasPieces)
            countStrips(pairs_[i]);
    countAlone();
    for (size_t i = 0; i < wanted_.size(); ++i)
    {
        Square& square = squares_[wanted_[i]];
        square.counted |= square.wanted;
        square.wanted = 0;
    }
    wanted_.clear();
}

//! The family of a square's first chord, u - v; those of the others are higher.
int VoteSquares::familyOf(const Pair& pair, const Square& square) const
{
    const int side = &pair == &pairs_[SIDE_TOP] ? SIDE_TOP : SIDE_RIGHT;
    return square.s - frame_.firstPoint(side) -
           (pair.length - 1 - (square.e - frame_.firstPoint(side + 2)));
}

//! The pair of sides whose pieces a square can be counted with; -1: none.
int VoteSquares::pairOf(const Square& square) const
{
    const int side = frame_.sideOf(square.s);
    if (side > SIDE_RIGHT || frame_.sideOf(square.e) != side + 2)
        return -1;
    // All its chords must be steeper than diagonals.
    const int family = familyOf(pairs_[side], square);
    const bool suits = -family < pairs_[side].columns &&
                       family + DIAGONALS - 1 < pairs_[side].columns;
    return suits ? side : -1;
}

void VoteSquares::wantStrips(Pair& pair, const Square& square)
{
    const int side = &pair == &pairs_[SIDE_TOP] ? SIDE_TOP : SIDE_RIGHT;
    const int strip = (square.s - frame_.firstPoint(side)) / PARALLEL;
    const int first = familyOf(pair, square) + pair.length - 1;
    uint64* const words = pair.strips.data() + strip / 64;
    for (int k = 0; k < DIAGONALS; ++k)
        if (square.wanted & diagonal(k))
            words[(ptrdiff_t)(first + k) * (ptrdiff_t)pair.words] |= (uint64)1 << strip % 64;
}

void VoteSquares::countStrips(Pair& pair)
{
    // Families next to each other pass the same pixels, in the cache.
    const int atOnce = EdgePieces::MOST_FAMILIES, families = 2 * pair.length - 1;
    const auto countRange = [&](const Range& range)
    {
        std::vector<int> starts, votes;
        for (int i = range.start; i < range.end; ++i)
        {
            EdgePieces::Family wanted[atOnce];
            int count = 0;
            starts.clear();
            for (int k = atOnce * i; k < std::min(atOnce * (i + 1), families); ++k)
            {
                const size_t before = starts.size();
                takeStrips(pair, k, starts);
                wanted[count].difference = k - (pair.length - 1);
                wanted[count].strips = (int)(starts.size() - before);
                count += wanted[count].strips > 0;
            }
            votes.resize(starts.size() * PARALLEL);
            pair.pieces.count(wanted, count, starts.data(), votes.data());
            for (int k = 0, strip = 0; k < count; ++k)
                for (const int end = strip + wanted[k].strips; strip < end; ++strip)
                    takeVotes(pair, wanted[k].difference, starts[strip],
                              &votes[strip * PARALLEL]);
        }
    };
    parallel_for_(Range(0, (families + atOnce - 1) / atOnce), countRange,
                  8 * std::max(1, getNumThreads()));
}

//! Where the wanted strips of a family begin; they are not wanted any more.
void VoteSquares::takeStrips(Pair& pair, int family, std::vector<int>& starts) const
{
    uint64* const words = &pair.strips[(size_t)family * pair.words];
    for (size_t i = 0; i < pair.words; ++i)
    {
        for (uint64 left = words[i]; left != 0; left &= left - 1)
            starts.push_back((int)(64 * i + lowestBit(left)) * PARALLEL);
        words[i] = 0;
    }
}

//! Hands the votes of a strip to the squares there are.
void VoteSquares::takeVotes(const Pair& pair, int family, int start, const int* votes)
{
    const int end = std::min(start + PARALLEL, pair.length + std::min(0, family));
    for (int u = std::max(start, family); u < end;)
    {
        // In a square, the next chord is a row below and a column before.
        const int w = pair.length - 1 - (u - family), row = u % SQUARE, column = w % SQUARE;
        const int count = std::min(std::min(SQUARE - row, column + 1), end - u);
        const int slot = slots_[pair.firstSquare + u / SQUARE * pair.rowSquares + w / SQUARE];
        if (slot >= 0)
        {
            int* const own = squares_[slot].votes + SQUARE * row + column;
            for (int i = 0; i < count; ++i)
                own[(SQUARE - 1) * i] = votes[u - start + i];
        }
        u += count;
    }
}

void VoteSquares::countAlone()
{
    const ChordCounter counter(*planes_);
    const auto countRange = [&](const Range& range)
    {
        for (int i = range.start; i < range.end; ++i)
        {
            Square& square = squares_[alone_[i]];
            const Chord first = {square.s, square.e};
            counter.countSquare(first, square.wanted, square.votes);
        }
    };
    const Range all(0, (int)alone_.size());
    if (all.end < 8) // not worth waking up other threads
        countRange(all);
    else
        parallel_for_(all, countRange, 8 * std::max(1, getNumThreads()));
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
