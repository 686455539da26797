// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The pixels of the edge map and the exact votes of a chord, for the shaders that read them, which
// are compiled after this text and have these numbers first.
//
// MAP_BLOCK: the binding of the map, if the shader reads it. DIRECTIONS_BLOCK: that of its
// directions.
// BITS: the map has no weights and no directions, and its pixels are bits (edge_bits.hpp); else
// they are bytes. MARGIN: EdgeBits::MARGIN. ORIENTED: only pixels that vote for the bin of the
// chord count.

#define WIDTH numbers[0] /* of the frame */
#define HEIGHT numbers[1]
#define COLUMNS numbers[2] /* of the image */
#define ROWS numbers[3]
#define UPRIGHT_WORDS numbers[4] /* EdgeBits::wordsOf a column along x */
#define TRANSPOSED_WORDS numbers[5] /* and along y */

#ifdef MAP_BLOCK
#ifdef BITS

layout(std430, binding = MAP_BLOCK) readonly buffer Bits { uint bits[]; };

uint votesOfChord(Frame frame, ivec2 chord)
{
    Raster raster = rasterOf(borderPoint(frame, chord.x), borderPoint(frame, chord.y));
    int words = raster.xMajor ? UPRIGHT_WORDS : TRANSPOSED_WORDS;
    int column = (raster.xMajor ? 0 : WIDTH * UPRIGHT_WORDS) + raster.first * words + MARGIN;
    uint sum = 0u;
    for (int k = 0; k < raster.count; ++k, column += words, advance(raster))
        sum += bits[column + (raster.minor >> 5)] >> (raster.minor & 31) & 1u;
    return sum;
}

#else

layout(std430, binding = MAP_BLOCK) readonly buffer Image { uint image[]; };

/* Of pixel y COLUMNS + x of the image. */
uint votesAt(int pixel)
{
    return image[pixel >> 2] >> ((pixel & 3) * 8) & 0xFFu;
}

#ifdef ORIENTED
layout(std430, binding = DIRECTIONS_BLOCK) readonly buffer Directions { uint directions[]; };
#endif

uint votesOfChord(Frame frame, ivec2 chord)
{
    ivec2 p = borderPoint(frame, chord.x), q = borderPoint(frame, chord.y);
#ifdef ORIENTED
    int bin = directionBin(q - p);
#endif
    Raster raster = rasterOf(p, q);
    uint sum = 0u;
    for (int k = 0; k < raster.count; ++k, advance(raster))
    {
        int x = raster.xMajor ? raster.first + k : raster.minor;
        int y = raster.xMajor ? raster.minor : raster.first + k;
        if (x >= COLUMNS || y >= ROWS)
            continue;
        int at = y * COLUMNS + x;
        uint votes = votesAt(at);
#ifdef ORIENTED
        votes *= directions[at >> 1] >> ((at & 1) * 16 + bin) & 1u;
#endif
        sum += votes;
    }
    return sum;
}

#endif
#endif
