// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Two levels of the cascade at once, a step of 2 x 2 cells: what a chord is made of in the level
// between is computed, and its votes are not stored. Crossings are rounded one after the other, so
// that the votes are the same. Rectangles are those of the upper merge (merge_rectangles.hpp), cut
// where the lower one cuts the sides of its parent; a crossing comes to one of up to two parts of
// the shared side, and what it is made of there is a rectangle of the lower merge. Groups: columns
// times lanes, rows, rectangles.

layout(std430, binding = BLOCK_A) writeonly buffer Parent { uint parent[]; };
layout(std430, binding = BLOCK_B) readonly buffer Rectangles { ivec4 rectangles[]; };

/* Of each rectangle: the shape; whether it crosses, child of s; both ends, for crossingOf; the
shared side: whether its points go backwards on the border of the child of s, and of that of e, how
many there are, and in a part of it. Then four of each of the lower merge: of s with either part,
of e with either part; of one that does not cross, the first. */
#define OF_S 5
#define OF_E (OF_S + 8)
#define RECORD (OF_E + 8)

/* What a chord of the level between is made of: its own chord in a cell, or with another one in the
other cell. */
struct Between
{
    uint own, other;
    int cell;
    bool isSum;
};

Between betweenOf(int at, bool isSecond, int i, int k)
{
    at += isSecond ? 4 : 0;
    ivec4 f[4] =
        ivec4[4](rectangles[at], rectangles[at + 1], rectangles[at + 2], rectangles[at + 3]);
    /* 0: crosses, cell, part, step of i. 1: change, part, step of k, change. 2, 3: ends. */
    bool isSum = f[0].x != 0;
    int m = isSum ? crossingOf(f[2], f[3], i, k, f[0].y == 0) : 0;
    int own = f[0].z + i * f[0].w + (isSum ? m * f[1].x : k * f[1].z);
    return Between(uint(own), uint(f[1].y + k * f[1].z + m * f[1].w), f[0].y, isSum);
}

uint votesBetween(Between between, int child, uint word)
{
    uint votes = votesOf(between.own, 2 * between.cell + child, word);
    if (between.isSum)
        votes += votesOf(between.other, 2 * (1 - between.cell) + child, word);
    return votes;
}

void main()
{
    int item = numbers[0] + int(gl_GlobalInvocationID.x), lanes = 1 << LANES_LOG;
    int a = numbers[1] + int(gl_WorkGroupID.y), b = item >> LANES_LOG, lane = item & (lanes - 1);
    int first = RECORD * int(gl_WorkGroupID.z);
    ivec4 shape = rectangles[first], kind = rectangles[first + 1];
    if (b >= shape.x || a >= shape.y)
        return;
    int to = (shape.z + a * shape.w + b) * PARENT_WORDS, child = kind.y;
    if (kind.x == 0)
    {
        Between own = betweenOf(first + OF_S, false, a, b);
        for (int word = lane; word < PARENT_WORDS; word += lanes)
            parent[to + word] = votesBetween(own, child, uint(word));
        return;
    }
    int m = crossingOf(rectangles[first + 2], rectangles[first + 3], a, b, child == 0);
    ivec4 side = rectangles[first + 4];
    int onS = side.x != 0 ? side.z - 1 - m : m, onE = side.y != 0 ? side.z - 1 - m : m;
    bool isSecondS = onS >= side.w, isSecondE = onE >= side.w;
    Between s = betweenOf(first + OF_S, isSecondS, a, isSecondS ? onS - side.w : onS);
    Between e = betweenOf(first + OF_E, isSecondE, b, isSecondE ? onE - side.w : onE);
    for (int word = lane; word < PARENT_WORDS; word += lanes)
        parent[to + word] =
            votesBetween(s, child, uint(word)) + votesBetween(e, 1 - child, uint(word));
}
