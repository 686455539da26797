// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The votes of chords of the frame by their rasters: of all of them (METHOD_EXACT), an item each,
// or with LIST of those of a list.
//
// ORIENTED: only pixels that vote for the bin of the chord count.

layout(std430, binding = 0) readonly buffer Image { uint image[]; };
layout(std430, binding = 1) writeonly buffer Votes { uint votes[]; };
#ifdef LIST
layout(std430, binding = 2) readonly buffer Chords { ivec2 chords[]; };
#endif
#ifdef ORIENTED
layout(std430, binding = 3) readonly buffer Directions { uint directions[]; };
#endif

#define FIRST_CHORD numbers[0]
#define CHORDS numbers[1] /* from there on */
#define WIDTH numbers[2]
#define HEIGHT numbers[3]
#define COLUMNS numbers[4] /* of the image */
#define ROWS numbers[5]

void main()
{
    int i = int(itemIndex());
    if (i >= CHORDS)
        return;
    Frame frame = Frame(WIDTH, HEIGHT);
#ifdef LIST
    ivec2 chord = chords[i];
#else
    ivec2 chord = chordAt(frame, FIRST_CHORD + i);
#endif
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
        uint value = image[at >> 2] >> ((at & 3) * 8) & 0xFFu;
#ifdef ORIENTED
        value *= directions[at >> 1] >> ((at & 1) * 16 + bin) & 1u;
#endif
        sum += value;
    }
    votes[i] = sum;
}
