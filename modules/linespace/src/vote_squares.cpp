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

const int SIDE = 5; // of the largest neighbourhood

/** The first of the chords with the most votes, by numbers that have the votes in their high bits,
and below them 31 less the chord's place. Votes are below 2^26: the frame's sides would have to be
263,173 pixels for more, 255 each, and the table of votes 2^36 entries. */
class Strongest
{
public:
    /** For rows of two neighbouring squares, or the same one twice: columns left to right, those
    from SQUARE on in the second one. */
    Strongest(int left, int right) : left_(left), right_(right)
    {
#if !LINESPACE_SIMD128
        most_ = 0;
#else
        low_ = high_ = v_setzero_s32();
        // 8 of these from SQUARE - left on begin at column left, and so on.
        static const int EDGE[3 * SQUARE] = {0,  0,  0,  0,  0, 0, 0, 0, -1, -1, -1, -1,
                                             -1, -1, -1, -1, 0, 0, 0, 0, 0,  0,  0,  0};
        const int *const from = EDGE + SQUARE - left,
                         *const to = EDGE + 2 * SQUARE - 1 - std::min(right, SQUARE - 1),
                         *const beyond = EDGE + 2 * SQUARE - 1 - std::max(right - SQUARE, -1);
        firstLow_ = v_and(v_load(from), v_load(to));
        firstHigh_ = v_and(v_load(from + 4), v_load(to + 4));
        secondLow_ = v_load(beyond);
#endif
    }

#if LINESPACE_SIMD128
    //! A row whose first column, in or out, has a place. (No neighbourhood reaches the second
    //! square's column 4.)
    void addRow(const int* first, const int* second, int place)
    {
        const v_int32x4 four = v_setall_s32(4),
                        order = v_sub(v_int32x4(31, 30, 29, 28), v_setall_s32(place)),
                        next = v_sub(order, four);
        low_ = v_max(low_, v_and(numbered(first, order), firstLow_));
        high_ = v_max(high_, v_and(numbered(first + 4, next), firstHigh_));
        low_ = v_max(low_, v_and(numbered(second, v_sub(next, four)), secondLow_));
    }
    void get(int& votes, int& place) const
    {
        const int most = v_reduce_max(v_max(low_, high_));
        votes = most >> 5;
        place = 31 - most % 32;
    }
#else
    void addRow(const int* first, const int* second, int place)
    {
        for (int j = left_; j <= right_; ++j)
        {
            const int votes = j < SQUARE ? first[j] : second[j - SQUARE];
            most_ = std::max(most_, votes * 32 + 31 - (place + j));
        }
    }
    void get(int& votes, int& place) const
    {
        votes = most_ >> 5;
        place = 31 - most_ % 32;
    }
#endif

private:
#if LINESPACE_SIMD128
    //! Votes of four chords with what is below them.
    static v_int32x4 numbered(const int* votes, const v_int32x4& order)
    {
        return v_add(v_shl<5>(v_load(votes)), order);
    }
#endif

    int left_, right_;
#if LINESPACE_SIMD128
    v_int32x4 low_, high_, firstLow_, firstHigh_, secondLow_;
#else
    int most_;
#endif
};

} // namespace

double VoteSquares::memory(const Cell& frame, bool hasPieces)
{
    double bytes = (double)VoteSquares::runsOf(frame).chordCount() * sizeof(int);
    if (hasPieces)
        for (int pair = 0; pair < 2; ++pair)
            bytes += EdgePieces::memory(frame, pair == 0) + (2. * frame.pointCount(pair) - 1) *
                                                                wordsOf(frame.pointCount(pair)) *
                                                                sizeof(uint64);
    return bytes;
}

double VoteSquares::squareMemory(const Cell& frame, double squares)
{
    // A vector that grows holds its old contents as well for a moment.
    return std::min(squares, (double)VoteSquares::runsOf(frame).chordCount()) *
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
    runs_ = VoteSquares::runsOf(frame_);
    slots_.assign(runs_.chordCount(), -1);
    squares_.clear();
    wanted_.clear();
    for (int s = SIDE_TOP; s < SIDE_LEFT; ++s)
    {
        rowLengths_[s] = runs_.rowLength(s);
        for (int e = s + 1; e <= SIDE_LEFT; ++e)
            firstSquares_[s][e] = runs_.chordIndex(runs_.firstPoint(s), runs_.firstPoint(e));
    }
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
    pair.words = wordsOf(pair.length);
    pair.strips.assign(pair.mayHavePieces ? (2 * (size_t)pair.length - 1) * pair.words : 0, 0);
}

