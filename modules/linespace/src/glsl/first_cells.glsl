// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Level 0 of the cascade: the votes of every chord of every cell by its raster. The votes of as
// many cells as share a word are added at once: none overflows its bits, as the host has chosen
// them by the bound of the level. LANES invocations share a chord, whose raster they follow
// together, and take its words in turns.
//
// PARENT_BITS: of a vote, 8 or 16. ORIENTED: only pixels that vote for the bin of the chord count.

layout(std430, binding = 0) readonly buffer Planes { uint planes[]; };
layout(std430, binding = 1) writeonly buffer Table { uint table[]; };
#ifdef ORIENTED
layout(std430, binding = 2) readonly buffer Directions { uint directions[]; };
#endif

#define FIRST_CHORD numbers[0]
#define CHORDS numbers[1] /* from there on */
#define CELL_WIDTH numbers[2]
#define CELL_HEIGHT numbers[3]
#define LANES_LOG numbers[4]
#define WORDS uint(numbers[5])           /* of the table, of a chord */
#define PLANE_WORDS uint(numbers[6])     /* of a pixel */
#define DIRECTION_WORDS uint(numbers[7]) /* of a pixel */

#ifdef ORIENTED
/* All bits of the bytes of two cells whose pixels vote for the bin. */
uint votingBytes(uint directionsOfTwo, int bin)
{
    uint on = directionsOfTwo >> bin & 0x00010001u;
    return ((on | on >> 8) & 0x0101u) * 255u;
}
#endif

/* What a pixel adds to a word of the table. */
uint votesOf(uint pixel, uint word, int bin)
{
#if PARENT_BITS == 8
    uint votes = planes[pixel * PLANE_WORDS + word];
#ifdef ORIENTED
    uint at = pixel * DIRECTION_WORDS + 2u * word;
    uint voting = votingBytes(directions[at], bin);
    if (DIRECTION_WORDS > 1u)
        voting |= votingBytes(directions[at + 1u], bin) << 16;
    votes &= voting;
#endif
    return votes;
#else
    uint pair = planes[pixel * PLANE_WORDS + (word >> 1)] >> ((word & 1u) * 16u);
    uint votes = (pair & 0xFFu) | (pair & 0xFF00u) << 8;
#ifdef ORIENTED
    votes &= (directions[pixel * DIRECTION_WORDS + word] >> bin & 0x00010001u) * 0xFFFFu;
#endif
    return votes;
#endif
}

void main()
{
    uint item = itemIndex(), lanes = 1u << LANES_LOG, lane = item & (lanes - 1u);
    int chord = int(item >> LANES_LOG);
    if (chord >= CHORDS)
        return;
    Frame cell = Frame(CELL_WIDTH, CELL_HEIGHT);
    ivec2 ends = chordAt(cell, FIRST_CHORD + chord);
    ivec2 p = borderPoint(cell, ends.x), q = borderPoint(cell, ends.y);
#ifdef ORIENTED
    int bin = directionBin(q - p);
#else
    const int bin = 0;
#endif
    Raster start = rasterOf(p, q);
    uint to = uint(chord) * WORDS;
    for (uint word = lane; word < WORDS; word += 4u * lanes)
    {
        /* Four words at once, where there are as many: the raster costs as much as they do. */
        bool isFull = word + 3u * lanes < WORDS;
        uvec4 sum = uvec4(0u);
        Raster raster = start;
        for (int i = 0; i < start.count; ++i, advance(raster))
        {
            int x = raster.xMajor ? raster.first + i : raster.minor;
            int y = raster.xMajor ? raster.minor : raster.first + i;
            if (x >= CELL_WIDTH || y >= CELL_HEIGHT) /* the neighbour's */
                continue;
            uint pixel = uint(y * CELL_WIDTH + x);
            sum.x += votesOf(pixel, word, bin);
            if (isFull)
                sum.yzw += uvec3(votesOf(pixel, word + lanes, bin),
                                 votesOf(pixel, word + 2u * lanes, bin),
                                 votesOf(pixel, word + 3u * lanes, bin));
        }
        table[to + word] = sum.x;
        if (isFull)
        {
            table[to + word + lanes] = sum.y;
            table[to + word + 2u * lanes] = sum.z;
            table[to + word + 3u * lanes] = sum.w;
        }
        else
            word -= 3u * lanes; /* one at a time */
    }
}
