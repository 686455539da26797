// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// One level of the cascade from the one below. What a chord of the parent is made of is computed where
// it is needed, as struct Merge does: a table of that would be larger than the votes. The votes of as
// many cells as share a word are added at once. LANES invocations share a chord and take its words in
// turns.
//
// CHILD_BITS, PARENT_BITS: of a vote, 8, 16 or 32. The windows show the child's table.

layout(std430, binding = BLOCK_A) writeonly buffer Parent { uint parent[]; };

#define FIRST_CHORD numbers[0]
#define CHORDS numbers[1] /* from there on */
#define CHILD_WIDTH numbers[2]
#define CHILD_HEIGHT numbers[3]
#define HORIZONTAL (numbers[4] != 0)
#define LANES_LOG numbers[5]
#define CELLS_LOG numbers[6] /* of the parent */
#define PARENT_WORDS uint(numbers[7])
#define CHILD_WORDS uint(numbers[8])
#define MASK uint(numbers[9]) /* of the child's votes that come to a word of the parent */

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

/* Merge::childOf and childPoint. */
ivec2 childOf(Frame cell, int p)
{
    int w = cell.width, h = cell.height;
    if (HORIZONTAL)
    {
        if (p < 2 * w)
            return p < w ? ivec2(0, p) : ivec2(1, p - w);
        if (p < 2 * w + h)
            return ivec2(1, p - w);
        if (p < 4 * w + h)
            return p < 3 * w + h ? ivec2(1, p - w) : ivec2(0, p - 2 * w);
        return ivec2(0, p - 2 * w);
    }
    if (p < w)
        return ivec2(0, p);
    if (p < w + 2 * h)
        return p < w + h ? ivec2(0, p) : ivec2(1, p - h);
    if (p < 2 * w + 2 * h)
        return ivec2(1, p - h);
    return p < 2 * w + 3 * h ? ivec2(1, p - h) : ivec2(0, p - 2 * h);
}

/* Merge::sharedPoint. */
int sharedPoint(Frame cell, int child, int m)
{
    int w = cell.width, h = cell.height;
    if (HORIZONTAL)
        return child == 0 ? w + m : 2 * w + 2 * h - 1 - m;
    return child == 0 ? 2 * w + h - 1 - m : m;
}

/* Merge::crossing. */
int crossing(Frame cell, ivec2 p, ivec2 q)
{
    ivec2 a = HORIZONTAL ? p.yx : p, b = HORIZONTAL ? q.yx : q; /* along, across */
    int across = 2 * (HORIZONTAL ? cell.width : cell.height);
    a.y -= across;
    b.y -= across;
    if (a.y > b.y)
    {
        ivec2 other = a;
        a = b;
        b = other;
    }
    return quotient(a.x * b.y - b.x * a.y, 2 * (b.y - a.y));
}

void main()
{
    uint item = itemIndex(), lanes = 1u << LANES_LOG, lane = item & (lanes - 1u);
    int i = int(item >> LANES_LOG);
    if (i >= CHORDS)
        return;
    Frame child = Frame(CHILD_WIDTH, CHILD_HEIGHT);
    Frame whole = HORIZONTAL ? Frame(2 * CHILD_WIDTH, CHILD_HEIGHT)
                             : Frame(CHILD_WIDTH, 2 * CHILD_HEIGHT);
    ivec2 chord = chordAt(whole, FIRST_CHORD + i);
    ivec2 s = childOf(child, chord.x), e = childOf(child, chord.y);
    uint to = uint(i) * PARENT_WORDS;
    if (s.x == e.x)
    {
        uint own = uint(chordIndex(child, s.y, e.y));
        for (uint word = lane; word < PARENT_WORDS; word += lanes)
            parent[to + word] = votesOf(own, s.x, word);
        return;
    }
    int m = crossing(child, borderPoint(whole, chord.x), borderPoint(whole, chord.y));
    uint partS = uint(chordIndex(child, s.y, sharedPoint(child, s.x, m)));
    uint partE = uint(chordIndex(child, e.y, sharedPoint(child, e.x, m)));
    for (uint word = lane; word < PARENT_WORDS; word += lanes)
        parent[to + word] = votesOf(partS, s.x, word) + votesOf(partE, e.x, word);
}