VoteSquares::Position VoteSquares::positionOf(Chord chord) const
{
    const int sideS = frame_.sideOf(chord.s), sideE = frame_.sideOf(chord.e);
    const Position position = {sideS, sideE, chord.s - frame_.firstPoint(sideS),
                               chord.e - frame_.firstPoint(sideE)};
    return position;
}

VoteSquares::Place VoteSquares::placeOf(Chord chord) const
{
    const Position position = positionOf(chord);
    const Place place = {
        squareOf(position.sideS, position.sideE, position.u / SQUARE, position.w / SQUARE),
        position.u % SQUARE, position.w % SQUARE};
    return place;
}

inline VoteSquares::Square& VoteSquares::squareAt(size_t index, int s, int e)
{
    const int slot = slots_[index];
    return slot >= 0 ? squares_[slot] : addSquare(index, s, e);
}

VoteSquares::Square& VoteSquares::addSquare(size_t index, int s, int e)
{
    slots_[index] = (int)squares_.size();
    squares_.push_back(Square());
    squares_.back().s = s;
    squares_.back().e = e;
    return squares_.back();
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

//! Whether a neighbourhood keeps to the sides of its middle.
bool VoteSquares::isInside(const Position& position, int radius) const
{
    return std::min(position.u, position.w) >= radius &&
           position.u + radius < frame_.pointCount(position.sideS) &&
           position.w + radius < frame_.pointCount(position.sideE);
}

/** Calls visit(runS, runE, top, bottom, left, right) for the squares that a neighbourhood inside
its sides meets, and which rows and columns of them. */
template<class Visit>
inline void VoteSquares::forEachPart(const Position& position, int radius, Visit visit) const
{
    const int firstU = position.u - radius, lastU = position.u + radius;
    const int firstW = position.w - radius, lastW = position.w + radius;
    for (int k = firstU / SQUARE; k <= lastU / SQUARE; ++k)
        for (int l = firstW / SQUARE; l <= lastW / SQUARE; ++l)
            visit(k, l, std::max(firstU - SQUARE * k, 0), std::min(lastU - SQUARE * k, SQUARE - 1),
                  std::max(firstW - SQUARE * l, 0), std::min(lastW - SQUARE * l, SQUARE - 1));
}

//! Calls visit(chord) for those of a neighbourhood across corners.
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
    const Position middle = positionOf(chord);
    if (!isInside(middle, radius))
    {
        mark(chord);
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
    forEachPart(middle, radius,
                [&](int runS, int runE, int top, int bottom, int left, int right)
                {
                    const int row = middle.u - SQUARE * runS, column = middle.w - SQUARE * runE;
                    Square& square = squareAt(squareOf(middle.sideS, middle.sideE, runS, runE),
                                              chord.s - row, chord.e - column);
                    wantOf(square, rowsFrom(top, bottom) & columnsFrom(left, right));
                    if ((unsigned)row < (unsigned)SQUARE && (unsigned)column < (unsigned)SQUARE)
                        square.marked |= (uint64)1 << (SQUARE * row + column);
                });
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
        Square& square = squares_[wanted_[i]];
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
    const bool suits =
        -family < pairs_[side].columns && family + DIAGONALS - 1 < pairs_[side].columns;
    return suits ? side : -1;
}

/** Calls visit(square, row, column, u, count) for the parts of a strip in the squares there are: u
is the first of `count` chords there, each a row below and a column before the last. */
template<class Visit>
inline void VoteSquares::forEachPartOfStrip(const Pair& pair, int family, int start, Visit visit)
{
    const int side = &pair == &pairs_[SIDE_TOP] ? SIDE_TOP : SIDE_RIGHT;
    const int end = std::min(start + PARALLEL, pair.length + std::min(0, family));
    for (int u = std::max(start, family); u < end;)
    {
        const int w = pair.length - 1 - (u - family), row = u % SQUARE, column = w % SQUARE;
        const int count = std::min(std::min(SQUARE - row, column + 1), end - u);
        const int slot = slots_[squareOf(side, side + 2, u / SQUARE, w / SQUARE)];
        if (slot >= 0)
            visit(squares_[slot], row, column, u, count);
        u += count;
    }
}

void VoteSquares::wantStrips(Pair& pair, Square& square)
{
    const int side = &pair == &pairs_[SIDE_TOP] ? SIDE_TOP : SIDE_RIGHT;
    const int strip = (square.s - frame_.firstPoint(side)) / PARALLEL;
    const int first = familyOf(pair, square) + pair.length - 1;
    uint64* const words = pair.strips.data() + strip / 64;
    for (int k = 0; k < DIAGONALS; ++k)
        if (square.wanted & diagonal(k))
        {
            uint64& word = words[(ptrdiff_t)(first + k) * (ptrdiff_t)pair.words];
            const uint64 bit = (uint64)1 << strip % 64;
            if (!(word & bit))
                forEachPartOfStrip(pair, first + k - (pair.length - 1), strip * PARALLEL,
                                   [](Square& part, int row, int column, int, int)
                                   { part.counted |= diagonal(row + column); });
            word |= bit;
        }
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
                    takeVotes(pair, wanted[k].difference, starts[strip], &votes[strip * PARALLEL]);
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
    forEachPartOfStrip(pair, family, start,
                       [=](Square& square, int row, int column, int u, int count)
                       {
                           int* const own = square.votes + SQUARE * row + column;
                           for (int i = 0; i < count; ++i)
                               own[(SQUARE - 1) * i] = votes[u - start + i];
                       });
}

//! Where some more are counted in the same time, asks for neighbours of what is wanted: the next
//! step may need them.
void VoteSquares::fill(Square& square, int together) const
{
    int room = 0;
    for (uint64 left = square.wanted; left != 0; left &= left - 1)
        --room;
    const int sideS = frame_.sideOf(square.s), sideE = frame_.sideOf(square.e);
    const int lastRow = frame_.firstPoint(sideS) + frame_.pointCount(sideS) - 1 - square.s,
              lastColumn = frame_.firstPoint(sideE) + frame_.pointCount(sideE) - 1 - square.e;
    uint64 near = square.wanted;
    for (int distance = 0; distance < 2; ++distance)
    {
        near |= near << SQUARE | near >> SQUARE;
        near |= (near & columnsFrom(0, SQUARE - 2)) << 1 | (near & columnsFrom(1, SQUARE - 1)) >> 1;
    }
    near &= ~(square.wanted | square.counted) & rowsFrom(0, std::min(lastRow, SQUARE - 1)) &
            columnsFrom(0, std::min(lastColumn, SQUARE - 1));
    for (room = (room % together + together) % together; room > 0 && near != 0; --room)
    {
        square.wanted |= near & (~near + 1);
        near &= near - 1;
    }
}

void VoteSquares::countAlone()
{
    const ChordCounter counter(*planes_);
    const int together = ChordCounter::together();
    const auto countRange = [&](const Range& range)
    {
        for (int i = range.start; i < range.end; ++i)
        {
            Square& square = squares_[alone_[i]];
            if (together > 1)
                fill(square, together);
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

Candidate VoteSquares::strongestAcrossCorners(Chord chord, int radius) const
{
    Candidate best = {-1, 0, 0};
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

Candidate VoteSquares::strongestAround(Chord chord, int radius) const
{
    const Position middle = positionOf(chord);
    if (!isInside(middle, radius))
        return strongestAcrossCorners(chord, radius);
    // Up to four squares, all of which are looked at: where a neighbourhood is among them is as
    // good as random, and wrong guesses of that cost more.
    const int firstU = middle.u - radius, firstW = middle.w - radius;
    const int left = firstW % SQUARE, right = left + 2 * radius;
    const int runS = firstU / SQUARE, runE = firstW / SQUARE;
    const int lastS = (middle.u + radius) / SQUARE, lastE = (middle.w + radius) / SQUARE;
    const int* const votes[2][2] = {{votesOf(middle, runS, runE), votesOf(middle, runS, lastE)},
                                    {votesOf(middle, lastS, runE), votesOf(middle, lastS, lastE)}};
    Strongest strongest(left, right);
    for (int i = 0; i <= 2 * radius; ++i)
    {
        const int row = firstU % SQUARE + i;
        const int* const* const pair = votes[row / SQUARE];
        const int offset = SQUARE * (row % SQUARE);
        strongest.addRow(pair[0] + offset, pair[1] + offset, SIDE * i - left);
    }
    int most, place;
    strongest.get(most, place);
    const Candidate result = {most, chord.s - radius + place / SIDE,
                              chord.e - radius + place % SIDE};
    return result;
}

} // namespace linespace
} // namespace cv
