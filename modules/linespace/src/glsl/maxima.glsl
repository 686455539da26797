// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The strongest local maxima of the table of the frame (doc/algorithm.md, section 4.1), as
// peaks.hpp defines them: a search above a cut, a histogram of what it finds, which tells the votes
// of the last one wanted, then count, scan and write. Histograms are counted by atomics, whose
// order does not matter to them; everything else is in the order of the table, which is that of (s,
// e).
//
// One of RESET, SEARCH, RAISE_CUT, CHECK_CUT, CHOOSE_LEAST, COUNT, SCAN, WRITE: what it is compiled
// for. The windows show the table, a word for each chord.

/* Chords of a tile: a bit each of GROUP words of 32. */
#define TILE (GROUP * 32)

#ifndef WINDOWS
layout(std430, binding = 0) buffer State { int state[]; };
#else
layout(std430, binding = BLOCK_A) buffer State { int state[]; };
layout(std430, binding = BLOCK_B) buffer Masks { uint masks[]; };
#endif

/* What the state begins with. */
#define CUT 0     /* what is looked for has more votes */
#define PENDING 1 /* whether the next search is needed */
#define LEAST 2   /* votes of the last maximum wanted */
#define TIES 3    /* how many with as few are wanted */
#define FOUND 4   /* how many are wanted and are there */
/* Then a number for each number of votes, and two for each tile. */
#define HISTOGRAM 8

#define CHORDS numbers[0]
#define WIDTH numbers[1]
#define HEIGHT numbers[2]
#define BINS numbers[3]
#define TILES numbers[4]
#define COUNTS (HISTOGRAM + BINS)

#ifdef RESET
void main()
{
    int bin = int(itemIndex());
    if (bin < BINS)
        state[HISTOGRAM + bin] = 0;
    if (bin == 0)
    {
        state[CUT] = numbers[5];
        state[PENDING] = 1;
    }
}
#endif

#ifdef SEARCH

#if defined(REQUIRED) || defined(INTERVAL)
/* INTERVAL: for each s four ends (AngleEnds). Then, REQUIRED, votes by the length of a chord, of each
bin if there are END_COSINES. */
layout(std430, binding = BLOCK_C) readonly buffer Requirement { int requirement[]; };
#define IMAGE ivec2(numbers[6], numbers[7])
#ifdef INTERVAL
#define LEAST_VOTES (4 * (2 * WIDTH + HEIGHT))
#else
#define LEAST_VOTES 0
#endif
#endif

#ifdef INTERVAL
bool isInInterval(ivec2 chord)
{
    int first = 4 * chord.x;
    return (chord.y >= requirement[first] && chord.y < requirement[first + 1]) ||
           (chord.y >= requirement[first + 2] && chord.y < requirement[first + 3]);
}
#endif

#ifdef REQUIRED

