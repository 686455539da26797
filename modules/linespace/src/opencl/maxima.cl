// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The strongest local maxima of the table of the frame (doc/algorithm.md, section 4.1), as peaks.hpp
// defines them: a search above a cut, a histogram of what it finds, which tells the votes of the
// last one wanted, then count, scan and write. Everything is in the order of the table, which is
// that of (s, e): no result depends on the order of work items.
//
// VOTES: the type of votes. RADIUS: of the neighbourhood on the ring of border points; -1: only the
// two chords parallel to it on either side.

enum
{
    RUN = 32, /* consecutive chords of the table, a bit each of a mask */
    TILE = 64 /* consecutive runs */
};

/* Numbers of the search. */
enum
{
    CUT,     /* what is looked for has more votes */
    PENDING, /* whether the next search is needed */
    LEAST,   /* votes of the last maximum wanted */
    TIES,    /* how many with as few are wanted */
    FOUND,   /* how many are wanted and are there */
    NUMBERS
};

#define VOTES16 CONCAT(VOTES, 16)

/* Global size: the larger of bins and 1. */
__kernel void resetSearch(__global int* histogram, int bins, int cut, __global int* numbers)
{
    const int bin = get_global_id(0);
    if (bin < bins)
        histogram[bin] = 0;
    if (bin == 0)
    {
        numbers[CUT] = cut;
        numbers[PENDING] = 1;
    }
}

/* Whether the chord of two points, which may be beyond the ring's ends, comes before chord i of
`votes` votes in the total order. */
inline bool isStrongerAt(Frame frame, __global const VOTES* table, int p, int q, int i, int votes)
{
    const int points = 2 * (frame.width + frame.height);
    p = p < 0 ? p + points : p >= points ? p - points : p;
    q = q < 0 ? q + points : q >= points ? q - points : q;
    const int s = min(p, q), e = max(p, q), firstPartner = sideOf(frame, s).y;
    if (e < firstPartner)
        return false;
    const int other = rowStart(frame, s) + e - firstPartner, otherVotes = table[other];
    return otherVotes > votes || (otherVotes == votes && other < i);
}

inline bool isMaximum(Frame frame, __global const VOTES* table, int2 chord, int i, int votes)
{
#if RADIUS < 0
    return !isStrongerAt(frame, table, chord.x + 1, chord.y - 1, i, votes) &&
           !isStrongerAt(frame, table, chord.x - 1, chord.y + 1, i, votes);
#else
    for (int k = 0; k <= RADIUS; k = k > 0 ? -k : 1 - k) /* the nearest rows first */
        for (int j = -RADIUS; j <= RADIUS; ++j)
            if (isStrongerAt(frame, table, chord.x + k, chord.y + j, i, votes))
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

/* Marks the maxima of runs above the cut and counts them by their votes: of one run only of `sample`
that follow one another, and not always the same, as rows of the table may be as long as a multiple
of them. Global size: runs to search. */
__kernel void searchMaxima(__global const VOTES* table, int chords, int width, int height,
#ifdef REQUIRED
                           __global const int* leastVotes, int imageWidth, int imageHeight,
#endif
                           __global const int* numbers, int sample, __global int* histogram,
                           __global uint* masks)
{
    const uint item = get_global_id(0);
    const int run = item * sample + (item * 2654435769u >> 16) % sample, first = run * RUN;
    if (first >= chords || !numbers[PENDING])
        return;
    const int cut = numbers[CUT];
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
            if (votes <= cut)
                continue;
            const int2 chord = chordAt(frame, i);
            if (!isMaximum(frame, table, chord, i, votes))
                continue;
#ifdef REQUIRED
            if (votes < leastVotes[visibleLength(frame, (int2)(imageWidth, imageHeight), chord)])
                continue;
#endif
            mask |= 1u << (i - first);
            atomic_inc(histogram + votes);
        }
    }
    masks[run] = mask;
}

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

inline void clearHistogram(__global int* histogram, int bins)
{
    for (int bin = get_local_id(0); bin < bins; bin += get_local_size(0))
        histogram[bin] = 0;
}

/* After a search of a sample: the cut leaves its strongest `rank`. Global size: one group, as all
below where nothing else is said. */
__kernel void raiseCut(__global int* histogram, int bins, int rank, __global int* numbers)
{
    __local int sums[GROUP];
    __local int2 result;
    const int votes = votesOfRank(histogram, bins, rank, sums, &result).x;
    barrier(CLK_GLOBAL_MEM_FENCE);
    clearHistogram(histogram, bins);
    if (get_local_id(0) == 0 && votes >= 0)
        numbers[CUT] = votes - 1;
}

/* After the search: whether it must be done again from the lowest cut, as too little was found. */
__kernel void checkCut(__global int* histogram, int bins, int most, int lowest,
                       __global int* numbers)
{
    __local int sums[GROUP];
    __local int2 result;
    const int votes = votesOfRank(histogram, bins, most, sums, &result).x;
    const bool isPending = votes < 0 && numbers[CUT] > lowest;
    barrier(CLK_GLOBAL_MEM_FENCE);
    if (isPending)
        clearHistogram(histogram, bins);
    if (get_local_id(0) == 0)
    {
        numbers[PENDING] = isPending;
        if (isPending)
            numbers[CUT] = lowest;
    }
}

/* Which of those found are the strongest `most`. */
__kernel void chooseLeast(__global const int* histogram, int bins, int most, __global int* numbers)
{
    __local int sums[GROUP];
    __local int2 result;
    const int2 last = votesOfRank(histogram, bins, most, sums, &result);
    if (get_local_id(0) == 0)
    {
        numbers[LEAST] = last.x;
        numbers[TIES] = last.x < 0 ? 0 : most - last.y;
        numbers[FOUND] = last.x < 0 ? last.y : most;
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

/* Threes of numbers: how many maxima there are (and 0, 0), then (votes, s, e) of each, in the order of
the table, as far as there is room. Global size: tiles. */
__kernel void writeMaxima(__global const VOTES* table, int width, int height,
                          __global const uint* masks, int runs, __global const int* numbers,
                          __global const int2* counts, int tiles, __global int* maxima, int room)
{
    const int tile = get_global_id(0), least = numbers[LEAST], ties = numbers[TIES];
    if (tile >= tiles)
        return;
    if (tile == 0)
        vstore3((int3)(numbers[FOUND], 0, 0), 0, maxima);
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
