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

/** Adds up `count` planes of edge pixels for a range of cells.
@param planes one pointer per pixel of the chord, to the plane's byte of the first cell of the
range.
@param votes first cell's votes, of `depth` bytes (1 or 2); the sums must fit. */
void addPlanes(const uchar* const* planes, int count, size_t cells, void* votes, int depth);

/** Of a plane, the pixels that have a bit of theirs set; the others become 0.
@param bits to the byte with the pixel's bits, of the first cell of the range. */
void choosePixels(const uchar* plane, const uchar* bits, uchar bit, size_t cells, uchar* chosen);

/** Computes rows firstRow .. lastRow - 1 of all parents of a level.
@param child table of the level below, childDepth bytes per vote, 2 * cells cells per chord.
@param parent table of the level, parentDepth >= childDepth bytes per vote, cells cells per chord.
*/
void mergeRows(const Merge& merge, int firstRow, int lastRow, size_t cells, const void* child,
               int childDepth, void* parent, int parentDepth);

/** Exact votes of the chords (s, e), e = firstPartner .. borderCount - 1, of an image of one cell,
of the pixels that have the bit of the chord's bin.
@param votes one result per chord, `depth` bytes each. */
void exactRow(const Cell& frame, int s, const ExactMaps& maps, void* votes, int depth);

#ifndef CV_CPU_OPTIMIZATION_DECLARATIONS_ONLY

namespace {

template<class Votes>
void addPlanesOf(const uchar* const* planes, int count, size_t cells, Votes* votes)
{
    // Four planes at a time: one load and one store of the sums for four loads of pixels.
    int p = 0;
    switch (count & 3)
    {
    case 0: std::fill(votes, votes + cells, (Votes)0); break;
    case 1:
        for (size_t c = 0; c < cells; ++c)
            votes[c] = planes[0][c];
        break;
    case 2:
        for (size_t c = 0; c < cells; ++c)
            votes[c] = (Votes)(planes[0][c] + planes[1][c]);
        break;
    default:
        for (size_t c = 0; c < cells; ++c)
            votes[c] = (Votes)(planes[0][c] + planes[1][c] + planes[2][c]);
    }
    for (p = count & 3; p < count; p += 4)
    {
        const uchar *p0 = planes[p], *p1 = planes[p + 1], *p2 = planes[p + 2], *p3 = planes[p + 3];
        for (size_t c = 0; c < cells; ++c)
            votes[c] = (Votes)(votes[c] + p0[c] + p1[c] + p2[c] + p3[c]);
    }
}

enum
{
    ROW_BLOCK = 16, // rows that share the lines of the child's table that a run of ends touches
    END_BLOCK = 256 // ends per run: 256 lines of 64 bytes stay in a first-level cache
};

/** crossing(s, e + i) for i = 0 .. count - 1, e .. e + count - 1 on one side of one child.
Numerator and denominator of the crossing are affine in i and, below 2^53, exact in double; the
quotient's relative error of 2^-53 is less than its distance 1 / denominator to the next integer,
unless it is one. So the truncated quotient is the exact floor, for cells of up to 2^25 x 2^25
pixels. */
void crossings(const Merge& merge, int s, int e, int count, int* m)
{
    int alongS, acrossS, alongE, acrossE, alongNext, acrossNext;
    merge.relativeTo(s, alongS, acrossS);
    merge.relativeTo(e, alongE, acrossE);
    merge.relativeTo(count > 1 ? e + 1 : e, alongNext, acrossNext);
    // In that order both are positive if s lies on A, else both are negative: the same quotient.
    const double numerator = (double)alongS * acrossE - (double)alongE * acrossS;
    const double denominator = 2. * ((double)acrossE - acrossS);
    const double numeratorStep =
        (double)alongS * (acrossNext - acrossE) - (double)(alongNext - alongE) * acrossS;
    const double denominatorStep = 2. * (acrossNext - acrossE);
    for (int i = 0; i < count; ++i)
        m[i] = (int)((numerator + i * numeratorStep) / (denominator + i * denominatorStep));
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
        const ChildVotes *partA = a + m[i] * strideA, *partB = b + m[i] * strideB;
        for (size_t c = 0; c < n; ++c)
            parent[c] = (ParentVotes)(partA[c] + partB[c]);
    }
}

