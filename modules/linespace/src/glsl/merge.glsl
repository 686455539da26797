// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// One level of the cascade from the one below, in rectangles of chords (merge_rectangles.hpp):
// indices are affine there, so that a chord costs one division and no branch. What a chord of the
// parent is made of is computed where it is needed: a table of that would be larger than the votes.
// The votes of as many cells as share a word are added at once. LANES invocations share a chord and
// take its words in turns. Groups: columns times lanes, rows, rectangles of one shape.
//
// CHILD_BITS, PARENT_BITS: of a vote, 8, 16 or 32. CROSSING: the chords have a part in either
// child. The windows show the child's table.

layout(std430, binding = BLOCK_A) writeonly buffer Parent { uint parent[]; };

/* Five of each rectangle. */
layout(location = NUMBERS) uniform ivec4 rectangles[5 * RECTANGLES];

#define FIRST_ITEM numbers[0]
#define FIRST_ROW numbers[1]
#define LANES_LOG numbers[2]
#define CELLS_LOG numbers[3] /* of the parent */
#define PARENT_WORDS numbers[4]
#define CHILD_WORDS uint(numbers[5])
#define MASK uint(numbers[6]) /* of the child's votes that come to a word of the parent */

/* What a chord of one child adds to a word of the parent. */
uint votesOf(uint chord, int child, uint word)
{
    uint cell = (uint(child) << CELLS_LOG) + word * uint(32 / PARENT_BITS);
    uint bit = cell * uint(CHILD_BITS);
    uint votes = tableAt(chord * CHILD_WORDS + (bit >> 5)) >> (bit & 31u) & MASK;
#if CHILD_BITS == 8 && PARENT_BITS == 16
    votes = (votes & 0xFFu) | (votes & 0xFF00u) << 8;
#endif
    return votes;
}

void main()
{
    int item = FIRST_ITEM + int(gl_GlobalInvocationID.x), lanes = 1 << LANES_LOG;
    int a = FIRST_ROW + int(gl_WorkGroupID.y), b = item >> LANES_LOG, lane = item & (lanes - 1);
    int first = 5 * int(gl_WorkGroupID.z);
    ivec4 shape = rectangles[first]; /* columns, rows, start (a chord of the parent), row length */
    if (b >= shape.x || a >= shape.y)
        return;
    ivec4 s = rectangles[first + 1]; /* child, part, step, how it changes with the crossing */
    ivec4 e = rectangles[first + 2]; /* step where nothing crosses; part, step, change */
    int to = (shape.z + a * shape.w + b) * PARENT_WORDS;
#ifdef CROSSING
    ivec4 atS = rectangles[first + 3], atE = rectangles[first + 4]; /* along, step, across, step */
    int alongS = atS.x + a * atS.y, acrossS = atS.z + a * atS.w;
    int alongE = atE.x + b * atE.y, acrossE = atE.z + b * atE.w;
    /* Merge::crossing: the end on child 0 has the negative distance. */
    int product = alongS * acrossE - alongE * acrossS, distance = 2 * (acrossE - acrossS);
    int m = s.x == 0 ? quotient(product, distance) : quotient(-product, -distance);
    uint partS = uint(s.y + a * s.z + m * s.w), partE = uint(e.y + b * e.z + m * e.w);
    for (int word = lane; word < PARENT_WORDS; word += lanes)
        parent[to + word] = votesOf(partS, s.x, uint(word)) + votesOf(partE, 1 - s.x, uint(word));
#else
    uint own = uint(s.y + a * s.z + b * e.x);
    for (int word = lane; word < PARENT_WORDS; word += lanes)
        parent[to + word] = votesOf(own, s.x, uint(word));
#endif
}
