// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Sorts candidates, threes (votes, s, e), in the total order of peaks.hpp: a bitonic network.
// Their number is a power of two and at least BLOCK; what fills it up has fewer votes than any.
//
// One of BLOCKS, STEP, MERGE: what it is compiled for. Blocks of BLOCK are sorted, and merged in the
// end, in the memory of a group.

layout(std430, binding = 0) buffer List { int list[]; };

#define ITEMS numbers[0]
#define LENGTH numbers[1] /* of the sequences that are sorted next, every other one backwards */
#define SPAN numbers[2]   /* of what is compared */

bool isStronger(ivec3 a, ivec3 b)
{
    if (a.x != b.x)
        return a.x > b.x;
    return a.y != b.y ? a.y < b.y : a.z < b.z;
}

ivec3 at(int i)
{
    return ivec3(list[3 * i], list[3 * i + 1], list[3 * i + 2]);
}

void put(int i, ivec3 candidate)
{
    list[3 * i] = candidate.x;
    list[3 * i + 1] = candidate.y;
    list[3 * i + 2] = candidate.z;
}

/* The lower one of pair i of those that are so far apart. */
int lowerOf(int i, int span)
{
    return 2 * span * (i / span) + i % span;
}

#ifdef STEP

/* An item for each pair. */
void main()
{
    int i = int(itemIndex());
    if (2 * i >= ITEMS)
        return;
    int low = lowerOf(i, SPAN);
    ivec3 a = at(low), b = at(low + SPAN);
    if (isStronger(b, a) == ((low & LENGTH) == 0))
    {
        put(low, b);
        put(low + SPAN, a);
    }
}

#else

shared ivec3 sorted[BLOCK];

/* All comparisons of the block for sequences of a length, from a span on. */
void merge(int first, int sequence, int span)
{
    for (; span > 0; span /= 2)
    {
        memoryBarrierShared();
        barrier();
        for (int i = int(gl_LocalInvocationIndex); i < BLOCK / 2; i += GROUP)
        {
            int low = lowerOf(i, span);
            ivec3 a = sorted[low], b = sorted[low + span];
            if (isStronger(b, a) == ((first + low & sequence) == 0))
            {
                sorted[low] = b;
                sorted[low + span] = a;
            }
        }
    }
}

/* Groups: blocks. */
void main()
{
    int item = int(gl_LocalInvocationIndex), first = int(groupIndex()) * BLOCK;
    if (first >= ITEMS)
        return;
    for (int i = item; i < BLOCK; i += GROUP)
        sorted[i] = at(first + i);
#ifdef BLOCKS
    for (int sequence = 2; sequence <= BLOCK; sequence *= 2)
        merge(first, sequence, sequence / 2);
#else
    merge(first, LENGTH, BLOCK / 2);
#endif
    memoryBarrierShared();
    barrier();
    for (int i = item; i < BLOCK; i += GROUP)
        put(first + i, sorted[i]);
}
#endif
