// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The inner loops of the search by bundles (bundles.hpp), compiled once per instruction set and
// chosen at run time (bundles.cpp). Every function takes some rows of bundles, so rows can be
// shared out to threads; all but `require` write what belongs to these rows alone.

#include "bundles.hpp"
#include "vectors.hpp"

namespace cv {
namespace linespace {

CV_CPU_OPTIMIZATION_NAMESPACE_BEGIN

/** Bounds of the first level: of each bundle and cell, the most votes in the table.
@param rows of bundles, numbered as the border points of level.coarse. */
void poolVotes(const VoteTable& table, const Cell& cell, const Range& rows, BundleLevel& level);

//! Bounds of a level from those of its children.
void mergeBounds(const Merge& merge, const BundleLevel& child, const Range& rows,
                 BundleLevel& parent);

//! How many bundles of these rows are needed.
size_t countNeeded(const Range& rows, const BundleLevel& level);

/** Gives the needed bundles of these rows slots from `slot` on, and finds what they cross.
@param merge to the level; null: it is the first one. */
void assignSlots(const Merge* merge, const Range& rows, int slot, BundleLevel& level);

/** Requires of the bundles of children what those of the parent that are needed ask for.
@param part of `parts`: which of the children's bundles. No two parts write the same, so threads can
share them out. */
void require(const Merge& merge, const BundleLevel& parent, int part, int parts,
             BundleLevel& child);

//! Votes of the bundles with a slot, of the first level.
void takeVotes(const VoteTable& table, const Cell& cell, const Range& rows, BundleLevel& level);

//! Votes of the bundles with a slot from the children's.
void mergeVotes(const Merge& merge, const BundleLevel& child, const Range& rows,
                BundleLevel& parent);

/** Appends the chords of these rows, of the last level, that were counted and have more votes.
@param isAlone whether a chord can stand beside a stronger parallel one. If not, some that cannot be
maxima are left out. */
void collectAbove(int votes, bool isAlone, const Range& rows, const BundleLevel& level,
                  std::vector<Candidate>& found);

#ifndef CV_CPU_OPTIMIZATION_DECLARATIONS_ONLY

namespace {

const int SIDE = BUNDLE_SIDE;

//! The bundles of some rows, as indices of the level's arrays.
struct BundleRange
{
    size_t begin, end;