/* Pixels of a chord in the image, as Plan::visibleLength. */
int visibleLength(Frame frame, ivec2 chord)
{
    Raster raster = rasterOf(borderPoint(frame, chord.x), borderPoint(frame, chord.y));
    int majorLimit = raster.xMajor ? IMAGE.x : IMAGE.y;
    int limit = (raster.xMajor ? IMAGE.y : IMAGE.x) * raster.modulus;
    int start = raster.minor * raster.modulus + raster.rest;
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

shared uint found[GROUP];

/* Marks the maxima of a tile above the cut and counts them by their votes; with numbers[5] only a
sample of it, GROUP chords that are not always the same ones. Groups: tiles. */
void main()
{
    uint item = gl_LocalInvocationIndex;
    int tile = int(groupIndex());
    if (tile < TILES && state[PENDING] != 0)
    {
        found[item] = 0u;
        memoryBarrierShared();
        barrier();
        int cut = state[CUT];
        bool isSample = numbers[5] != 0;
        int begin = isSample ? int((uint(tile) * 2654435769u) >> 27) : 0;
        int end = isSample ? begin + 1 : 32;
        Frame frame = Frame(WIDTH, HEIGHT);
        for (int k = begin; k < end; ++k)
        {
            int i = tile * TILE + k * GROUP + int(item);
            int votes = i < CHORDS ? int(tableAt(uint(i))) : 0;
            if (votes <= cut)
                continue;
            ivec2 chord = chordAt(frame, i);
#ifdef INTERVAL
            if (!isInInterval(chord))
                continue;
#endif
            if (!isMaximum(frame, chord, i, votes))
                continue;
#ifdef REQUIRED
            int entry = LEAST_VOTES + visibleLength(frame, chord);
#ifdef END_COSINES
            entry += (max(IMAGE.x, IMAGE.y) + 1) *
                     directionBin(borderPoint(frame, chord.y) - borderPoint(frame, chord.x));
#endif
            if (votes < requirement[entry])
                continue;
#endif
            atomicOr(found[uint(k * GROUP / 32) + (item >> 5)], 1u << (item & 31u));
            atomicAdd(state[HISTOGRAM + votes], 1);
        }
        memoryBarrierShared();
        barrier();
        masks[tile * GROUP + int(item)] = found[item];
    }
}
#endif

#if defined(RAISE_CUT) || defined(CHECK_CUT) || defined(CHOOSE_LEAST)

shared int sums[GROUP];
shared ivec2 result;

/* One group: the largest number of votes that `rank` maxima of the histogram have or exceed, -1 if
fewer are there; and how many exceed it. Returns to all items. */
ivec2 votesOfRank(int rank)
{
    int item = int(gl_LocalInvocationIndex), share = (BINS + GROUP - 1) / GROUP;
    int begin = min(BINS, item * share), end = min(BINS, begin + share);
    int sum = 0;
    for (int bin = begin; bin < end; ++bin)
        sum += state[HISTOGRAM + bin];
    sums[item] = sum;
    memoryBarrierShared();
    barrier();
    if (item == 0)
    {
        int above = 0, part = GROUP - 1;
        while (part >= 0 && above + sums[part] < rank)
        {
            above += sums[part];
            --part;
        }
        int votes = -1;
        if (part >= 0)
        {
            votes = min(BINS, (part + 1) * share) - 1;
            for (; above + state[HISTOGRAM + votes] < rank; --votes)
                above += state[HISTOGRAM + votes];
        }
        result = ivec2(votes, above);
    }
    memoryBarrierShared();
    barrier();
    return result;
}

void clearHistogram()
{
    for (int bin = int(gl_LocalInvocationIndex); bin < BINS; bin += GROUP)
        state[HISTOGRAM + bin] = 0;
}

/* One group. RAISE_CUT, after a search of a sample: the cut leaves its strongest numbers[5].
CHECK_CUT, after the search for numbers[5]: whether it must be done again from the lowest cut
numbers[6], as too little was found. CHOOSE_LEAST: which of those found are the strongest numbers[5]. */
void main()
{
    ivec2 last = votesOfRank(numbers[5]);
#if defined(CHECK_CUT)
    bool clears = last.x < 0 && state[CUT] > numbers[6];
#else
    bool clears = true;
#endif
    barrier();
#ifndef CHOOSE_LEAST
    if (clears)
        clearHistogram();
#endif
    if (gl_LocalInvocationIndex != 0u)
        return;
#if defined(RAISE_CUT)
    if (last.x >= 0)
        state[CUT] = last.x - 1;
#elif defined(CHECK_CUT)
    state[PENDING] = int(clears);
    if (clears)
        state[CUT] = numbers[6];
#else
    state[LEAST] = last.x;
    state[TIES] = last.x < 0 ? 0 : numbers[5] - last.y;
    state[FOUND] = last.x < 0 ? last.y : numbers[5];
#endif
}
#endif

#if defined(COUNT) || defined(WRITE)

shared ivec2 before[GROUP];

/* The chord of the lowest bit of a word. */
int chordOf(int tile, uint word)
{
    return tile * TILE + int(gl_LocalInvocationIndex) * 32 + findLSB(word);
}

/* How many maxima of an item's word have more votes than the least, and how many as few. */
ivec2 countWord(int tile, uint word)
{
    ivec2 count = ivec2(0);
    int least = state[LEAST];
    for (; word != 0u; word &= word - 1u)
    {
        int votes = int(tableAt(uint(chordOf(tile, word))));
        count += ivec2(int(votes > least), int(votes == least));
    }
    return count;
}
#endif

#ifdef COUNT
/* Of each tile. Groups: tiles. */
void main()
{
    int tile = int(groupIndex());
    if (tile < TILES)
    {
        uint item = gl_LocalInvocationIndex;
        before[item] = countWord(tile, masks[tile * GROUP + int(item)]);
        for (uint span = uint(GROUP / 2); span > 0u; span /= 2u)
        {
            memoryBarrierShared();
            barrier();
            if (item < span)
                before[item] += before[item + span];
        }
        if (item == 0u)
        {
            state[COUNTS + 2 * tile] = before[0].x;
            state[COUNTS + 2 * tile + 1] = before[0].y;
        }
    }
}
#endif

#ifdef SCAN
shared ivec2 sums[GROUP];

/* One group: from the counts of tiles to those of all tiles before. */
void main()
{
    int item = int(gl_LocalInvocationIndex), share = (TILES + GROUP - 1) / GROUP;
    int begin = min(TILES, item * share), end = min(TILES, begin + share);
    ivec2 sum = ivec2(0);
    for (int tile = begin; tile < end; ++tile)
        sum += ivec2(state[COUNTS + 2 * tile], state[COUNTS + 2 * tile + 1]);
    sums[item] = sum;
    memoryBarrierShared();
    barrier();
    ivec2 total = ivec2(0);
    for (int i = 0; i < item; ++i)
        total += sums[i];
    for (int tile = begin; tile < end; ++tile)
    {
        ivec2 count = ivec2(state[COUNTS + 2 * tile], state[COUNTS + 2 * tile + 1]);
        state[COUNTS + 2 * tile] = total.x;
        state[COUNTS + 2 * tile + 1] = total.y;
        total += count;
    }
}
#endif

#ifdef WRITE
layout(std430, binding = BLOCK_C) writeonly buffer Maxima { int maxima[]; };

/* Threes of numbers: how many maxima there are (and 0, 0), then (votes, s, e) of each, in the order
of the table, as far as there is room for numbers[5]. Groups: tiles. */
void main()
{
    int tile = int(groupIndex());
    if (tile < TILES)
    {
        uint item = gl_LocalInvocationIndex;
        uint word = masks[tile * GROUP + int(item)];
        before[item] = countWord(tile, word);
        memoryBarrierShared();
        barrier();
        ivec2 place = ivec2(state[COUNTS + 2 * tile], state[COUNTS + 2 * tile + 1]);
        for (uint i = 0u; i < item; ++i)
            place += before[i];
        int least = state[LEAST], ties = state[TIES];
        Frame frame = Frame(WIDTH, HEIGHT);
        for (; word != 0u; word &= word - 1u)
        {
            int i = chordOf(tile, word), votes = int(tableAt(uint(i)));
            int at = place.x + min(place.y, ties);
            if ((votes > least || (votes == least && place.y < ties)) && at < numbers[5])
            {
                ivec2 chord = chordAt(frame, i);
                maxima[3 + 3 * at] = votes;
                maxima[4 + 3 * at] = chord.x;
                maxima[5 + 3 * at] = chord.y;
            }
            place += ivec2(int(votes > least), int(votes == least));
        }
        if (tile == 0 && item == 0u)
        {
            maxima[0] = state[FOUND];
            maxima[1] = 0;
            maxima[2] = 0;
        }
    }
}
#endif
