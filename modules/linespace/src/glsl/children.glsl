// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// What the shaders of merges share: the votes of a chord of a child, from the windows, which show the
// table of the children, and where chords cross the side that two children share. The votes of as
// many cells as share a word are added at once. Compiled before a shader that has CHILD_BITS.
//
// CHILD_BITS, PARENT_BITS: of a vote, 8, 16 or 32.

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

/* Merge::crossing of the ends a and b of a rectangle of chords (merge_rectangles.hpp), each given as
along, its step, across, its step; the end on child 0 has the negative distance. */
int crossingOf(ivec4 atS, ivec4 atE, int a, int b, bool isFirstOnChild0)
{
    int alongS = atS.x + a * atS.y, acrossS = atS.z + a * atS.w;
    int alongE = atE.x + b * atE.y, acrossE = atE.z + b * atE.w;
    int product = alongS * acrossE - alongE * acrossS, distance = 2 * (acrossE - acrossS);
    return isFirstOnChild0 ? quotient(product, distance) : quotient(-product, -distance);
}
