// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The cascade on a device (doc/algorithm.md, section 3). Tables are in the order of stages.hpp,
// [chord][cell]. What chords and crossings are is the plan's, in tables: nothing here derives
// geometry of its own.
//
// CHILD, PARENT: types of votes. CELLS: as in segments.cl.

#ifdef FIRST_CELLS

#if CELLS == 16

/* Eight pixels of a row of a cell, as votesAt; 0 beyond the image. */
inline uchar8 votesOfPiece(__global const uchar* image, int step, int offset, int rows,
                           int columns MASK_PARAMETERS, int x, int y)
{
    uchar8 votes = 0;
    if (y < rows && x + 8 <= columns)
    {
        votes = vload8(0, image + offset + y * step + x);
#ifdef BINARY
        votes = convert_uchar8(votes != (uchar8)0) & (uchar8)1;
#endif
#ifdef MASKED
        votes &= convert_uchar8(vload8(0, mask + maskOffset + y * maskStep + x) != (uchar8)0);
#endif
    }
    else if (y < rows)
    {
        uchar some[8];
        for (int i = 0; i < 8; ++i)
            some[i] =
                x + i < columns ? votesAt(image, step, offset MASK_ARGUMENTS, x + i, y) : (uchar)0;
        votes = vload8(0, some);
    }
    return votes;
}

inline uchar16 zipped(uchar8 a, uchar8 b)
{
    return (uchar16)(a.s0, b.s0, a.s1, b.s1, a.s2, b.s2, a.s3, b.s3, a.s4, b.s4, a.s5, b.s5, a.s6,
                     b.s6, a.s7, b.s7);
}

/* Votes of the pixels of cells, side by side: that of pixel y cellWidth + x of a cell stands at
planes[pixel * cells + cell], 0 beyond the image. An item takes a piece of eight pixels of a row of
16 cells and transposes it. Global size: cells / 16, pieces of a cell. */
__kernel void gatherPixels(__global const uchar* image, int step, int offset, int rows,
                           int columns MASK_PARAMETERS, __global const int* corners, int cells,
                           int pixels, int cellWidth, __global uchar* planes)
{
    const int cell = get_global_id(0) * 16, pieces = (cellWidth + 7) / 8;
    const int row = get_global_id(1) / pieces, first = (get_global_id(1) - row * pieces) * 8;
    if (cell >= cells || row * cellWidth >= pixels)
        return;
    uchar8 votes[16];
    for (int i = 0; i < 16; ++i)
        votes[i] = votesOfPiece(image, step, offset, rows, columns MASK_ARGUMENTS,
                                corners[2 * (cell + i)] + first, corners[2 * (cell + i) + 1] + row);
    uchar16 a[8], b[8];
    for (int i = 0; i < 8; ++i) /* of cells i, i + 8: pixel 0 of both, pixel 1 of both ... */
        a[i] = zipped(votes[i], votes[i + 8]);
    for (int i = 0; i < 4; ++i) /* of every fourth cell from i on: pixels 0 to 3, pixels 4 to 7 */
    {
        b[i] = zipped(a[i].lo, a[i + 4].lo);
        b[i + 4] = zipped(a[i].hi, a[i + 4].hi);
    }
    for (int i = 0; i < 8; i += 4) /* of every other cell: two pixels each */
        for (int k = 0; k < 2; ++k)
        {
            a[i + k] = zipped(b[i + k].lo, b[i + k + 2].lo);
            a[i + k + 2] = zipped(b[i + k].hi, b[i + k + 2].hi);
        }
    __global uchar* out = planes + (size_t)(row * cellWidth + first) * cells + cell;
    const int count = min(8, cellWidth - first);
    for (int i = 0; i < count; ++i, out += cells)
    {
        const uchar16 even = a[i / 2 * 2], odd = a[i / 2 * 2 + 1];
        *(__global uchar16*)out = i % 2 ? zipped(even.hi, odd.hi) : zipped(even.lo, odd.lo);
    }
}

#else

/* The same where fewer cells stand together, and for devices whose neighbouring work items had
better write neighbouring bytes. Global size: cells, pixels of a cell. */
__kernel void gatherPixels(__global const uchar* image, int step, int offset, int rows,
                           int columns MASK_PARAMETERS, __global const int* corners, int cells,
                           int pixels, int cellWidth, __global uchar* planes)
{
    const int cell = get_global_id(0), pixel = get_global_id(1);
    if (cell >= cells || pixel >= pixels)
        return;
    const int row = pixel / cellWidth;
    const int x = corners[2 * cell] + pixel - row * cellWidth, y = corners[2 * cell + 1] + row;
    planes[(size_t)pixel * cells + cell] =
        x < columns && y < rows ? votesAt(image, step, offset MASK_ARGUMENTS, x, y) : (uchar)0;
}

#endif

__kernel void gatherDirections(__global const uchar* image, int step, int offset, int rows,
                               int columns, __global const int* corners, int cells, int pixels,
                               int cellWidth, __global ushort* planes)
{
    const int cell = get_global_id(0), pixel = get_global_id(1);
    if (cell >= cells || pixel >= pixels)
        return;
    const int row = pixel / cellWidth;
    const int x = corners[2 * cell] + pixel - row * cellWidth, y = corners[2 * cell + 1] + row;
    planes[(size_t)pixel * cells + cell] =
        x < columns && y < rows
            ? *(__global const ushort*)(image + offset + y * step + x * (int)sizeof(ushort))
            : (ushort)0;
}

