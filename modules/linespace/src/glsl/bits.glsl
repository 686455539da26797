// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Packs the pixels of a map, whatever their weights, into bits as EdgeBits has them. An item writes
// a word.

layout(std430, binding = 0) writeonly buffer Bits { uint bits[]; };

#define FIRST_WORD numbers[6]
#define WORDS numbers[7] /* from there on */

void main()
{
    int item = int(itemIndex());
    if (item >= WORDS)
        return;
    int at = FIRST_WORD + item, upright = WIDTH * UPRIGHT_WORDS;
    bool xMajor = at < upright;
    at -= xMajor ? 0 : upright;
    int words = xMajor ? UPRIGHT_WORDS : TRANSPOSED_WORDS;
    int column = quotient(at, words), across = (at - column * words - MARGIN) * 32;
    uint word = 0u;
    if (across >= 0 && column < (xMajor ? COLUMNS : ROWS))
    {
        int count = min(32, (xMajor ? ROWS : COLUMNS) - across);
        int pixel = xMajor ? across * COLUMNS + column : column * COLUMNS + across;
        int step = xMajor ? COLUMNS : 1;
        for (int bit = 0; bit < count; ++bit, pixel += step)
            word |= uint(votesAt(pixel) != 0u) << bit;
    }
    bits[item] = word;
}
