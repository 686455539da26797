// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Sorts candidates, threes (votes, s, e) in the order of (s, e), by their votes, the most first: a
// radix sort from the lowest digit of four bits on, which keeps the order of equal digits, so that
// the result is in the total order of peaks.hpp.
//
// One of COUNT, SCAN, SCATTER: what it is compiled for, launched one after the other for each
// digit. A tile is of GROUP candidates.

layout(std430, binding = 0) buffer Counts { int counts[]; }; /* by digits, then tiles */

#define ITEMS numbers[0]
#define TILES numbers[1]
#define SHIFT numbers[2]
#define DIGITS 16

#ifdef SCAN

shared int sums[GROUP];

/* One group: from counts to how many candidates are before those of the digit and tile. */
void main()
{
    int item = int(gl_LocalInvocationIndex), all = DIGITS * TILES;
    int share = (all + GROUP - 1) / GROUP, begin = min(all, item * share);
    int end = min(all, begin + share);
    int sum = 0;
    for (int i = begin; i < end; ++i)
        sum += counts[i];
    sums[item] = sum;
    memoryBarrierShared();
    barrier();
    int before = 0;
    for (int i = 0; i < item; ++i)
        before += sums[i];
    for (int i = begin; i < end; ++i)
    {
        int count = counts[i];
        counts[i] = before;
        before += count;
    }
}

#else

layout(std430, binding = 1) readonly buffer From { int from[]; };
#ifdef SCATTER
layout(std430, binding = 2) writeonly buffer To { int to[]; };
#endif

#define WORDS (GROUP / 32)

shared uint holders[DIGITS * WORDS]; /* of each digit, a bit for each item */

/* Groups: tiles. */
void main()
{
    int item = int(gl_LocalInvocationIndex), tile = int(groupIndex());
    if (tile >= TILES)
        return;
    int i = tile * GROUP + item;
    int digit = i < ITEMS ? DIGITS - 1 - (from[3 * i] >> SHIFT & (DIGITS - 1)) : 0;
    for (int k = item; k < DIGITS * WORDS; k += GROUP)
        holders[k] = 0u;
    memoryBarrierShared();
    barrier();
    if (i < ITEMS)
        atomicOr(holders[digit * WORDS + (item >> 5)], 1u << (item & 31));
    memoryBarrierShared();
    barrier();
#ifdef COUNT
    if (item < DIGITS)
    {
        int count = 0;
        for (int k = 0; k < WORDS; ++k)
            count += bitCount(holders[item * WORDS + k]);
        counts[item * TILES + tile] = count;
    }
#else
    if (i >= ITEMS)
        return;
    int place = counts[digit * TILES + tile];
    for (int k = 0; k < item >> 5; ++k)
        place += bitCount(holders[digit * WORDS + k]);
    place += bitCount(holders[digit * WORDS + (item >> 5)] & ((1u << (item & 31)) - 1u));
    for (int k = 0; k < 3; ++k)
        to[3 * place + k] = from[3 * i + k];
#endif
}
#endif