    BundleRange(const Range& rows, const BundleLevel& level)
    {
        const Cell& coarse = level.coarse;
        begin = coarse.rowStart(rows.start) * level.cells;
        end = rows.end < coarse.firstPoint(SIDE_LEFT) ? coarse.rowStart(rows.end) * level.cells
                                                      : level.bundleCount();
    }
};

//! Cells > 0 is the number of cells known when compiling.
template<int Cells, class Votes>
void poolVotesOf(const Votes* votes, const Cell& cell, const Range& rows, BundleLevel& level)
{
    const size_t n = Cells > 0 ? (size_t)Cells : level.cells;
    for (int s = rows.start; s < rows.end; ++s)
    {
        const int side = level.coarse.sideOf(s), ends = level.coarse.rowLength(side);
        ushort* const bounds = &level.bounds[level.coarse.rowStart(s) * n];
        const ptrdiff_t rowLength = SIDE * ends * n;
        const Votes* run = votes + cell.rowStart(SIDE * s) * n;
        for (int e = 0; e < ends; ++e, run += SIDE * n)
            for (size_t c = 0; c < n; ++c)
            {
                Votes most = 0;
                for (int i = 0; i < SIDE; ++i)
                    for (int j = 0; j < SIDE; ++j)
                        most = std::max(most, run[i * rowLength + j * n + c]);
                bounds[e * n + c] = most;
            }
    }
}

template<class Votes>
void poolVotesFor(const Votes* votes, const Cell& cell, const Range& rows, BundleLevel& level)
{
    switch (level.cells)
    {
    case 2: return poolVotesOf<2>(votes, cell, rows, level);
    case 4: return poolVotesOf<4>(votes, cell, rows, level);
    case 8: return poolVotesOf<8>(votes, cell, rows, level);
    case 16: return poolVotesOf<16>(votes, cell, rows, level);
    default: return poolVotesOf<0>(votes, cell, rows, level);
    }
}

/** Bundles (s, s's partners e = firstEnd + i) of one row and one segment of it: where their chords
cross the shared side. */
class BundleCrossings
{
public:
    BundleCrossings(const Merge& merge, int s, const Segment& segment)
    {
        outermostCrossings(merge, SIDE, SIDE * s, SIDE * segment.firstEnd, least_, most_);
    }
    //! The bundles of the shared side that bundle i meets are first .. last.
    int first(int i) const { return least_.at(SIDE * i) / SIDE; }
    int last(int i) const { return most_.at(SIDE * i) / SIDE; }

private:
    CrossingRun least_, most_;
};

template<int Cells>
void mergeBoundsOf(const Merge& merge, const BundleLevel& child, const Range& rows,
                   BundleLevel& parent)
{
    const size_t n = Cells > 0 ? (size_t)Cells : parent.cells;
    const ptrdiff_t run = 2 * (ptrdiff_t)n;
    const Merge coarse(child.coarse, merge.horizontal);
    enum
    {
        BLOCK = 128
    };
    int first[BLOCK], last[BLOCK];
    for (int s = rows.start; s < rows.end; ++s)
    {
        Segment segments[MAX_SEGMENTS];
        const int count = rowSegments(coarse, s, segments);
        ushort* out = &parent.bounds[parent.coarse.rowStart(s) * n];
        for (int k = 0; k < count; ++k)
        {
            const Segment& segment = segments[k];
            const ushort* const a =
                child.bounds + segment.chordS * run + segment.childS * (ptrdiff_t)n;
            if (!segment.isCrossing)
            {
                for (int i = 0; i < segment.count; ++i, out += n)
                    for (size_t c = 0; c < n; ++c)
                        out[c] = a[i * run + c];
                continue;
            }
            const ushort* const b =
                child.bounds + segment.chordE * run + (1 - segment.childS) * (ptrdiff_t)n;
            const BundleCrossings crossings(merge, s, segment);
            for (int begin = 0; begin < segment.count; begin += BLOCK)
            {
                const int length = std::min<int>(BLOCK, segment.count - begin);
                for (int i = 0; i < length; ++i)
                {
                    first[i] = crossings.first(begin + i);
                    last[i] = crossings.last(begin + i);
                }
                for (int i = 0; i < length; ++i, out += n)
                {
                    const ushort* const own = b + (begin + i) * segment.stepE * run;
                    ushort most[Cells > 0 ? Cells : 1];
                    ushort* const best = Cells > 0 ? most : out;
                    for (size_t c = 0; c < n; ++c)
                        best[c] = 0;
                    // Most meet two or one, which makes no difference then.
                    const auto meet = [&](int m)
                    {
                        const ushort *partA = a + m * segment.strideS * run,
                                     *partB = own + m * segment.strideE * run;
                        for (size_t c = 0; c < n; ++c)
                            best[c] = std::max(best[c], (ushort)(partA[c] + partB[c]));
                    };
                    meet(first[i]);
                    meet(last[i]);
                    for (int m = first[i] + 1; m < last[i]; ++m)
                        meet(m);
                    if (Cells > 0)
                        for (size_t c = 0; c < n; ++c)
                            out[c] = best[c];
                }
            }
        }
    }
}

#if LINESPACE_SIMD128

//! Which of 16 bundles are needed, a bit each.
inline int neededBits(const ushort* required)
{
    const v_uint16x8 none = v_setall_u16((ushort)BundleLevel::NOT_NEEDED);
    return v_signmask(v_pack_b(v_ne(v_load(required), none), v_ne(v_load(required + 8), none)));
}

#else

inline int neededBits(const ushort* required)
{
    int bits = 0;
    for (int k = 0; k < 16; ++k)
        bits |= (required[k] != BundleLevel::NOT_NEEDED) << k;
    return bits;
}

#endif

/** Calls visit(index) for the bundles that are needed, and passes over stretches of others at
once. */
template<class Visit>
void forEachNeeded(const ushort* required, size_t count, Visit visit)
{
    const size_t stretch = 16;
    size_t i = 0;
    for (; i + stretch <= count; i += stretch)
        for (int bits = neededBits(required + i); bits != 0; bits &= bits - 1)
            visit(i + trailingZeros32(bits));
    for (; i < count; ++i)
        if (required[i] != BundleLevel::NOT_NEEDED)
            visit(i);
}

template<class Votes>
void takeVotesOf(const Votes* votes, const Cell& cell, const Range& rows, BundleLevel& level)
{
    const size_t n = level.cells;
    for (int s = rows.start; s < rows.end; ++s)
    {
        const size_t start = level.coarse.rowStart(s) * n;
        const size_t count = level.coarse.rowLength(level.coarse.sideOf(s)) * n;
        const ptrdiff_t rowLength = cell.rowLength(cell.sideOf(SIDE * s));
        const Votes* const row = votes + cell.rowStart(SIDE * s) * n;
        forEachNeeded(&level.required[start], count,
                      [&](size_t at)
                      {
                          ushort* out = level.votesOf(start + at);
                          const Votes* from =
                              row + (at >> level.cellBits) * SIDE * n + (at & (n - 1));
                          for (int i = 0; i < SIDE; ++i, from += rowLength * n)
                              for (int j = 0; j < SIDE; ++j)
                                  *out++ = (ushort)from[j * n];
                      });
    }
}

const ushort NO_VOTES[BUNDLE_CHORDS] = {};

inline const ushort* votesIfNeeded(const BundleLevel& level, size_t bundle)
{
    return level.required[bundle] == BundleLevel::NOT_NEEDED ? NO_VOTES : level.votesOf(bundle);
}

/** How the votes of a part are found in a child's bundle: of the chord from the i-th point of a run
of the parent's border to the u-th point of a run of the shared side, at SIDE * i + (u ^ flip), or,
if the shared side's points come first, at SIDE * (u ^ flip) + i. */
struct PartOrder
{
    bool sharedComesFirst;
    int flip; //!< SIDE - 1 where the shared side runs against the border, so u counts from its end

