// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The strongest local maxima of the table of the frame (doc/algorithm.md, section 4.1), as
// peaks.hpp defines them: a search above a cut, a histogram of what it finds, which tells the votes
// of the last one wanted, then count, scan and write. Everything is in the order of the table,
// which is that of (s, e): no result depends on the order of work items.
//
// VOTES: the type of votes. RADIUS: of the neighbourhood on the ring of border points; -1: only
// the two chords parallel to it on either side. SQUARE: in their place, of the chords of a block
// of so many s and e, a power of two, as SUPPRESS_BLOCKS has them. BLOCK: only chords of needed
// blocks of pruning.cl are in the table; those of others have no more votes than the cut.
// REQUIRED: by the length of a chord, with END_COSINES also by its bin, more votes are asked for.
// INTERVAL: only chords with one of the ends of AngleEnds.

enum
{
    RUN = 32, /* consecutive chords of the table, a bit each of a mask */
    TILE = 64 /* consecutive runs */
};

/* Numbers of the search. */
enum
{
    LEAST,   /* votes of the last maximum wanted */
    TIES,    /* how many with as few are wanted */
    FOUND,   /* how many are wanted and are there */
    USUAL,   /* a cut that leaves a few more than are wanted, -1: there are not so many */
    COUNTED, /* blocks that were searched */
    NUMBERS
};

#ifdef BLOCK
#define NEEDED_PARAMETER , __global const uint *needed
#define NEEDED_ARGUMENT , needed
#else
#define NEEDED_PARAMETER
#define NEEDED_ARGUMENT
#endif

#define VOTES16 CONCAT(VOTES, 16)

/* Global size: the larger of bins and runs. */
__kernel void resetSearch(__global int* histogram, int bins, __global uint* masks, int runs,
                          __global int* numbers)
{
    const int item = get_global_id(0);
    if (item < bins)
        histogram[item] = 0;
    if (item < runs)
        masks[item] = 0;
    if (item == 0)
        numbers[COUNTED] = 0;
}

/* Whether the chord of two points, which may be beyond the ring's ends, comes before chord i of
`votes` votes in the total order. */
inline bool isStrongerAt(Frame frame, __global const VOTES* table NEEDED_PARAMETER, int p, int q,
                         int i, int votes)
{
    const int points = 2 * (frame.width + frame.height);
    p = p < 0 ? p + points : p >= points ? p - points : p;
    q = q < 0 ? q + points : q >= points ? q - points : q;
    const int s = min(p, q), e = max(p, q), firstPartner = sideOf(frame, s).y;
    if (e < firstPartner)
        return false;
#ifdef BLOCK
    const Frame coarse = {frame.width / BLOCK, frame.height / BLOCK};
    if (!needed[rowStart(coarse, s / BLOCK) + (e - firstPartner) / BLOCK])
        return false;
#endif
    const int other = rowStart(frame, s) + e - firstPartner, otherVotes = table[other];
    return otherVotes > votes || (otherVotes == votes && other < i);
}

inline bool isMaximum(Frame frame, __global const VOTES* table NEEDED_PARAMETER, int2 chord, int i,
                      int votes)
{
#ifdef SQUARE
    const int left = 2 * frame.width + frame.height, points = left + frame.height;
    const int row = chord.x & -SQUARE, column = chord.y & -SQUARE;
    for (int s = row; s < min(row + SQUARE, left); ++s)
        for (int e = max(column, sideOf(frame, s).y); e < min(column + SQUARE, points); ++e)
            if (isStrongerAt(frame, table NEEDED_ARGUMENT, s, e, i, votes))
                return false;
    return true;
#elif RADIUS < 0
    return !isStrongerAt(frame, table NEEDED_ARGUMENT, chord.x + 1, chord.y - 1, i, votes) &&
           !isStrongerAt(frame, table NEEDED_ARGUMENT, chord.x - 1, chord.y + 1, i, votes);
#else
    for (int k = 0; k <= RADIUS; k = k > 0 ? -k : 1 - k) /* the nearest rows first */
        for (int j = -RADIUS; j <= RADIUS; ++j)
            if (isStrongerAt(frame, table NEEDED_ARGUMENT, chord.x + k, chord.y + j, i, votes))
                return false;
    return true;
#endif
}

#ifdef REQUIRED
/* Pixels of a chord in the image, as Plan::visibleLength. */
inline int visibleLength(Frame frame, int2 image, int2 chord)
{
    const Raster raster = rasterOf(borderPoint(frame.width, frame.height, chord.x),
                                   borderPoint(frame.width, frame.height, chord.y));
    const int majorLimit = raster.xMajor ? image.x : image.y;
    const int limit = (raster.xMajor ? image.y : image.x) * raster.modulus;
    const int start = raster.minor * raster.modulus + raster.rest;
    int begin = 0, end = min(raster.count, majorLimit - raster.first);
    if (end <= 0)
        return 0;
    if (raster.step > 0)
    {
        if (start >= limit)
            end = 0;
        else if (start + (end - 1) * raster.step >= limit)
            end = (limit - start - 1) / raster.step + 1;
    }
    else if (start >= limit)
        begin = raster.step == 0 ? end : (start - limit) / -raster.step + 1;
    return max(0, end - begin);
}
#endif

