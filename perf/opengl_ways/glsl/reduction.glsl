// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The strongest chords one after the other, as the paper finds them: each is the maximum of the
// table, in the total order, by a parallel reduction; then it is deleted with its neighbourhood.
//
// One of COPY, REDUCE, TAKE: what it is compiled for. COPY with RING_RADIUS: local maxima only.
// TAKE: DELETED_RADIUS: of the neighbourhood; KEPT: the maxima of tiles are kept, and reduced again
// where something was deleted, so that one launch takes all.

#define TILE (GROUP * 32)

#define CHORDS numbers[0]
#define WIDTH numbers[1]
#define HEIGHT numbers[2]
#define TILES numbers[3]

#ifdef COPY
layout(std430, binding = BLOCK_A) writeonly buffer Left { int left[]; };

/* An item for each chord; numbers[4]: more votes than that count. */
void main()
{
    int i = int(itemIndex());
    if (i >= CHORDS)
        return;
    int votes = int(tableAt(uint(i)));
    bool isLeft = votes > numbers[4];
#ifdef RING_RADIUS
    Frame frame = Frame(WIDTH, HEIGHT);
    isLeft = isLeft && isMaximum(frame, chordAt(frame, i), i, votes);
#endif
    left[i] = isLeft ? votes : 0;
}

#else

layout(std430, binding = 0) coherent buffer Left { int left[]; };
/* (votes, chord) of the strongest of each tile. */
layout(std430, binding = 1) coherent buffer Strongest { ivec2 strongest[]; };

shared ivec2 reduced[GROUP];

bool isStronger(ivec2 a, ivec2 b)
{
    return a.x > b.x || (a.x == b.x && a.y < b.y);
}

/* The strongest of those that each item has. Returns to all items. */
ivec2 reduce(ivec2 own)
{
    int item = int(gl_LocalInvocationIndex);
    memoryBarrierShared();
    barrier();
    reduced[item] = own;
    for (int span = GROUP / 2; span > 0; span /= 2)
    {
        memoryBarrierShared();
        barrier();
        if (item < span && isStronger(reduced[item + span], reduced[item]))
            reduced[item] = reduced[item + span];
    }
    memoryBarrierShared();
    barrier();
    return reduced[0];
}

ivec2 strongestOfTile(int tile)
{
    ivec2 own = ivec2(0);
    for (int k = 0; k < 32; ++k)
    {
        int i = tile * TILE + k * GROUP + int(gl_LocalInvocationIndex);
        int votes = i < CHORDS ? left[i] : 0;
        if (votes > own.x)
            own = ivec2(votes, i);
    }
    return reduce(own);
}
#endif

#ifdef REDUCE
/* Groups: tiles. */
void main()
{
    int tile = int(groupIndex());
    if (tile < TILES)
    {
        ivec2 result = strongestOfTile(tile);
        if (gl_LocalInvocationIndex == 0u)
            strongest[tile] = result;
    }
}
#endif

#ifdef TAKE
/* How many are taken (and 0, 0), then (votes, s, e) of each. */
layout(std430, binding = 2) buffer Taken { int taken[]; };

#define NEIGHBOURS ((2 * DELETED_RADIUS + 1) * (2 * DELETED_RADIUS + 1))

#ifdef KEPT
shared int touched[NEIGHBOURS]; /* tiles; -1: none */
#endif

/* The number of neighbour j of a chord; -1: there is none. */
int neighbourOf(Frame frame, ivec2 chord, int j)
{
    int points = 2 * (frame.width + frame.height), side = 2 * DELETED_RADIUS + 1;
    int p = (chord.x + j / side - DELETED_RADIUS + points) % points;
    int q = (chord.y + j % side - DELETED_RADIUS + points) % points;
    return max(p, q) < firstPartner(frame, min(p, q)) ? -1 : chordIndex(frame, p, q);
}

/* One group: takes numbers[5] from numbers[4] on. */
void main()
{
    int item = int(gl_LocalInvocationIndex);
    Frame frame = Frame(WIDTH, HEIGHT);
    for (int k = numbers[4]; k < numbers[4] + numbers[5]; ++k)
    {
        ivec2 own = ivec2(0);
        for (int tile = item; tile < TILES; tile += GROUP)
            if (isStronger(strongest[tile], own))
                own = strongest[tile];
        ivec2 best = reduce(own);
        if (best.x == 0)
            break;
        ivec2 chord = chordAt(frame, best.y);
        for (int j = item; j < NEIGHBOURS; j += GROUP)
        {
            int i = neighbourOf(frame, chord, j);
            if (i >= 0)
                left[i] = 0;
#ifdef KEPT
            touched[j] = i < 0 ? -1 : i / TILE;
#endif
        }
        if (item == 0)
        {
            taken[0] = k + 1;
            taken[3 + 3 * k] = best.x;
            taken[4 + 3 * k] = chord.x;
            taken[5 + 3 * k] = chord.y;
        }
#ifdef KEPT
        memoryBarrierShared();
        memoryBarrierBuffer();
        barrier();
        for (int j = 0; j < NEIGHBOURS; ++j)
        {
            bool isNew = touched[j] >= 0;
            for (int other = 0; other < j; ++other)
                isNew = isNew && touched[other] != touched[j];
            if (!isNew)
                continue;
            ivec2 result = strongestOfTile(touched[j]);
            if (item == 0)
                strongest[touched[j]] = result;
        }
        memoryBarrierBuffer();
        barrier();
#endif
    }
}
#endif