    PartOrder(const Merge& coarse, int childNumber, int point)
        : sharedComesFirst(coarse.sharedPoint(childNumber, 0) < point),
          flip(coarse.sharedDirection(childNumber) < 0 ? SIDE - 1 : 0)
    {
    }
    int at(int i, int u) const
    {
        return sharedComesFirst ? SIDE * (u ^ flip) + i : SIDE * i + (u ^ flip);
    }
};

#if LINESPACE_SIMD128

//! A bundle's votes with the points of one end in rows, those of the other in columns.
struct VoteMatrix
{
    v_uint16x8 upper, lower; //!< rows 0 and 1, rows 2 and 3

    VoteMatrix() {}
    VoteMatrix(const v_uint16x8& first, const v_uint16x8& second) : upper(first), lower(second) {}
    explicit VoteMatrix(const ushort* votes) : upper(v_load(votes)), lower(v_load(votes + 8)) {}

    VoteMatrix transposed() const
    {
        VoteMatrix pairs, result;
        v_zip(upper, lower, pairs.upper, pairs.lower);
        v_zip(pairs.upper, pairs.lower, result.upper, result.lower);
        return result;
    }
};

#endif

/** The votes of parts of chords: of those from SIDE points of the parent's border to all points of
some consecutive bundles of the shared side. */
class PartTable
{
public:
    enum
    {
        BUNDLES = 4, //!< more are crossed only close to the ends of the shared side
        POINTS = BUNDLES * SIDE
    };

    explicit PartTable(const PartOrder& order) : order_(order) {}

