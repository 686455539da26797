// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The last levels without most of their chords (doc/algorithm.md, section 4, point 6). A block is
// the BLOCK x BLOCK chords between two runs of BLOCK border points; blocks of a cell are the chords
// of a coarse cell, a BLOCK-th of the size, and are stored as those. From the level whose table is
// whole upwards no chord of a block has more votes than its bound; from the last level downwards a
// block is needed if a chord with more votes than the cut may have a part there; then only needed
// blocks are merged. What stands in others is not defined.
//
// Preconditions: BLOCK divides the sides of all cells. CELLS: of the level (of the parent, where
// two levels meet), 1 to 8. CHILD, PARENT: types of votes. No result depends on the order of work
// items: each writes what no other does, or the least of some numbers.

#if CELLS == 1
#define ANY(comparison) (comparison)
#else
#define ANY(comparison) any(comparison)
#endif

/* Of `required`: no votes of a block are asked for. */
#define NOT_NEEDED INT_MAX

#ifdef POOL

#define CHILD16 CONCAT(CHILD, 16)
#define CHILD8 CONCAT(CHILD, 8)

/* Bounds from a whole table. Global size: blocks of the longest row, rows of blocks. */
__kernel void poolBlocks(__global const CHILD* table, int width, int height,
                         __global ushort* bounds)
{
    const Frame cell = {width, height}, coarse = {width / BLOCK, height / BLOCK};
    const int e = get_global_id(0), s = get_global_id(1);
    if (s >= 2 * coarse.width + coarse.height)
        return;
    const int blocks = 2 * (coarse.width + coarse.height) - sideOf(coarse, s).y;
    if (e >= blocks)
        return;
    __global const CHILD* row = table + (size_t)(rowStart(cell, s * BLOCK) + e * BLOCK) * CELLS;
    CHILD16 most = 0;
    for (int i = 0; i < BLOCK; ++i, row += (size_t)blocks * BLOCK * CELLS)
        for (int k = 0; k < BLOCK * CELLS; k += 16)
            most = max(most, *(__global const CHILD16*)(row + k));
    const CHILD8 most8 = max(most.lo, most.hi);
    CELLS_AT(ushort, bounds + (size_t)(rowStart(coarse, s) + e) * CELLS) = CONVERT(ushort, most8);
}

#else

/* A run of blocks of one row of the parent, as struct BlockSegment: a run of chords of the coarse
cells, but for its crossings. The chords of block firstEnd + i cross the shared side at the points
from least to most. */
typedef struct
{
    int firstEnd, count, isCrossing, childS, chordS, strideS, chordE, strideE, stepE;
    Crossings least, most;
} BlockSegment;

/* The first and the last block of the shared side that block i of a segment crosses. */
inline int2 crossedBlocks(__global const BlockSegment* segment, int i)
{
    return (int2)(crossingAt(&segment->least, i), crossingAt(&segment->most, i)) / BLOCK;
}

/* Where the numbers of both parts of block i that meet in block m of the shared side stand, of the
first cell: that at s, that at e. Of a block that does not cross it the first is the child's. */
inline int2 partsOf(__global const BlockSegment* segment, int i, int m)
{
    if (!segment->isCrossing)
        return (segment->chordS + i) * 2 * CELLS + segment->childS * CELLS;
    return (int2)(segment->chordS + m * segment->strideS,
                  segment->chordE + m * segment->strideE + i * segment->stepE) * 2 * CELLS +
           (int2)(segment->childS, 1 - segment->childS) * CELLS;
}

inline __global const BlockSegment* segmentOf(__global const BlockSegment* segments, int s, int e)
{
    __global const BlockSegment* segment = segments + s * MAX_SEGMENTS;
    while (e >= segment->firstEnd + segment->count)
        ++segment;
    return segment;
}

#ifdef BOUND