#ifdef REQUIRED
#define LENGTH_PARAMETERS                                                                          \
    , __global const int *leastVotes, int lengths, int imageWidth, int imageHeight
#define LENGTH_ARGUMENTS , leastVotes, lengths, imageWidth, imageHeight
#else
#define LENGTH_PARAMETERS
#define LENGTH_ARGUMENTS
#endif
#ifdef INTERVAL
#define REQUIRED_PARAMETERS LENGTH_PARAMETERS, __global const int4 *ends
#define REQUIRED_ARGUMENTS LENGTH_ARGUMENTS, ends
#else
#define REQUIRED_PARAMETERS LENGTH_PARAMETERS
#define REQUIRED_ARGUMENTS LENGTH_ARGUMENTS
#endif

/* Whether chord i is wanted: a maximum, in the interval of angles, that has what its length and
direction require. */
inline bool isWanted(Frame frame, __global const VOTES* table NEEDED_PARAMETER REQUIRED_PARAMETERS,
                     int2 chord, int i, int votes)
{
#ifdef INTERVAL
    const int4 own = ends[chord.x];
    if (!((chord.y >= own.x && chord.y < own.y) || (chord.y >= own.z && chord.y < own.w)))
        return false;
#endif
    if (!isMaximum(frame, table NEEDED_ARGUMENT, chord, i, votes))
        return false;
#ifdef REQUIRED
    int entry = visibleLength(frame, (int2)(imageWidth, imageHeight), chord);
#ifdef END_COSINES
    entry += lengths * directionBin(borderPoint(frame.width, frame.height, chord.y) -
                                    borderPoint(frame.width, frame.height, chord.x));
#endif
    if (votes < leastVotes[entry])
        return false;
#endif
    return true;
}

#ifdef BLOCK

#define VOTES8 CONCAT(VOTES, 8)

/* Marks the maxima above the cut and counts them by their votes. An item takes PIECES times 8
consecutive ends of BLOCK rows: a byte of a mask for each 8 chords of a row, as their first one's
index is a multiple of 8. Global size: such of the longest row, rows of blocks. */
__kernel void searchBlocks(__global const VOTES* table, __global const uint* needed, int width,
                           int height REQUIRED_PARAMETERS, int cut, __global int* histogram,
                           __global uchar* masks, __global int* numbers)
{
    const Frame frame = {width, height}, coarse = {width / BLOCK, height / BLOCK};
    const int s = get_global_id(1), begin = get_global_id(0) * PIECES;
    if (s >= 2 * coarse.width + coarse.height)
        return;
    const int firstPartner = sideOf(frame, s * BLOCK).y;
    const int length = 2 * (width + height) - firstPartner;
    __global const uint* const blocks = needed + rowStart(coarse, s);
    const int start = rowStart(frame, s * BLOCK);
    int counted = 0;
    for (int k = begin; k < min(begin + PIECES, length / 8); ++k)
    {
        if (!blocks[8 * k / BLOCK])
            continue;
        counted += 8 * k % BLOCK == 0;
        for (int row = 0; row < BLOCK; ++row)
        {
            const int first = start + row * length + 8 * k;
            const VOTES8 run = *(__global const VOTES8*)(table + first);
            if (!any(run > (VOTES)cut))
                continue;
            uint mask = 0;
            for (int i = 0; i < 8; ++i)
            {
                const int votes = table[first + i];
                if (votes <= cut)
                    continue;
                const int2 chord = (int2)(s * BLOCK + row, firstPartner + 8 * k + i);
                if (!isWanted(frame, table NEEDED_ARGUMENT REQUIRED_ARGUMENTS, chord, first + i,
                              votes))
                    continue;
                mask |= 1u << i;
                atomic_inc(histogram + votes);
            }
            masks[first / 8] = mask;
        }
    }
    if (counted)
        atomic_add(numbers + COUNTED, counted);
}

#else

/* Marks the maxima of runs above the cut and counts them by their votes: of one run only of
`sample` that follow one another, and not always the same, as rows of the table may be as long as a
multiple of them. Global size: runs to search. */
__kernel void searchMaxima(__global const VOTES* table, int chords, int width,
                           int height REQUIRED_PARAMETERS, int cut, int sample,
                           __global int* histogram, __global uint* masks)
{
    const uint item = get_global_id(0);
    const int run = item * sample + (item * 2654435769u >> 16) % sample, first = run * RUN;
    if (first >= chords)
        return;
    int most;
    if (first + RUN <= chords)
    {
        __global const VOTES16* const runs = (__global const VOTES16*)(table + first);
        const VOTES16 m16 = max(runs[0], runs[1]);
        const CONCAT(VOTES, 8) m8 = max(m16.lo, m16.hi);
        const CONCAT(VOTES, 4) m4 = max(m8.lo, m8.hi);
        const CONCAT(VOTES, 2) m2 = max(m4.lo, m4.hi);
        most = max(m2.x, m2.y);
    }
    else
    {
        most = 0;
        for (int i = first; i < chords; ++i)
            most = max(most, (int)table[i]);
    }
    uint mask = 0;
    if (most > cut)
    {
        const Frame frame = {width, height};
        const int end = min(first + RUN, chords);
        for (int i = first; i < end; ++i)
        {
            const int votes = table[i];
            if (votes <= cut ||
                !isWanted(frame, table REQUIRED_ARGUMENTS, chordAt(frame, i), i, votes))
                continue;
            mask |= 1u << (i - first);
            atomic_inc(histogram + votes);
        }
    }
    masks[run] = mask;
}