    //! The parts that end in the `number`-th of the bundles.
    void set(int number, const ushort* votes)
    {
        ushort* const first = votes_ + SIDE * number;
#if LINESPACE_SIMD128
        VoteMatrix rows(votes);
        if (order_.sharedComesFirst)
            rows = rows.transposed();
        v_store_low(first, rows.upper);
        v_store_high(first + POINTS, rows.upper);
        v_store_low(first + 2 * POINTS, rows.lower);
        v_store_high(first + 3 * POINTS, rows.lower);
#else
        for (int i = 0; i < SIDE; ++i)
            for (int u = 0; u < SIDE; ++u)
                first[i * POINTS + u] =
                    votes[order_.sharedComesFirst ? SIDE * u + i : SIDE * i + u];
#endif
    }

    //! Of the part from point i to a point of the shared side, counted from the first bundle's.
    ushort votes(int i, int point) const
    {
        return votes_[i * POINTS + (point ^ order_.flip)];
    }

#if LINESPACE_SIMD128 && CV_AVX2
    /** Of the parts from point i, one for each row, to four points each, which must lie in the first
    two bundles. */
    VoteMatrix votes(const VoteMatrix& points) const
    {
        const v_uint16x8 flip = v_setall_u16((ushort)order_.flip);
        const v_uint16x8 upper = v_xor(points.upper, flip), lower = v_xor(points.lower, flip);
        return VoteMatrix(lookUp(0, upper), lookUp(2, lower));
    }

private:
    //! Of rows i and i + 1.
    v_uint16x8 lookUp(int i, const v_uint16x8& points) const
    {
        // Both bytes of every vote.
        const __m128i bytes = _mm_add_epi16(_mm_mullo_epi16(points.val, _mm_set1_epi16(0x0202)),
                                            _mm_set1_epi16(0x0100));
        const __m128i *first = (const __m128i*)(votes_ + i * POINTS),
                      *second = (const __m128i*)(votes_ + (i + 1) * POINTS);
        return v_uint16x8(_mm_unpacklo_epi64(
            _mm_shuffle_epi8(_mm_loadu_si128(first), bytes),
            _mm_shuffle_epi8(_mm_loadu_si128(second), _mm_unpackhi_epi64(bytes, bytes))));
    }
#endif

private:
    const PartOrder order_;
    ushort votes_[SIDE * POINTS];
};

/** Bundles of one segment of a row whose chords cross the shared side, and how their votes are put
together. */
class BundleParts
{
public:
    BundleParts(const Merge& merge, const Merge& coarse, int s, const Segment& segment,
                const BundleLevel& child, size_t cells)
        : segment_(segment), child_(child), run_(2 * (ptrdiff_t)cells),
          a_(segment.chordS * run_ + segment.childS * cells),
          b_(segment.chordE * run_ + (1 - segment.childS) * cells),
          orderA_(coarse, segment.childS, coarse.childPoint(s)),
          orderB_(coarse, 1 - segment.childS, coarse.childPoint(segment.firstEnd)),
          tableA_(orderA_), tableB_(orderB_)
    {
        for (int i = 0; i < SIDE; ++i)
        {
            const CrossingRun run(merge, SIDE * s + i, SIDE * segment.firstEnd);
            for (int j = 0, k = SIDE * i; j < SIDE; ++j, ++k)
            {
                numerators_[k] = run.numerator(j);
                steps_[k] = run.numerator(SIDE) - run.numerator(0);
                denominators_[k] = run.denominator(j);
                denominatorSteps_[k] = run.denominator(SIDE) - run.denominator(0);
            }
        }
    }