/* Bounds of a level from those of the one below; none of its blocks is needed so far. Row s has the
segments from segments[MAX_SEGMENTS * s] on; its first block is rows[s].x, their number rows[s].y,
its first end rows[s].w. Global size: runs of RUN blocks of the longest row, rows. */
__kernel void boundBlocks(__global const BlockSegment* segments, __global const int4* rows,
                          int rowCount, __global const ushort* restrict child,
                          __global ushort* restrict parent, __global int* required)
{
    const int s = get_global_id(1);
    if (s >= rowCount)
        return;
    const int4 row = rows[s];
    const int begin = row.w + (int)get_global_id(0) * RUN, end = min(begin + RUN, row.w + row.y);
    if (begin >= end)
        return;
    __global const BlockSegment* segment = segmentOf(segments, s, begin);
    __global ushort* bounds = parent + (size_t)(row.x + begin - row.w) * CELLS;
    for (int e = begin; e < end; ++segment)
    {
        const int i = e - segment->firstEnd, count = min(end - e, segment->count - i);
        e += count;
        if (!segment->isCrossing)
        {
            __global const ushort* const own = child + partsOf(segment, i, 0).x;
            for (int j = 0; j < count; ++j, bounds += CELLS)
                CELLS_AT(ushort, bounds) = CONST_CELLS_AT(ushort, own + j * 2 * CELLS);
            continue;
        }
        /* In a loop of their own, of a known length, which compilers turn into vectors; what is
        beyond the segment is not used. */
        int first[RUN], last[RUN];
        for (int j = 0; j < RUN; ++j)
        {
            const int2 crossed = crossedBlocks(segment, i + j);
            first[j] = crossed.x;
            last[j] = crossed.y;
        }
        const int2 parts = partsOf(segment, i, 0);
        __global const ushort* const partS = child + parts.x;
        const int strideS = segment->strideS * 2 * CELLS, strideE = segment->strideE * 2 * CELLS;
        const int stepE = segment->stepE * 2 * CELLS;
        for (int j = 0; j < count; ++j, bounds += CELLS)
        {
            __global const ushort* const partE = child + parts.y + j * stepE;
            VECTOR(ushort) most = 0;
            for (int m = first[j]; m <= last[j]; ++m)
                most = max(most, (VECTOR(ushort))(CONST_CELLS_AT(ushort, partS + m * strideS) +
                                                  CONST_CELLS_AT(ushort, partE + m * strideE)));
            CELLS_AT(ushort, bounds) = most;
        }
    }
    for (int i = (row.x + begin - row.w) * CELLS; i < (row.x + end - row.w) * CELLS; ++i)
        required[i] = NOT_NEEDED;
}

#endif // BOUND

#ifdef REQUIRE

/* Which blocks of the level below are needed, and how many votes a chord must have there so that it
matters, as far as the parent's needed ones tell; and of these, in a bit each, with which of the
blocks of the shared side that they cross: bit k for the k-th one, the last bit for all from the
32nd on; all bits if they cross none. TOP: the parent is the last level, whose chords with more
votes than the cut are needed: all, or of a sample of one block of so many. Rows and global size as
of boundBlocks. */
__kernel void requireBlocks(__global const BlockSegment* segments, __global const int4* rows,
                            int rowCount, __global const ushort* bounds,
                            __global const int* required, int cut, int sample,
                            __global const ushort* childBounds, __global int* childRequired,
                            __global uint* needed)
{
    const int s = get_global_id(1);
    if (s >= rowCount)
        return;
    const int4 row = rows[s];
    const int begin = row.w + (int)get_global_id(0) * RUN, end = min(begin + RUN, row.w + row.y);
    for (int e = begin; e < end; ++e)
    {
        const int block = row.x + e - row.w;
        uint bits = 0;
        int least[CELLS];
        bool isNeeded = false;
        for (int c = 0; c < CELLS; ++c)
        {
#ifdef TOP
            const bool isSampled = (block * 2654435769u >> 16) % sample == 0;
            least[c] =
                bounds[block * CELLS + c] > cut && isSampled ? cut + 1 : NOT_NEEDED;
#else
            least[c] = required[block * CELLS + c];
#endif
            isNeeded |= least[c] != NOT_NEEDED;
        }
        if (isNeeded)
        {
            __global const BlockSegment* const segment = segmentOf(segments, s, e);
            const int i = e - segment->firstEnd;
            if (!segment->isCrossing)
            {
                const int part = partsOf(segment, i, 0).x;
                for (int c = 0; c < CELLS; ++c)
                    atomic_min(childRequired + part + c, least[c]);
                bits = ~0u;
            }
            else
            {
                const int2 crossed = crossedBlocks(segment, i);
                const bool sharesBit = crossed.y - crossed.x > 31; /* so all are needed */
                for (int m = crossed.x; m <= crossed.y; ++m)
                {
                    const int2 parts = partsOf(segment, i, m);
                    for (int c = 0; c < CELLS; ++c)
                    {
                        const int boundS = childBounds[parts.x + c];
                        const int boundE = childBounds[parts.y + c];
                        if (least[c] == NOT_NEEDED || (boundS + boundE < least[c] && !sharesBit))
                            continue;
                        /* Not more than the bound: a block that is needed has a bit. */
                        atomic_min(childRequired + parts.x + c, min(least[c] - boundE, boundS));
                        atomic_min(childRequired + parts.y + c, min(least[c] - boundS, boundE));
                        bits |= 1u << min(m - crossed.x, 31);
                    }
                }
            }
        }
        needed[block] = bits;
    }
}

