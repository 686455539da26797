// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The drop-in for cv::HoughLines (doc/algorithm.md, section 8): the edge pixels of an image, the
// lines of the grid that the table of the frame supports, their votes, and those of more votes than
// the threshold in the order of the grid. houghgrid.hpp and grid_support.hpp define them. Sums are
// of integers, and everything is listed by count, scan and write: no result depends on the order of
// work items.
//
// GROUP: most work items of a group. PROCESSOR: one work item does what is a group's on other
// devices. WEIGHTED: pixels vote with their values. WIDE: positions may be 2^22 or more.
// LOCAL_BINS: the lines of an angle fit the local memory. SUPPORTED: only supported lines are
// counted. VOTES: the type of the table.

/* Positions decide like the host's: each product is rounded. */
#pragma OPENCL FP_CONTRACT OFF

enum
{
    TILE = 256, /* consecutive pixels of a row */
    RUN = 256   /* edge pixels whose positions a processor finds before it counts them */
};

/* An angle of the grid: of its unit of rho; its lines are first .. first + count - 1. */
typedef struct
{
    float cosine, sine;
    int first, count, isAxisParallel;
} Angle;

#ifdef PROCESSOR
#define ITEM 0
#define ITEMS 1
#define IS_IDLE (get_global_id(0) > 0)
#define MEET
#define ADD(sum, value) *(sum) += (value)
#else
#define ITEM (int)get_local_id(0)
#define ITEMS (int)get_local_size(0)
#define IS_IDLE (get_group_id(0) > 0)
#define MEET barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE)
#define ADD(sum, value) atomic_add(sum, value)
#endif

/* Lists of counts begin with their sum, once they are scanned; then each is the sum of those
before. */
inline int endOf(__global const int* starts, int i, int count)
{
    return i + 1 < count ? starts[i + 2] : starts[0];
}

/* Global size: one group, of any size. */
__kernel void scanCounts(__global int* counts, int count)
{
    __local int sums[GROUP];
    const int item = get_local_id(0), items = get_local_size(0);
    const int share = (count + items - 1) / items;
    const int begin = min(count, item * share), end = min(count, begin + share);
    int sum = 0;
    for (int i = begin; i < end; ++i)
        sum += counts[1 + i];
    sums[item] = sum;
    barrier(CLK_LOCAL_MEM_FENCE);
    int before = 0;
    for (int i = 0; i < item; ++i)
        before += sums[i];
    for (int i = begin; i < end; ++i)
    {
        const int own = counts[1 + i];
        counts[1 + i] = before;
        before += own;
    }
    if (item == items - 1)
        counts[0] = before;
}

/* How many edge pixels each tile has; tilesPerRow tiles cover a row. Global size: tiles. */
__kernel void countPixels(__global const uchar* image, int step, int offset, int rows, int columns,
                          int tilesPerRow, __global int* counts)
{
    const int tile = get_global_id(0), y = tile / tilesPerRow;
    if (y >= rows)
        return;
    const int begin = (tile - y * tilesPerRow) * TILE, end = min(begin + TILE, columns);
    __global const uchar* const row = image + offset + (size_t)y * step;
    int x = begin;
    char16 found = 0; /* -1 for each, of TILE / 16 at most */
    for (; x + 16 <= end; x += 16)
        found += vload16(0, row + x) != (uchar16)0;
    const short8 sum8 = convert_short8(found.lo) + convert_short8(found.hi);
    const short4 sum4 = sum8.lo + sum8.hi;
    int count = -(sum4.x + sum4.y + sum4.z + sum4.w);
    for (; x < end; ++x)
        count += row[x] != 0;
    counts[1 + tile] = count;
}

/* Lists the edge pixels by rows. Global size: tiles. */
__kernel void writePixels(__global const uchar* image, int step, int offset, int rows, int columns,
                          int tilesPerRow, __global const int* starts, __global float* xs,
                          __global float* ys
#ifdef WEIGHTED
                          ,
                          __global int* weights
#endif
)
{
    const int tile = get_global_id(0), y = tile / tilesPerRow;
    if (y >= rows)
        return;
    const int begin = (tile - y * tilesPerRow) * TILE, end = min(begin + TILE, columns);
    const int last = endOf(starts, tile, tilesPerRow * rows);
    __global const uchar* const row = image + offset + (size_t)y * step;
    int place = starts[1 + tile];
    for (int x = begin; x < end && place < last; ++x)
    {
        if ((x - begin) % 16 == 0 && x + 16 <= end && !any(vload16(0, row + x) != (uchar16)0))
        {
            x += 15;
            continue;
        }
        if (!row[x])
            continue;
        xs[place] = (float)x;
        ys[place] = (float)y;
#ifdef WEIGHTED
        weights[place] = row[x];
#endif
        ++place;
    }
}

#ifdef VOTES

/* As struct SampleRun. */
typedef struct
{
    long begin, end, from, fromStep, to, toStep;
    int fromFirst, fromLast, toFirst, toLast;
} SampleRun;

