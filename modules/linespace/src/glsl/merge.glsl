// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// One level of the cascade from the one below, a rectangle of chords (merge_rectangles.hpp) per launch:
// indices are affine there, so that a chord costs one division and no branch. What a chord of the
// parent is made of is computed where it is needed: a table of that would be larger than the votes.
// The votes of as many cells as share a word are added at once. LANES invocations share a chord and
// take its words in turns. Groups: columns of the rectangle times lanes, rows.
//
// CHILD_BITS, PARENT_BITS: of a vote, 8, 16 or 32. CROSSING: the chords have a part in either child.
// The windows show the child's table.

layout(std430, binding = BLOCK_A) writeonly buffer Parent { uint parent[]; };

#define FIRST_ITEM numbers[0]
#define FIRST_ROW numbers[1]
#define COLUMNS numbers[2]
#define LANES_LOG numbers[3]
#define CELLS_LOG numbers[4] /* of the parent */
#define PARENT_WORDS numbers[5]
#define CHILD_WORDS uint(numbers[6])
#define MASK uint(numbers[7]) /* of the child's votes that come to a word of the parent */
#define START numbers[8] /* a chord of the parent */
#define ROW_LENGTH numbers[9]
#define CHILD_S numbers[10]
#define PART_S numbers[11]
#define STEP_S numbers[12]
#define SHARED_S numbers[13]
#define PART_E numbers[14]
#define STEP_E numbers[15]
#define SHARED_E numbers[16]
#define ALONG_S (numbers[17] + a * numbers[18])
#define ACROSS_S (numbers[19] + a * numbers[20])
#define ALONG_E (numbers[21] + b * numbers[22])
#define ACROSS_E (numbers[23] + b * numbers[24])

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
    if (b >= COLUMNS)
        return;
    int to = (START + a * ROW_LENGTH + b) * PARENT_WORDS;
#ifdef CROSSING
    /* Merge::crossing: the ends on child 0 have negative distances. */
    int product = ALONG_S * ACROSS_E - ALONG_E * ACROSS_S, distance = 2 * (ACROSS_E - ACROSS_S);
    int m = CHILD_S == 0 ? quotient(product, distance) : quotient(-product, -distance);
    uint partS = uint(PART_S + a * STEP_S + m * SHARED_S);
    uint partE = uint(PART_E + b * STEP_E + m * SHARED_E);
    for (int word = lane; word < PARENT_WORDS; word += lanes)
        parent[to + word] =
            votesOf(partS, CHILD_S, uint(word)) + votesOf(partE, 1 - CHILD_S, uint(word));
#else
    uint own = uint(PART_S + a * STEP_S + b * STEP_E);
    for (int word = lane; word < PARENT_WORDS; word += lanes)
        parent[to + word] = votesOf(own, CHILD_S, uint(word));
#endif
}
