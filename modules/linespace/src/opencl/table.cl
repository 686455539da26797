// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// A level's table for users (LineSpaceDetector::computeLevel): for each cell of the grid both
// triangles of [p][q], in the order of the grid.
//
// VOTES: the type of votes.

/* The cell of row r and column c of the grid has the index rowBits[r] + columnBits[c]. Global size:
columns, rows of the output. */
__kernel void writeTable(__global const VOTES* table, int width, int height, int cells,
                         __global const int* rowBits, __global const int* columnBits,
                         __global uchar* out, int step, int offset, int rows, int columns)
{
    const int x = get_global_id(0), y = get_global_id(1);
    if (x >= columns || y >= rows)
        return;
    const Frame cell = {width, height};
    const int points = 2 * (width + height), row = y / points, column = x / points;
    const int p = y - row * points, q = x - column * points;
    const int s = min(p, q), e = max(p, q), firstPartner = sideOf(cell, s).y;
    const size_t chord = rowStart(cell, s) + e - firstPartner;
    *(__global int*)(out + offset + (size_t)y * step + x * sizeof(int)) =
        e < firstPartner ? 0 : (int)table[chord * cells + rowBits[row] + columnBits[column]];
}
