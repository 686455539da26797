// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// merge.glsl for chords that cross, with the memory of the work group: a tile of 8 x 8 chords of a
// rectangle first brings its parts there. The crossings of a row are a run of the shared side, and
// those of a column; of a run SIDE parts are brought, all but where it is next to an end of the
// shared side. A part beyond is read from the table. Groups: tiles of columns, of rows, rectangles.
//
// CHUNK_LOG: of the words of each chord that are brought at once.

layout(std430, binding = BLOCK_A) writeonly buffer Parent { uint parent[]; };

layout(location = NUMBERS) uniform ivec4 rectangles[5 * RECTANGLES];

#define SIDE_LOG 3
#define SIDE (1 << SIDE_LOG)
#define CHUNK (1 << CHUNK_LOG)
#define ROOM (SIDE * SIDE * CHUNK)

shared int crossings[SIDE * SIDE];
shared uint partsS[ROOM], partsE[ROOM];

int crossingAt(int row, int column)
{
    return crossings[row * SIDE + column];
}

/* The first crossing of a row, or of a column, and the last: they go one way along both. */
ivec2 runOfRow(int row)
{
    int a = crossingAt(row, 0), b = crossingAt(row, SIDE - 1);
    return ivec2(min(a, b), max(a, b));
}
ivec2 runOfColumn(int column)
{
    int a = crossingAt(0, column), b = crossingAt(SIDE - 1, column);
    return ivec2(min(a, b), max(a, b));
}

void main()
{
    int item = int(gl_LocalInvocationIndex), first = 5 * int(gl_WorkGroupID.z);
    int row = item >> SIDE_LOG, column = item & (SIDE - 1);
    int a0 = (numbers[1] + int(gl_WorkGroupID.y)) * SIDE;
    int b0 = (numbers[0] / GROUP + int(gl_WorkGroupID.x)) * SIDE;
    ivec4 shape = rectangles[first];
    ivec4 s = rectangles[first + 1], e = rectangles[first + 2];
    /* Of a tile that is cut off, the last chords again. */
    int a = min(a0 + row, shape.y - 1), b = min(b0 + column, shape.x - 1);
    crossings[item] = crossingOf(rectangles[first + 3], rectangles[first + 4], a, b, s.x == 0);
    for (int word0 = 0; word0 < PARENT_WORDS; word0 += CHUNK)
    {
        memoryBarrierShared();
        barrier();
        for (int i = item; i < ROOM; i += GROUP)
        {
            int word = word0 + (i & (CHUNK - 1)), offset = i >> CHUNK_LOG & (SIDE - 1);
            int line = i >> (CHUNK_LOG + SIDE_LOG);
            ivec2 ofRow = runOfRow(line), ofColumn = runOfColumn(line);
            int partS = s.y + min(a0 + line, shape.y - 1) * s.z + (ofRow.x + offset) * s.w;
            int partE = e.y + min(b0 + line, shape.x - 1) * e.z + (ofColumn.x + offset) * e.w;
            if (ofRow.x + offset <= ofRow.y)
                partsS[i] = votesOf(uint(partS), s.x, uint(word));
            if (ofColumn.x + offset <= ofColumn.y)
                partsE[i] = votesOf(uint(partE), 1 - s.x, uint(word));
        }
        memoryBarrierShared();
        barrier();
        for (int i = item; i < ROOM; i += GROUP)
        {
            int chunkWord = i & (CHUNK - 1), word = word0 + chunkWord;
            int k = i >> CHUNK_LOG & (SIDE - 1), j = i >> (CHUNK_LOG + SIDE_LOG);
            if (a0 + j >= shape.y || b0 + k >= shape.x)
                continue;
            int m = crossingAt(j, k), inRow = m - runOfRow(j).x, inColumn = m - runOfColumn(k).x;
            uint votes;
            if (inRow < SIDE)
                votes = partsS[((j << SIDE_LOG) + inRow << CHUNK_LOG) + chunkWord];
            else
                votes = votesOf(uint(s.y + (a0 + j) * s.z + m * s.w), s.x, uint(word));
            if (inColumn < SIDE)
                votes += partsE[((k << SIDE_LOG) + inColumn << CHUNK_LOG) + chunkWord];
            else
                votes += votesOf(uint(e.y + (b0 + k) * e.z + m * e.w), 1 - s.x, uint(word));
            parent[(shape.z + (a0 + j) * shape.w + b0 + k) * PARENT_WORDS + word] = votes;
        }
    }
}