#endif // REQUIRE

#ifdef MERGE

/* ENDS consecutive chords of a needed block, the first of which is chord i of the segment.
`first`: block of the shared side that the first bit of `bits` stands for. */
inline void mergeChords(__global const Segment* segment, int i, int first, uint bits,
                        __global const CHILD* restrict child, __global PARENT* restrict out)
{
    const int run = 2 * CELLS;
    if (!segment->isCrossing)
    {
        __global const CHILD* const own =
            child + (size_t)(segment->chordS + i) * run + segment->childS * CELLS;
        for (int j = 0; j < ENDS; ++j)
            CELLS_AT(PARENT, out + j * CELLS) =
                CONVERT(PARENT, CONST_CELLS_AT(CHILD, own + j * run));
        return;
    }
    int crossings[ENDS];
    findCrossings(&segment->crossings, i, ENDS, crossings);
    __global const CHILD* const partS =
        child + (size_t)segment->chordS * run + segment->childS * CELLS;
    __global const CHILD* const partE = child +
                                        (size_t)(segment->chordE + i * segment->stepE) * run +
                                        (1 - segment->childS) * CELLS;
    const int strideS = segment->strideS * run, strideE = segment->strideE * run;
    const int stepE = segment->stepE * run;
    for (int j = 0; j < ENDS; ++j)
    {
        const int m = crossings[j];
        VECTOR(PARENT)
        votes = CONVERT(PARENT, CONST_CELLS_AT(CHILD, partS + m * strideS)) +
                CONVERT(PARENT, CONST_CELLS_AT(CHILD, partE + m * strideE + j * stepE));
#ifndef FROM_WHOLE
        votes = bits >> min(m / BLOCK - first, 31) & 1 ? votes : (VECTOR(PARENT))0;
#endif
        CELLS_AT(PARENT, out + j * CELLS) = votes;
    }
}

/* The votes of needed blocks from those of the level below; of chords that need blocks there that
are not needed, 0, as they cannot matter. FROM_WHOLE: the level below is whole, and `needed` is what
is required of the parent's cells, else the bits of requireBlocks. Block rows as of boundBlocks,
rows and segments as of mergeCells in cascade.cl. ENDS = BLOCK: an item takes RUN blocks of a row of
them; global size: runs of the longest row of blocks, rows of blocks. ENDS = 1: an item takes a
chord; global size: chords of the longest row, rows. */
__kernel void mergeBlocks(__global const BlockSegment* blockSegments,
                          __global const int4* blockRows, int blockRowCount,
                          __global const Segment* segments, __global const int4* rows,
#ifdef FROM_WHOLE
                          __global const int* needed,
#else
                          __global const uint* needed,
#endif
                          __global const CHILD* restrict child, __global PARENT* restrict parent)
{
#if ENDS == 1
    const int s = get_global_id(1) / BLOCK, begin = get_global_id(0) / BLOCK, count = 1;
    const int firstRow = get_global_id(1) % BLOCK, endRow = firstRow + 1;
    const int firstEnd = get_global_id(0) % BLOCK;
#else
    const int s = get_global_id(1), begin = get_global_id(0) * RUN, count = RUN;
    const int firstRow = 0, endRow = BLOCK, firstEnd = 0;
#endif
    if (s >= blockRowCount)
        return;
    const int4 blockRow = blockRows[s];
    for (int e = begin; e < min(begin + count, blockRow.y); ++e)
    {
        const int block = blockRow.x + e;
#ifdef FROM_WHOLE
        const uint bits = ANY(CONST_CELLS_AT(int, needed + block * CELLS) != NOT_NEEDED) ? ~0u : 0;
#else
        const uint bits = needed[block];
#endif
        if (!bits)
            continue;
        __global const BlockSegment* const blockSegment =
            segmentOf(blockSegments, s, blockRow.w + e);
        const int i = blockRow.w + e - blockSegment->firstEnd;
        const int k = blockSegment - (blockSegments + s * MAX_SEGMENTS);
        const int first = blockSegment->isCrossing ? crossedBlocks(blockSegment, i).x : 0;
        for (int r = firstRow; r < endRow; ++r)
            mergeChords(segments + (s * BLOCK + r) * MAX_SEGMENTS + k, i * BLOCK + firstEnd, first,
                        bits, child,
                        parent +
                            ((size_t)rows[s * BLOCK + r].x + e * BLOCK + firstEnd) * CELLS);
    }
}

#endif // MERGE

#endif // POOL