enum
{
    MOST_RUNS = 3,
    SAMPLE_FRACTION = 32
};

/* The most votes among the chords of the points that sample f meets and their neighbours. */
inline int mostVotesNear(__global const VOTES* table, Frame frame, __global const SampleRun* run,
                         long f)
{
    const long from = run->from + (f - run->begin) * run->fromStep;
    const long to = run->to + (f - run->begin) * run->toStep;
    const int fromFirst = run->fromFirst, fromLast = run->fromLast;
    const int s = clamp((int)(from >> SAMPLE_FRACTION), fromFirst, fromLast);
    const int e = clamp((int)(to >> SAMPLE_FRACTION), run->toFirst, run->toLast);
    const int s1 = min(s + 1, fromLast);
    const int e0 = max(e - 1, run->toFirst), e1 = min(e + 1, run->toLast);
    const int firstPartner = sideOf(frame, s).y;
    int most = 0;
    for (int p = max(s - 1, fromFirst); p <= s1; ++p)
    {
        __global const VOTES* const row = table + rowStart(frame, p) - firstPartner;
        most = max(most, max((int)row[e], max((int)row[e0], (int)row[e1])));
    }
    return most;
}

/* Which lines have samples with `needed` votes together. Global size: most lines of an angle,
angles. */
__kernel void findSupported(__global const VOTES* table, int width, int height,
                            __global const SampleRun* runs, __global const Angle* angles,
                            int angleCount, int columns, int samples, int needed,
                            __global uchar* supported)
{
    const int i = get_global_id(0), angle = get_global_id(1);
    if (angle >= angleCount || i >= angles[angle].count)
        return;
    const Frame frame = {width, height};
    int support = 0;
    for (int k = 0; k < MOST_RUNS; ++k)
    {
        __global const SampleRun* const run = runs + MOST_RUNS * angle + k;
        const long end = min(run->end, (i + 1) * (long)samples);
        for (long f = max(run->begin, i * (long)samples); f < end; ++f)
            support += mostVotesNear(table, frame, run, f);
    }
    supported[angle * columns + i + 1] = support >= needed;
}

#endif // VOTES

#ifdef LOCAL_BINS
#define BINS __local int
#else
#define BINS __global int
#endif

inline float position(float x, float y, Angle angle)
{
    return x * angle.cosine + y * angle.sine;
}

#ifdef WIDE
#define NEAREST(value) convert_int_rte(value)
#define NEAREST16(value) convert_int16_rte(value)
#else
/* Adding 1.5 * 2^23 leaves the nearest integer in the low bits. */
#define NEAREST(value) (as_int((value) + 12582912.f) - 0x4B400000)
#define NEAREST16(value) (as_int16((value) + 12582912.f) - 0x4B400000)
#endif

/* The votes of all pixels for all lines of an angle; a line's bin is its number - first + 1, so
that those next to the lines of the image have bins too. */
inline void countAll(__global const float* xs, __global const float* ys,
#ifdef WEIGHTED
                     __global const int* weights,
#endif
                     int pixels, Angle angle, BINS* bins)
{
#ifdef WEIGHTED
#define WEIGHT(k) weights[k]
#else
#define WEIGHT(k) 1
#endif
    BINS* const origin = bins + 1 - angle.first;
    int k = ITEM;
    if (angle.isAxisParallel)
    {
        /* Between two lines, a pixel votes for both. */
        for (; k < pixels; k += ITEMS)
        {
            const float at = position(xs[k], ys[k], angle);
            const int low = (int)ceil(at - 0.5f), high = (int)floor(at + 0.5f);
            ADD(origin + low, WEIGHT(k));
            if (high != low)
                ADD(origin + high, WEIGHT(k));
        }
        return;
    }
#ifdef PROCESSOR
    for (; k + RUN <= pixels; k += RUN)
    {
        int16 nearest[RUN / 16];
        for (int j = 0; j < RUN / 16; ++j)
        {
            const float16 x = *(__global const float16*)(xs + k + 16 * j);
            const float16 y = *(__global const float16*)(ys + k + 16 * j);
            nearest[j] = NEAREST16(x * angle.cosine + y * angle.sine);
        }
        const int* const lines = (const int*)nearest;
        for (int j = 0; j < RUN; ++j)
            origin[lines[j]] += WEIGHT(k + j);
    }
#endif
    for (; k < pixels; k += ITEMS)
        ADD(origin + NEAREST(position(xs[k], ys[k], angle)), WEIGHT(k));
}

#ifdef SUPPORTED

