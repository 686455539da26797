// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// One level of the cascade from the one below, in rectangles of chords (merge_rectangles.hpp):
// indices are affine there, so that a chord costs one division and no branch. What a chord of the
// parent is made of is computed where it is needed: a table of that would be larger than the votes.
// LANES invocations share a chord and take its words in turns. Groups: columns times lanes, rows,
// rectangles of one shape. Compiled after children.glsl.
//
// CROSSING: the chords have a part in either child.

layout(std430, binding = BLOCK_A) writeonly buffer Parent { uint parent[]; };

/* Five of each rectangle. */
layout(location = NUMBERS) uniform ivec4 rectangles[5 * RECTANGLES];

#define FIRST_ITEM numbers[0]
#define FIRST_ROW numbers[1]

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
    int m = crossingOf(rectangles[first + 3], rectangles[first + 4], a, b, s.x == 0);
    uint partS = uint(s.y + a * s.z + m * s.w), partE = uint(e.y + b * e.z + m * e.w);
    for (int word = lane; word < PARENT_WORDS; word += lanes)
        parent[to + word] = votesOf(partS, s.x, uint(word)) + votesOf(partE, 1 - s.x, uint(word));
#else
    uint own = uint(s.y + a * s.z + b * e.x);
    for (int word = lane; word < PARENT_WORDS; word += lanes)
        parent[to + word] = votesOf(own, s.x, uint(word));
#endif
}