template<int Cells, class ChildVotes, class ParentVotes>
void copyRuns(const ChildVotes* a, int count, size_t cells, ParentVotes* parent)
{
    const size_t n = Cells > 0 ? (size_t)Cells : cells;
    for (int i = 0; i < count; ++i, a += 2 * n, parent += n)
        for (size_t c = 0; c < n; ++c)
            parent[c] = a[c];
}

template<int Cells, class ChildVotes, class ParentVotes>
void mergeRowsOf(const Merge& merge, int firstRow, int lastRow, size_t cells,
                 const ChildVotes* child, ParentVotes* parent)
{
    Segment segments[ROW_BLOCK][MAX_SEGMENTS];
    int m[END_BLOCK];
    const ptrdiff_t n = (ptrdiff_t)cells, run = 2 * n;
    for (int row = firstRow; row < lastRow;)
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
                    crossings(merge, row + r, e, length, m);
                    const ChildVotes* b = child + (segment.chordE + begin * segment.stepE) * run +
                                          (1 - segment.childS) * n;
                    addRuns<Cells>(a, segment.strideS * run, b, segment.strideE * run,
                                   segment.stepE * run, m, length, cells, out);
                }
        row += rows;
    }
}

template<class ChildVotes, class ParentVotes>
void mergeRowsFor(const Merge& merge, int firstRow, int lastRow, size_t cells, const void* child,
                  void* parent)
{
    const ChildVotes* from = (const ChildVotes*)child;
    ParentVotes* to = (ParentVotes*)parent;
    switch (cells)
    {
    case 1: return mergeRowsOf<1>(merge, firstRow, lastRow, cells, from, to);
    case 2: return mergeRowsOf<2>(merge, firstRow, lastRow, cells, from, to);
    case 4: return mergeRowsOf<4>(merge, firstRow, lastRow, cells, from, to);
    case 8: return mergeRowsOf<8>(merge, firstRow, lastRow, cells, from, to);
    case 16: return mergeRowsOf<16>(merge, firstRow, lastRow, cells, from, to);
    case 32: return mergeRowsOf<32>(merge, firstRow, lastRow, cells, from, to);
    default: return mergeRowsOf<0>(merge, firstRow, lastRow, cells, from, to);
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

void addPlanes(const uchar* const* planes, int count, size_t cells, void* votes, int depth)
{
    if (depth == 1)
        addPlanesOf(planes, count, cells, (uchar*)votes);
    else
        addPlanesOf(planes, count, cells, (ushort*)votes);
}

void choosePixels(const uchar* plane, const uchar* bits, uchar bit, size_t cells, uchar* chosen)
{
    for (size_t c = 0; c < cells; ++c)
        chosen[c] = (uchar)(plane[c] & ((bits[c] & bit) == bit ? 0xFF : 0));
}

void mergeRows(const Merge& merge, int firstRow, int lastRow, size_t cells, const void* child,
               int childDepth, void* parent, int parentDepth)
{
    switch (childDepth * 8 + parentDepth)
    {
    case 8 + 1: return mergeRowsFor<uchar, uchar>(merge, firstRow, lastRow, cells, child, parent);
    case 8 + 2: return mergeRowsFor<uchar, ushort>(merge, firstRow, lastRow, cells, child, parent);
    case 16 + 2:
        return mergeRowsFor<ushort, ushort>(merge, firstRow, lastRow, cells, child, parent);
    case 16 + 4: return mergeRowsFor<ushort, int>(merge, firstRow, lastRow, cells, child, parent);
    default: return mergeRowsFor<int, int>(merge, firstRow, lastRow, cells, child, parent);
    }
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