/* The votes of one line, by walking along it: pixels in a strip somewhat wider than its band are
asked for their positions. Each item has steps of its own and adds up what it finds. */
inline void countLine(__global const uchar* image, int step, int rows, int columns, Angle angle,
                      int line, BINS* sum)
{
    const float c = angle.cosine, s = angle.sine;
    const bool xMajor = fabs(s) >= fabs(c);
    const float major = xMajor ? c : s, minor = xMajor ? s : c;
    const int length = xMajor ? columns : rows, limit = xMajor ? rows : columns;
    const float margin = 1e-3f * (1 + fabs((float)line) * 1e-3f);
    const float reach = (0.5f + margin) / fabs(minor) + 1e-3f;
    const int majorStep = xMajor ? 1 : step, minorStep = xMajor ? step : 1;
    int votes = 0;
    for (int i = ITEM; i < length; i += ITEMS)
    {
        const float centre = (line - i * major) / minor;
        if (!(centre > -reach - 1 && centre < limit + reach))
            continue;
        const int first = max(0, (int)ceil(centre - reach));
        const int last = min(limit - 1, (int)floor(centre + reach));
        for (int k = first; k <= last; ++k)
        {
            const int value = image[i * majorStep + k * minorStep];
            if (!value)
                continue;
            const float at = position(xMajor ? i : k, xMajor ? k : i, angle);
            if (angle.isAxisParallel
                    ? (int)ceil(at - 0.5f) == line || (int)floor(at + 0.5f) == line
                    : NEAREST(at) == line)
#ifdef WEIGHTED
                votes += value;
#else
                ++votes;
#endif
        }
    }
    if (votes)
        ADD(sum, votes);
}

#endif // SUPPORTED

/* The votes of the lines of an angle (0 of those that are not supported), and how many lines have
more than `least`. If at most mostWalked lines of an angle are supported each is walked along, else
all pixels are counted. A group has an angle; its items share the pixels and add to bins that
are the group's. Global size: a group, angles. */
__kernel void countVotes(__global const float* xs, __global const float* ys,
#ifdef WEIGHTED
                         __global const int* weights,
#endif
                         int pixels, __global const Angle* angles, int angleCount, int columns,
                         int least,
#ifdef SUPPORTED
                         __global const uchar* image, int step, int offset, int rows,
                         int imageColumns, __global const uchar* supported, int mostWalked,
#endif
#ifdef LOCAL_BINS
                         __local int* bins,
#endif
                         __global int* votes, __global int* counts)
{
    const int index = get_global_id(1);
    if (index >= angleCount || IS_IDLE)
        return;
    const Angle angle = angles[index];
    __global int* const row = votes + (size_t)index * columns;
#ifndef LOCAL_BINS
    __global int* const bins = row;
#endif
#ifdef PROCESSOR
    int sums[2];
#else
    __local int sums[2];
#endif
    for (int i = ITEM; i < angle.count + 2; i += ITEMS)
        bins[i] = 0;
    if (ITEM == 0)
        sums[0] = sums[1] = 0;
    MEET;
#ifdef SUPPORTED
    __global const uchar* const isSupported = supported + (size_t)index * columns;
    int own = 0;
    for (int i = 1 + ITEM; i <= angle.count; i += ITEMS)
        own += isSupported[i];
    ADD(sums, own);
    MEET;
    if (sums[0] <= mostWalked)
    {
        for (int i = 1; i <= angle.count; ++i)
            if (isSupported[i])
                countLine(image + offset, step, rows, imageColumns, angle, angle.first + i - 1,
                          bins + i);
    }
    else
#endif
        countAll(xs, ys,
#ifdef WEIGHTED
                 weights,
#endif
                 pixels, angle, bins);
    MEET;
    int more = 0;
    for (int i = 1 + ITEM; i <= angle.count; i += ITEMS)
    {
        int sum = bins[i];
#ifdef SUPPORTED
        sum = isSupported[i] ? sum : 0;
#endif
        row[i] = sum;
        more += sum > least;
    }
    ADD(sums + 1, more);
    MEET;
    if (ITEM == 0)
        counts[1 + index] = sums[1];
}

/* Threes of numbers: how many lines there are (and 0, 0), then (votes, angle, number) of each, by
angles and numbers, as far as there is room. Global size: a group, angles. */
__kernel void writeLines(__global const int* votes, __global const Angle* angles, int angleCount,
                         int columns, int least, __global const int* starts, __global int* lines,
                         int room)
{
    const int index = get_global_id(1);
    if (index >= angleCount || IS_IDLE)
        return;
    if (index + ITEM == 0)
        vstore3((int3)(starts[0], 0, 0), 0, lines);
    int place = starts[1 + index];
    if (endOf(starts, index, angleCount) == place)
        return;
    const Angle angle = angles[index];
    __global const int* const row = votes + (size_t)index * columns + 1;
    const int share = (angle.count + ITEMS - 1) / ITEMS;
    const int begin = min(angle.count, ITEM * share), end = min(angle.count, begin + share);
#ifndef PROCESSOR
    __local int sums[GROUP];
    int own = 0;
    for (int i = begin; i < end; ++i)
        own += row[i] > least;
    sums[ITEM] = own;
    MEET;
    for (int i = 0; i < ITEM; ++i)
        place += sums[i];
#endif
    for (int i = begin; i < end; ++i)
    {
        if (row[i] <= least)
            continue;
        if (place < room)
            vstore3((int3)(row[i], index, angle.first + i), 1 + place, lines);
        ++place;
    }
}