/* Level 0. Chord i has the pixels pixels[starts[i]] .. pixels[starts[i + 1] - 1] and votes for bin
bins[i]. Global size: cells / CELLS, chords. */
__kernel void firstCells(__global const uchar* planes,
#ifdef ORIENTED
                         __global const ushort* directions, __global const uchar* bins,
#endif
                         __global const ushort* pixels, __global const int* starts, int cells,
                         int chords, __global PARENT* table)
{
    const int cell = get_global_id(0) * CELLS, chord = get_global_id(1);
    if (cell >= cells || chord >= chords)
        return;
    VECTOR(PARENT) sum = 0;
    const int end = starts[chord + 1];
    for (int i = starts[chord]; i < end; ++i)
    {
        const size_t at = (size_t)pixels[i] * cells + cell;
        VECTOR(uchar) votes = CONST_CELLS_AT(uchar, planes + at);
#ifdef ORIENTED
        const VECTOR(ushort) voting =
            CONST_CELLS_AT(ushort, directions + at) >> (ushort)bins[chord] & (ushort)1;
        votes *= CONVERT(uchar, voting);
#endif
        sum += CONVERT(PARENT, votes);
    }
    CELLS_AT(PARENT, table + (size_t)chord * cells + cell) = sum;
}

#endif // FIRST_CELLS

#ifdef MERGE

/* The cells that one item takes: where there are fewer than a full vector's, their number is known
when compiling. */
#if CELLS < 16
#define CELL_COUNT CELLS
#else
#define CELL_COUNT cells
#endif
#define CHILD_AT(from) CONVERT(PARENT, CONST_CELLS_AT(CHILD, from))

/* One level from the one below, RUN chords of a row at a time. Row s has the segments from
segments[MAX_SEGMENTS * s] on; its first chord is rows[s].x, their number rows[s].y, that of its
segments rows[s].z, its first end rows[s].w. Global size: runs of the longest row, rows. */
__kernel void mergeCells(__global const Segment* segments, __global const int4* rows, int rowCount,
                         int cells, __global const CHILD* restrict child,
                         __global PARENT* restrict parent)
{
    const int s = get_global_id(1);
    if (s >= rowCount)
        return;
    const int4 row = rows[s];
    const int begin = row.w + (int)get_global_id(0) * RUN, end = min(begin + RUN, row.w + row.y);
    const size_t run = 2 * (size_t)CELL_COUNT;
    __global const Segment* segment = segments + s * MAX_SEGMENTS;
    for (int k = 1; k < row.z && begin >= segment[1].firstEnd; ++k)
        ++segment;
    __global PARENT* out = parent + (size_t)(row.x + begin - row.w) * CELL_COUNT;
    for (int e = begin; e < end; segment += e >= segment->firstEnd + segment->count)
    {
        const int first = e - segment->firstEnd;
        const int count = min(end - e, segment->count - first);
        const int childS = segment->childS;
        e += count;
        if (!segment->isCrossing)
        {
            __global const CHILD* own =
                child + (segment->chordS + first) * run + childS * CELL_COUNT;
            for (int i = 0; i < count; ++i, own += run, out += CELL_COUNT)
                for (int cell = 0; cell < CELL_COUNT; cell += CELLS)
                    CELLS_AT(PARENT, out + cell) = CHILD_AT(own + cell);
            continue;
        }
        int crossings[RUN];
        findCrossings(&segment->crossings, first, count, crossings);
        __global const CHILD* const partS = child + segment->chordS * run + childS * CELL_COUNT;
        __global const CHILD* partE = child +
                                      (segment->chordE + first * segment->stepE) * (long)run +
                                      (1 - childS) * CELL_COUNT;
        const long strideS = segment->strideS * (long)run, strideE = segment->strideE * (long)run;
        const long stepE = segment->stepE * (long)run;
        for (int i = 0; i < count; ++i, partE += stepE, out += CELL_COUNT)
            for (int cell = 0; cell < CELL_COUNT; cell += CELLS)
                CELLS_AT(PARENT, out + cell) = CHILD_AT(partS + crossings[i] * strideS + cell) +
                                               CHILD_AT(partE + crossings[i] * strideE + cell);
    }
}

#endif // MERGE

#ifdef EXACT

/* METHOD_EXACT: rows as those of mergeCells. Global size: most chords of a row, rows. */
__kernel void exactVotes(__global const uchar* image, int step, int offset, int rows,
                         int columns MASK_PARAMETERS DIRECTIONS_PARAMETERS,
                         __global const int4* borderRows,
                         int rowCount, int width, int height, __global PARENT* table)
{
    const int i = get_global_id(0), s = get_global_id(1);
    if (s >= rowCount)
        return;
    const int4 row = borderRows[s];
    if (i < row.y)
        table[row.x + i] = (PARENT)votesOfChord(width, height, s, row.w + i, image, step, offset,
                                                rows,
                                                columns MASK_ARGUMENTS DIRECTIONS_ARGUMENTS);
}

/* The same of a list of chords. Global size: chords. */
__kernel void rescore(__global const uchar* image, int step, int offset, int rows,
                      int columns MASK_PARAMETERS DIRECTIONS_PARAMETERS,
                      __global const int2* chords, int count,
                      int width, int height, __global int* votes)
{
    const int i = get_global_id(0);
    if (i < count)
        votes[i] = votesOfChord(width, height, chords[i].x, chords[i].y, image, step, offset, rows,
                                columns MASK_ARGUMENTS DIRECTIONS_ARGUMENTS);
}

#endif // EXACT