    //! The votes of bundle i of a cell.
    void add(int i, size_t cell, const BundleLevel::Crossed& crossed, ushort* out)
    {
        const int firstPoint = SIDE * crossed.first, bundles = crossed.last - crossed.first + 1;
        int points[BUNDLE_CHORDS]; // as CrossingRun::at, in vectors
        for (int k = 0; k < BUNDLE_CHORDS; ++k)
            points[k] = (int)((numerators_[k] + i * steps_[k]) /
                              (denominators_[k] + i * denominatorSteps_[k])) -
                        firstPoint;
        if (bundles > PartTable::BUNDLES)
            return addOneByOne(i, cell, crossed.first, points, out);
        for (int m = crossed.first; m <= crossed.last; ++m)
        {
            tableA_.set(m - crossed.first, partA(m, cell));
            tableB_.set(m - crossed.first, partB(m, i, cell));
        }
#if LINESPACE_SIMD128 && CV_AVX2
        if (bundles <= 2)
        {
            const VoteMatrix rows(v_pack_u(v_load(points), v_load(points + 4)),
                                  v_pack_u(v_load(points + 8), v_load(points + 12)));
            const VoteMatrix a = tableA_.votes(rows),
                             b = tableB_.votes(rows.transposed()).transposed();
            v_store(out, v_add_wrap(a.upper, b.upper));
            v_store(out + 8, v_add_wrap(a.lower, b.lower));
            return;
        }
#endif
        for (int k = 0; k < BUNDLE_CHORDS; ++k)
            out[k] =
                (ushort)(tableA_.votes(k / SIDE, points[k]) + tableB_.votes(k % SIDE, points[k]));
    }

private:
    void addOneByOne(int i, size_t cell, int first, const int* points, ushort* out) const
    {
        for (int k = 0; k < BUNDLE_CHORDS; ++k)
        {
            const int m = first + points[k] / SIDE, u = points[k] % SIDE;
            out[k] = (ushort)(partA(m, cell)[orderA_.at(k / SIDE, u)] +
                              partB(m, i, cell)[orderB_.at(k % SIDE, u)]);
        }
    }

    const ushort* partA(int m, size_t cell) const
    {
        return votesIfNeeded(child_, a_ + m * segment_.strideS * run_ + cell);
    }
    const ushort* partB(int m, int i, size_t cell) const
    {
        return votesIfNeeded(child_,
                             b_ + (m * segment_.strideE + i * segment_.stepE) * run_ + cell);
    }