#endif

/* One group: the largest number of votes that `rank` maxima of the histogram have or exceed, -1 if
fewer are there; and how many exceed it. Returns to all items. */
inline int2 votesOfRank(__global const int* histogram, int bins, int rank, __local int* sums,
                        __local int2* result)
{
    const int item = get_local_id(0), items = get_local_size(0);
    const int share = (bins + items - 1) / items;
    const int begin = min(bins, item * share), end = min(bins, begin + share);
    int sum = 0;
    for (int bin = begin; bin < end; ++bin)
        sum += histogram[bin];
    sums[item] = sum;
    barrier(CLK_LOCAL_MEM_FENCE);
    if (item == 0)
    {
        int above = 0, part = items - 1;
        while (part >= 0 && above + sums[part] < rank)
            above += sums[part--];
        int votes = -1;
        if (part >= 0)
        {
            votes = min(bins, (part + 1) * share) - 1;
            for (; above + histogram[votes] < rank; --votes)
                above += histogram[votes];
        }
        *result = (int2)(votes, above);
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    return *result;
}

/* Which of those found are the strongest `most`. Global size: one group, as of scanTiles. */
__kernel void chooseLeast(__global const int* histogram, int bins, int most, __global int* numbers)
{
    __local int sums[GROUP];
    __local int2 result;
    const int2 last = votesOfRank(histogram, bins, most, sums, &result);
    const int2 usual = votesOfRank(histogram, bins, most + most / 16, sums, &result);
    if (get_local_id(0) == 0)
    {
        numbers[LEAST] = last.x;
        numbers[TIES] = last.x < 0 ? 0 : most - last.y;
        numbers[FOUND] = last.x < 0 ? last.y : most;
        numbers[USUAL] = max(usual.x - 1, -1);
    }
}

/* How many maxima of each tile have more votes than the least, and how many as few. Global size:
tiles. */
__kernel void countTiles(__global const VOTES* table, __global const uint* masks, int runs,
                         __global const int* numbers, __global int2* counts, int tiles)
{
    const int tile = get_global_id(0), least = numbers[LEAST];
    if (tile >= tiles)
        return;
    int2 count = 0;
    const int end = min(runs, (tile + 1) * TILE);
    for (int run = tile * TILE; run < end; ++run)
        for (uint mask = masks[run]; mask; mask &= mask - 1)
        {
            const int votes = table[run * RUN + 31 - (int)clz(mask & -mask)];
            count += (int2)(votes > least, votes == least);
        }
    counts[tile] = count;
}

/* From the counts of tiles to those of all tiles before. */
__kernel void scanTiles(__global int2* counts, int tiles)
{
    __local int2 sums[GROUP];
    const int item = get_local_id(0), items = get_local_size(0);
    const int share = (tiles + items - 1) / items;
    const int begin = min(tiles, item * share), end = min(tiles, begin + share);
    int2 sum = 0;
    for (int tile = begin; tile < end; ++tile)
        sum += counts[tile];
    sums[item] = sum;
    barrier(CLK_LOCAL_MEM_FENCE);
    int2 before = 0;
    for (int i = 0; i < item; ++i)
        before += sums[i];
    for (int tile = begin; tile < end; ++tile)
    {
        const int2 count = counts[tile];
        counts[tile] = before;
        before += count;
    }
}

/* Threes of numbers: how many maxima there are, USUAL and COUNTED, then (votes, s, e) of each, in
the order of the table, as far as there is room. Global size: tiles. */
__kernel void writeMaxima(__global const VOTES* table, int width, int height,
                          __global const uint* masks, int runs, __global const int* numbers,
                          __global const int2* counts, int tiles, __global int* maxima, int room)
{
    const int tile = get_global_id(0), least = numbers[LEAST], ties = numbers[TIES];
    if (tile >= tiles)
        return;
    if (tile == 0)
        vstore3((int3)(numbers[FOUND], numbers[USUAL], numbers[COUNTED]), 0, maxima);
    int2 before = counts[tile];
    const int end = min(runs, (tile + 1) * TILE);
    const Frame frame = {width, height};
    for (int run = tile * TILE; run < end; ++run)
        for (uint mask = masks[run]; mask; mask &= mask - 1)
        {
            const int i = run * RUN + 31 - (int)clz(mask & -mask), votes = table[i];
            const int place = before.x + min(before.y, ties);
            if ((votes > least || (votes == least && before.y < ties)) && place < room)
            {
                const int2 chord = chordAt(frame, i);
                vstore3((int3)(votes, chord.x, chord.y), 1 + place, maxima);
            }
            before += (int2)(votes > least, votes == least);
        }
}
