// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Pixels of the cells of level 0, side by side: that of pixel y cellWidth + x of a cell stands at
// [pixel][cell], 0 beyond the image. An item writes a word: four votes of a byte, or with
// DIRECTIONS the direction bits of two pixels.

layout(std430, binding = 0) readonly buffer Image { uint image[]; };
layout(std430, binding = 1) readonly buffer Corners { ivec2 corners[]; }; // of cells
layout(std430, binding = 2) writeonly buffer Planes { uint planes[]; };

#define COLUMNS numbers[0]
#define ROWS numbers[1]
#define CELL_WIDTH numbers[2]
#define PIXELS numbers[3]
#define CELLS numbers[4]
#define WORDS_LOG numbers[5] /* of the words of a pixel */

#ifdef DIRECTIONS
#define LANES 2
#define BITS 16
#else
#define LANES 4
#define BITS 8
#endif

void main()
{
    int item = int(itemIndex()), pixel = item >> WORDS_LOG, word = item - (pixel << WORDS_LOG);
    if (pixel >= PIXELS)
        return;
    int row = quotient(pixel, CELL_WIDTH), column = pixel - row * CELL_WIDTH;
    uint together = 0u;
    for (int lane = 0; lane < LANES; ++lane)
    {
        int cell = word * LANES + lane;
        if (cell >= CELLS)
            break;
        int x = corners[cell].x + column, y = corners[cell].y + row;
        if (x >= COLUMNS || y >= ROWS)
            continue;
        int at = y * COLUMNS + x;
        uint value = image[at / LANES] >> (at % LANES * BITS) & ((1u << BITS) - 1u);
        together |= value << (lane * BITS);
    }
    planes[item] = together;
}
