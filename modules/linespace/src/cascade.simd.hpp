// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The inner loops of the CPU path, compiled once per instruction set and chosen at run time
// (cascade.dispatch.cpp). All loops are over consecutive bytes, shorts or ints and have no
// dependence from one step to the next, so that the compiler vectorises them for the set at hand.
//
// Table order: [chord][cell], see stages.hpp. The cells A of a merge are the first half of a
// chord's run, the cells B the second, so a parent chord's run is the sum of two runs of half the
// child's length.

#include "stages.hpp"
#include "transposition.hpp"
#include "vectors.hpp"

namespace cv {
namespace linespace {

// The rest of the file is read once per instruction set, this part once.
#ifndef OPENCV_LINESPACE_CASCADE_SIMD_HPP
#define OPENCV_LINESPACE_CASCADE_SIMD_HPP

//! An image and the same with x and y exchanged, continuous. Bits may be missing (null).
struct ExactMaps
{
    const uchar *votes, *votesTransposed;
    const ushort *bits, *bitsTransposed;
};

#endif // OPENCV_LINESPACE_CASCADE_SIMD_HPP

CV_CPU_OPTIMIZATION_NAMESPACE_BEGIN

/** The same pixels of many cells, side by side.
@param row `width` pixels of the cell at the image's top-left corner.
@param offsets of the cells from that one.
@param planes of each of the pixels `cells` bytes, one after the other. */
void gatherPixels(const uchar* row, int width, const size_t* offsets, size_t cells, uchar* planes);

//! The same of 16 direction bits, in two bytes.
void gatherDirections(const ushort* pixel, const size_t* offsets, size_t cells, uchar* low,
                      uchar* high);

//! Of `count` pixels, those that have the bit among their bits; the others become 0.
void choosePixels(const uchar* pixels, const uchar* bits, uchar bit, size_t count, uchar* chosen);

/** Adds up the planes of the pixels of one chord.
@param planes of `cells` bytes each, one after the other.
@param pixels which of them.
@param votes first cell's votes, of `depth` bytes (1 or 2); the sums must fit. */
void addPlanes(const uchar* planes, const ushort* pixels, int count, size_t cells, void* votes,
               int depth);

/** Computes rows firstRow .. lastRow - 1 of all parents of a level.
@param child table of the level below, childDepth bytes per vote, 2 * cells cells per chord.
@param parent table of the level, parentDepth >= childDepth bytes per vote, cells cells per chord.
*/
void mergeRows(const Merge& merge, int firstRow, int lastRow, size_t cells, const void* child,
               int childDepth, void* parent, int parentDepth);

/** The same for a child and a parent of one byte per vote, although more votes are possible, of a
multiple of 8 cells.
@return false if a sum did not fit; then the parent is worthless. */
bool mergeRowsNarrow(const Merge& merge, int firstRow, int lastRow, size_t cells,
                     const uchar* child, uchar* parent);

/** Exact votes of the chords (s, e), e = firstPartner .. borderCount - 1, of an image of one cell,
of the pixels that have the bit of the chord's bin.
@param votes one result per chord, `depth` bytes each. */
void exactRow(const Cell& frame, int s, const ExactMaps& maps, void* votes, int depth);

#ifndef CV_CPU_OPTIMIZATION_DECLARATIONS_ONLY

namespace {

template<class Votes>
void addPlanesOf(const uchar* planes, const ushort* pixels, int count, size_t first, size_t cells,
                 Votes* votes)
{
    for (size_t c = first; c < cells; ++c)
        votes[c] = 0;
    for (int p = 0; p < count; ++p)
    {
        const uchar* const plane = planes + pixels[p] * cells;
        for (size_t c = first; c < cells; ++c)
            votes[c] = (Votes)(votes[c] + plane[c]);
    }
}

#if LINESPACE_SIMD

//! The cells of so many vectors, whose sums stay in registers.
template<int Vectors>
void addPlanesOfVectors(const uchar* planes, const ushort* pixels, int count, size_t cells,
                        uchar* votes)
{
    v_uint8 sums[Vectors];
    for (int k = 0; k < Vectors; ++k)
        sums[k] = vx_setzero_u8();
    for (int p = 0; p < count; ++p)
    {
        const uchar* const plane = planes + pixels[p] * cells;
        for (int k = 0; k < Vectors; ++k)
            sums[k] = v_add_wrap(sums[k], vx_load(plane + k * CV_SIMD_WIDTH));
    }
    for (int k = 0; k < Vectors; ++k)
        v_store(votes + k * CV_SIMD_WIDTH, sums[k]);
}

//! The cells that fill vectors; returns how many they are.
size_t addPlanesInVectors(const uchar* planes, const ushort* pixels, int count, size_t cells,
                          uchar* votes)
{
    const size_t width = CV_SIMD_WIDTH;
    size_t c = 0;
    for (; c + 8 * width <= cells; c += 8 * width)
        addPlanesOfVectors<8>(planes + c, pixels, count, cells, votes + c);
    for (; c + 2 * width <= cells; c += 2 * width)
        addPlanesOfVectors<2>(planes + c, pixels, count, cells, votes + c);
    for (; c + width <= cells; c += width)
        addPlanesOfVectors<1>(planes + c, pixels, count, cells, votes + c);
    return c;
}

#else

size_t addPlanesInVectors(const uchar*, const ushort*, int, size_t, uchar*)
{
    return 0;
}

#endif

enum
{
    ROW_BLOCK = 8,     // rows that share the lines of the child's table that a run of ends touches
    END_BLOCK = 128,   // ends per run: 256 lines of 64 bytes stay in a first-level cache
    AHEAD = 16,        // runs from a line's prefetch to its use
    SHORTEST_AHEAD = 8 // bytes of a run that is worth a prefetch
};

//! Asks for the cache line of an address.
inline void prefetch(const void* address)
{
#if defined __GNUC__ || defined __clang__
    __builtin_prefetch(address);
#else
    (void)address;
#endif
}

/** The runs of `count` chords (s, e + i): of each, `cells` votes are the sum of those at
a + m[i] * strideA and those at b + m[i] * strideB + i * stepB. Cells > 0 is the number of cells
known when compiling. */
template<int Cells, class ChildVotes, class ParentVotes>
void addRuns(const ChildVotes* a, ptrdiff_t strideA, const ChildVotes* b, ptrdiff_t strideB,
             ptrdiff_t stepB, const int* m, int count, size_t cells, ParentVotes* parent)
{
    const size_t n = Cells > 0 ? (size_t)Cells : cells;
    for (int i = 0; i < count; ++i, b += stepB, parent += n)
    {
        // No processor foresees where crossings lead. Shorter runs share their lines.
        if (n * sizeof(ChildVotes) >= SHORTEST_AHEAD)
        {
            const int ahead = std::min(i + AHEAD, count - 1);
            prefetch(a + m[ahead] * strideA);
            prefetch(b + m[ahead] * strideB + (ahead - i) * stepB);
        }
        const ChildVotes *partA = a + m[i] * strideA, *partB = b + m[i] * strideB;
        for (size_t c = 0; c < n; ++c)
            parent[c] = (ParentVotes)(partA[c] + partB[c]);
    }
}

#if LINESPACE_SIMD128

//! Adds two bytes each, and remembers the largest sums; those that do not fit become 255.
inline v_uint8x16 addNarrow(const v_uint8x16& a, const v_uint8x16& b, v_uint8x16& most)
{
    const v_uint8x16 sum = v_add(a, b);
    most = v_max(most, sum);
    return sum;
}

//! As addRuns, into votes of one byte; false if a sum did not fit (or is 255, which nobody can
//! tell).
template<int Cells>
bool addRunsNarrow(const uchar* a, ptrdiff_t strideA, const uchar* b, ptrdiff_t strideB,
                   ptrdiff_t stepB, const int* m, int count, size_t cells, uchar* parent)
{
    const size_t n = Cells > 0 ? (size_t)Cells : cells, width = 16;
    v_uint8x16 most = v_setzero_u8();
    for (int i = 0; i < count; ++i, b += stepB, parent += n)
    {
        const int ahead = std::min(i + AHEAD, count - 1);
        prefetch(a + m[ahead] * strideA);
        prefetch(b + m[ahead] * strideB + (ahead - i) * stepB);
        const uchar *partA = a + m[i] * strideA, *partB = b + m[i] * strideB;
        if (n == width / 2)
            v_store_low(parent, addNarrow(v_load_low(partA), v_load_low(partB), most));
        for (size_t c = 0; c + width <= n; c += width)
            v_store(parent + c, addNarrow(v_load(partA + c), v_load(partB + c), most));
    }
    return v_reduce_max(most) < UCHAR_MAX;
}

#else

template<int Cells>
bool addRunsNarrow(const uchar* a, ptrdiff_t strideA, const uchar* b, ptrdiff_t strideB,
                   ptrdiff_t stepB, const int* m, int count, size_t cells, uchar* parent)
{
    int most = 0;
    for (int i = 0; i < count; ++i, b += stepB)
        for (size_t c = 0; c < cells; ++c)
        {
            const int sum = a[m[i] * strideA + c] + b[m[i] * strideB + c];
            most = std::max(most, sum);
            *parent++ = (uchar)std::min<int>(sum, UCHAR_MAX);
        }
    return most < UCHAR_MAX;
}

#endif

//! Of all depths but those of addRunsNarrow.
template<int Cells, class ChildVotes, class ParentVotes>
bool addRunsNarrow(const ChildVotes*, ptrdiff_t, const ChildVotes*, ptrdiff_t, ptrdiff_t,
                   const int*, int, size_t, ParentVotes*)
{
    return false;
}

template<int Cells, class ChildVotes, class ParentVotes>
void copyRuns(const ChildVotes* a, int count, size_t cells, ParentVotes* parent)
{
    const size_t n = Cells > 0 ? (size_t)Cells : cells;
    for (int i = 0; i < count; ++i, a += 2 * n, parent += n)
        for (size_t c = 0; c < n; ++c)
            parent[c] = a[c];
}

//! With IsNarrow whether all sums fitted, see mergeRowsNarrow; else true.
template<int Cells, bool IsNarrow, class ChildVotes, class ParentVotes>
bool mergeRowsOf(const Merge& merge, int firstRow, int lastRow, size_t cells,
                 const ChildVotes* child, ParentVotes* parent)
{
    Segment segments[ROW_BLOCK][MAX_SEGMENTS];
    int m[END_BLOCK];
    const ptrdiff_t n = (ptrdiff_t)cells, run = 2 * n;
    bool fits = true;
    for (int row = firstRow; row < lastRow && fits;)
    {
        // Rows of one side of one child have the same segments.
        const int side = merge.parent.sideOf(row), half = merge.childOf(row);
        int rows = 0, count = 0;
        for (; rows < ROW_BLOCK && row + rows < lastRow &&
               merge.parent.sideOf(row + rows) == side && merge.childOf(row + rows) == half;
             ++rows)
            count = rowSegments(merge, row + rows, segments[rows]);
        for (int k = 0; k < count; ++k)
            for (int begin = 0; begin < segments[0][k].count; begin += END_BLOCK)
                for (int r = 0; r < rows; ++r)
                {
                    const Segment& segment = segments[r][k];
                    const int length = std::min<int>(END_BLOCK, segment.count - begin);
                    const int e = segment.firstEnd + begin;
                    ParentVotes* out = parent + merge.parent.chordIndex(row + r, e) * n;
                    const ChildVotes* a = child + segment.chordS * run + segment.childS * n;
                    if (!segment.isCrossing)
                    {
                        copyRuns<Cells>(a + begin * run, length, cells, out);
                        continue;
                    }
                    const CrossingRun crossings(merge, row + r, e);
                    for (int i = 0; i < length; ++i)
                        m[i] = crossings.at(i);
                    const ChildVotes* b = child + (segment.chordE + begin * segment.stepE) * run +
                                          (1 - segment.childS) * n;
                    if (!IsNarrow)
                        addRuns<Cells>(a, segment.strideS * run, b, segment.strideE * run,
                                       segment.stepE * run, m, length, cells, out);
                    else if (!addRunsNarrow<Cells>(a, segment.strideS * run, b,
                                                   segment.strideE * run, segment.stepE * run, m,
                                                   length, cells, out))
                        fits = false;
                }
        row += rows;
    }
    return fits;
}

template<bool IsNarrow, class ChildVotes, class ParentVotes>
bool mergeRowsFor(const Merge& merge, int firstRow, int lastRow, size_t cells, const void* child,
                  void* parent)
{
    const ChildVotes* from = (const ChildVotes*)child;
    ParentVotes* to = (ParentVotes*)parent;
    switch (cells)
    {
    case 1: return mergeRowsOf<1, IsNarrow>(merge, firstRow, lastRow, cells, from, to);
    case 2: return mergeRowsOf<2, IsNarrow>(merge, firstRow, lastRow, cells, from, to);
    case 4: return mergeRowsOf<4, IsNarrow>(merge, firstRow, lastRow, cells, from, to);
    case 8: return mergeRowsOf<8, IsNarrow>(merge, firstRow, lastRow, cells, from, to);
    case 16: return mergeRowsOf<16, IsNarrow>(merge, firstRow, lastRow, cells, from, to);
    case 32: return mergeRowsOf<32, IsNarrow>(merge, firstRow, lastRow, cells, from, to);
    default: return mergeRowsOf<0, IsNarrow>(merge, firstRow, lastRow, cells, from, to);
    }
}

template<bool IsOriented, class Votes>
void exactRowOf(const Cell& frame, int s, const ExactMaps& maps, Votes* votes)
{
    for (int e = frame.firstPartner(frame.sideOf(s)); e < frame.borderCount(); ++e)
    {
        const Chord chord = {s, e};
        const Raster raster(frame, chord);
        // With x and y exchanged where y is the major axis, all chords run along the rows.
        const ptrdiff_t stride = raster.xMajor ? frame.width : frame.height;
        const uchar* pixels = raster.xMajor ? maps.votes : maps.votesTransposed;
        const ushort* bits = raster.xMajor ? maps.bits : maps.bitsTransposed;
        const ushort bit = IsOriented ? directionBit(frame, chord) : 0;
        ptrdiff_t at = raster.minor * stride + raster.first; // beyond the image after the last step
        const int step = raster.step, modulus = raster.modulus;
        int sum = 0, remainder = raster.remainder;
        for (int i = 0; i < raster.count; ++i)
        {
            if (!IsOriented || (bits[at] & bit))
                sum += pixels[at];
            ++at;
            remainder += step;
            const int over = remainder >= modulus, under = remainder < 0;
            remainder += (under - over) * modulus;
            at += (over - under) * stride;
        }
        *votes++ = (Votes)sum;
    }
}

} // namespace

void gatherPixels(const uchar* row, int width, const size_t* offsets, size_t cells, uchar* planes)
{
    size_t c = 0;
#if LINESPACE_SIMD128
    const int columns = 8, block = 16;
    if (width >= columns)
        for (; c + block <= cells; c += block)
            for (int next = 0; next < width; next += columns)
            {
                // The last ones may have been among those before.
                const int x = std::min(next, width - columns);
                v_uint8x16 pixels[columns];
                for (int i = 0; i < columns; ++i)
                    pixels[i] = v_load_halves(row + offsets[c + 2 * i] + x,
                                              row + offsets[c + 2 * i + 1] + x);
                transposeBytes(pixels);
                for (int i = 0; i < columns; ++i)
                    v_store(planes + (x + i) * cells + c, pixels[i]);
            }
#endif
    for (; c < cells; ++c)
        for (int x = 0; x < width; ++x)
            planes[x * cells + c] = row[offsets[c] + x];
}

void gatherDirections(const ushort* pixel, const size_t* offsets, size_t cells, uchar* low,
                      uchar* high)
{
    for (size_t c = 0; c < cells; ++c)
    {
        const ushort bits = pixel[offsets[c]];
        low[c] = (uchar)(bits & 0xFF);
        high[c] = (uchar)(bits >> 8);
    }
}

void choosePixels(const uchar* pixels, const uchar* bits, uchar bit, size_t count, uchar* chosen)
{
    for (size_t i = 0; i < count; ++i)
        chosen[i] = (uchar)(pixels[i] & ((bits[i] & bit) == bit ? 0xFF : 0));
}

void addPlanes(const uchar* planes, const ushort* pixels, int count, size_t cells, void* votes,
               int depth)
{
    if (depth == 1)
        addPlanesOf(planes, pixels, count,
                    addPlanesInVectors(planes, pixels, count, cells, (uchar*)votes), cells,
                    (uchar*)votes);
    else
        addPlanesOf(planes, pixels, count, 0, cells, (ushort*)votes);
}

void mergeRows(const Merge& merge, int firstRow, int lastRow, size_t cells, const void* child,
               int childDepth, void* parent, int parentDepth)
{
    switch (childDepth * 8 + parentDepth)
    {
    case 8 + 1:
        mergeRowsFor<false, uchar, uchar>(merge, firstRow, lastRow, cells, child, parent);
        break;
    case 8 + 2:
        mergeRowsFor<false, uchar, ushort>(merge, firstRow, lastRow, cells, child, parent);
        break;
    case 16 + 2:
        mergeRowsFor<false, ushort, ushort>(merge, firstRow, lastRow, cells, child, parent);
        break;
    case 16 + 4:
        mergeRowsFor<false, ushort, int>(merge, firstRow, lastRow, cells, child, parent);
        break;
    default: mergeRowsFor<false, int, int>(merge, firstRow, lastRow, cells, child, parent); break;
    }
}

bool mergeRowsNarrow(const Merge& merge, int firstRow, int lastRow, size_t cells,
                     const uchar* child, uchar* parent)
{
    CV_DbgAssert(cells % 8 == 0);
    return mergeRowsFor<true, uchar, uchar>(merge, firstRow, lastRow, cells, child, parent);
}

namespace {

template<bool IsOriented>
void exactRowFor(const Cell& frame, int s, const ExactMaps& maps, void* votes, int depth)
{
    if (depth == 1)
        exactRowOf<IsOriented>(frame, s, maps, (uchar*)votes);
    else if (depth == 2)
        exactRowOf<IsOriented>(frame, s, maps, (ushort*)votes);
    else
        exactRowOf<IsOriented>(frame, s, maps, (int*)votes);
}

} // namespace

void exactRow(const Cell& frame, int s, const ExactMaps& maps, void* votes, int depth)
{
    if (maps.bits)
        exactRowFor<true>(frame, s, maps, votes, depth);
    else
        exactRowFor<false>(frame, s, maps, votes, depth);
}

#endif // CV_CPU_OPTIMIZATION_DECLARATIONS_ONLY

CV_CPU_OPTIMIZATION_NAMESPACE_END

} // namespace linespace
} // namespace cv