    const Segment& segment_;
    const BundleLevel& child_;
    const ptrdiff_t run_, a_, b_;
    const PartOrder orderA_, orderB_;
    PartTable tableA_, tableB_;
    double numerators_[BUNDLE_CHORDS], steps_[BUNDLE_CHORDS], denominators_[BUNDLE_CHORDS],
        denominatorSteps_[BUNDLE_CHORDS];
};

} // namespace

void poolVotes(const VoteTable& table, const Cell& cell, const Range& rows, BundleLevel& level)
{
    if (table.depth == 1)
        poolVotesFor(table.ptr<uchar>(), cell, rows, level);
    else
        poolVotesFor(table.ptr<ushort>(), cell, rows, level);
}

void mergeBounds(const Merge& merge, const BundleLevel& child, const Range& rows,
                 BundleLevel& parent)
{
    switch (parent.cells)
    {
    case 1: return mergeBoundsOf<1>(merge, child, rows, parent);
    case 2: return mergeBoundsOf<2>(merge, child, rows, parent);
    case 4: return mergeBoundsOf<4>(merge, child, rows, parent);
    case 8: return mergeBoundsOf<8>(merge, child, rows, parent);
    case 16: return mergeBoundsOf<16>(merge, child, rows, parent);
    default: return mergeBoundsOf<0>(merge, child, rows, parent);
    }
}

size_t countNeeded(const Range& rows, const BundleLevel& level)
{
    const BundleRange range(rows, level);
    size_t count = 0;
    for (size_t i = range.begin; i < range.end; ++i)
        count += level.required[i] != BundleLevel::NOT_NEEDED;
    return count;
}

void assignSlots(const Merge* merge, const Range& rows, int slot, BundleLevel& level)
{
    if (!merge)
    {
        const BundleRange range(rows, level);
        forEachNeeded(&level.required[range.begin], range.end - range.begin,
                      [&](size_t at) { level.slots[range.begin + at] = slot++; });
        return;
    }
    const Merge coarse(Cell(merge->child.width / SIDE, merge->child.height / SIDE),
                       merge->horizontal);
    for (int s = rows.start; s < rows.end; ++s)
    {
        Segment segments[MAX_SEGMENTS];
        const int count = rowSegments(coarse, s, segments);
        size_t start = level.coarse.rowStart(s) << level.cellBits;
        for (int k = 0; k < count; start += (size_t)segments[k].count << level.cellBits, ++k)
        {
            const size_t bundles = (size_t)segments[k].count << level.cellBits;
            if (!segments[k].isCrossing)
            {
                forEachNeeded(&level.required[start], bundles,
                              [&](size_t at) { level.slots[start + at] = slot++; });
                continue;
            }
            const BundleCrossings crossings(*merge, s, segments[k]);
            forEachNeeded(&level.required[start], bundles,
                          [&](size_t at)
                          {
                              const int i = (int)(at >> level.cellBits);
                              BundleLevel::Crossed& crossed = level.crossedOf(slot);
                              crossed.first = crossings.first(i);
                              crossed.last = crossings.last(i);
                              level.slots[start + at] = slot++;
                          });
        }
    }
}

void require(const Merge& merge, const BundleLevel& parent, int part, int parts, BundleLevel& child)
{
    const int bits = parent.cellBits, rows = parent.coarse.firstPoint(SIDE_LEFT);
    const ptrdiff_t n = (ptrdiff_t)parent.cells, run = 2 * n;
    const Merge coarse(child.coarse, merge.horizontal);
    // A child's bundle that ends on the shared side belongs to the part of that end, others to that
    // of their row.
    const int firstShared = (int)((int64)coarse.sharedCount() * part / parts),
              lastShared = (int)((int64)coarse.sharedCount() * (part + 1) / parts) - 1;
    const auto requireVotes = [&](ptrdiff_t bundle, int votes)
    {
        ushort& required = child.required[bundle];
        required = std::min(required, (ushort)std::max(0, votes));
    };
    for (int s = 0; s < rows; ++s)
    {
        Segment segments[MAX_SEGMENTS];
        const int count = rowSegments(coarse, s, segments);
        size_t start = parent.coarse.rowStart(s) << bits;
        for (int k = 0; k < count; start += (size_t)segments[k].count << bits, ++k)
        {
            const Segment& segment = segments[k];
            const ushort* const needed = &parent.required[start];
            const ptrdiff_t a = segment.chordS * run + segment.childS * n;
            if (!segment.isCrossing)
            {
                if (s % parts == part)
                    forEachNeeded(needed, (size_t)segment.count << bits,
                                  [&](size_t at) {
                                      requireVotes(a + (ptrdiff_t)(at >> bits) * run +
                                                       (at & (n - 1)),
                                                   needed[at]);
                                  });
                continue;
            }
            const ptrdiff_t b = segment.chordE * run + (1 - segment.childS) * n;
            forEachNeeded(
                needed, (size_t)segment.count << bits,
                [&](size_t at)
                {
                    const BundleLevel::Crossed& crossed =
                        parent.crossedOf(parent.slots[start + at]);
                    const ptrdiff_t cell = at & (n - 1), i = (ptrdiff_t)(at >> bits);
                    const int last = std::min(crossed.last, lastShared);
                    for (int m = std::max(crossed.first, firstShared); m <= last; ++m)
                    {
                        const ptrdiff_t partS = a + m * segment.strideS * run + cell,
                                        partE = b + cell +
                                                (m * segment.strideE + i * segment.stepE) * run;
                        const int boundS = child.bounds[partS], boundE = child.bounds[partE];
                        if (boundS + boundE < needed[at])
                            continue;
                        requireVotes(partS, needed[at] - boundE);
                        requireVotes(partE, needed[at] - boundS);
                    }
                });
        }
    }
}

void takeVotes(const VoteTable& table, const Cell& cell, const Range& rows, BundleLevel& level)
{
    if (table.depth == 1)
        takeVotesOf(table.ptr<uchar>(), cell, rows, level);
    else
        takeVotesOf(table.ptr<ushort>(), cell, rows, level);
}

void mergeVotes(const Merge& merge, const BundleLevel& child, const Range& rows,
                BundleLevel& parent)
{
    const int bits = parent.cellBits;
    const ptrdiff_t n = (ptrdiff_t)parent.cells, run = 2 * n;
    const Merge coarse(child.coarse, merge.horizontal);
    for (int s = rows.start; s < rows.end; ++s)
    {
        Segment segments[MAX_SEGMENTS];
        const int count = rowSegments(coarse, s, segments);
        size_t start = parent.coarse.rowStart(s) << bits;
        for (int k = 0; k < count; start += (size_t)segments[k].count << bits, ++k)
        {
            const Segment& segment = segments[k];
            const ushort* const needed = &parent.required[start];
            const size_t bundles = (size_t)segment.count << bits;
            if (!segment.isCrossing)
            {
                const ptrdiff_t a = segment.chordS * run + segment.childS * n;
                forEachNeeded(needed, bundles,
                              [&](size_t at)
                              {
                                  const ushort* from = child.votesOf(
                                      a + (ptrdiff_t)(at >> bits) * run + (at & (n - 1)));
                                  std::copy(from, from + BUNDLE_CHORDS, parent.votesOf(start + at));
                              });
                continue;
            }
            BundleParts parts(merge, coarse, s, segment, child, n);
            forEachNeeded(needed, bundles,
                          [&](size_t at)
                          {
                              const int slot = parent.slots[start + at];
                              parts.add((int)(at >> bits), at & (n - 1), parent.crossedOf(slot),
                                        parent.votesIn(slot));
                          });
        }
    }
}

//! Which chords of a bundle have more votes, a bit each.
inline int bitsAbove(const ushort* own, int votes)
{
    int bits = 0;
#if LINESPACE_SIMD128
    const v_uint16x8 most = v_setall_u16((ushort)votes);
    bits = v_signmask(v_pack_b(v_gt(v_load(own), most), v_gt(v_load(own + 8), most)));
#else
    for (int k = 0; k < BUNDLE_CHORDS; ++k)
        bits |= (own[k] > votes) << k;
#endif
    return bits;
}

//! Whether a chord of the same bundle that is parallel to the k-th one is stronger.
inline bool hasStrongerNeighbour(const ushort* own, int k)
{
    const int i = k / SIDE, j = k % SIDE;
    return (i < SIDE - 1 && j > 0 && own[k + SIDE - 1] > own[k]) ||
           (i > 0 && j < SIDE - 1 && own[k - SIDE + 1] >= own[k]);
}

void collectAbove(int votes, bool isAlone, const Range& rows, const BundleLevel& level,
                  std::vector<Candidate>& found)
{
    for (int s = rows.start; s < rows.end; ++s)
    {
        const int side = level.coarse.sideOf(s), firstEnd = level.coarse.firstPartner(side);
        const size_t start = level.coarse.rowStart(s);
        forEachNeeded(&level.required[start], level.coarse.rowLength(side),
                      [&](size_t at)
                      {
                          const ushort* own = level.votesOf(start + at);
                          for (int bits = bitsAbove(own, votes); bits != 0; bits &= bits - 1)
                          {
                              const int k = (int)trailingZeros32(bits);
                              if (!isAlone && hasStrongerNeighbour(own, k))
                                  continue;
                              const Candidate chord = {own[k], SIDE * s + k / SIDE,
                                                       SIDE * (firstEnd + (int)at) + k % SIDE};
                              found.push_back(chord);
                          }
                      });
    }
}

#endif // CV_CPU_OPTIMIZATION_DECLARATIONS_ONLY

CV_CPU_OPTIMIZATION_NAMESPACE_END

} // namespace linespace
} // namespace cv
