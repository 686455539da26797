// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Chords and their pixels, as in plan.hpp: what the shaders of this directory share. Each is
// compiled after this text, as GLSL 4.30 or GLSL ES 3.10, which has no integers of 64 bits:
// products of coordinates are below 2^31, which the host sees to. Votes are in storage blocks of
// 32-bit words, as blocks of smaller numbers are an extension: of 8 or 16 bits each, several cells
// share a word.
//
// GROUP: invocations of a work group. NUMBERS: numbers of a launch.

layout(local_size_x = GROUP) in;
layout(location = 0) uniform int numbers[NUMBERS];

/* Groups are numbered along two dimensions, as there may be more than one can have. */
uint groupIndex()
{
    return gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
}
uint itemIndex()
{
    return groupIndex() * uint(GROUP) + gl_LocalInvocationIndex;
}

/* The floor of a quotient >= 0, exactly. Division of floating-point numbers may be wrong by 2.5
units of the last place, and the operands are rounded, so the estimate of a quotient below 2^20 is
wrong by one at most. */
int quotient(int numerator, int denominator)
{
    int result = int(float(numerator) / float(denominator));
    int rest = numerator - result * denominator;
    return result + int(rest >= denominator) - int(rest < 0);
}

/* A cell, as struct Cell. */
struct Frame
{
    int width, height;
};

/* Where border point p is, in doubled coordinates (Cell::borderPoint). */
ivec2 borderPoint(Frame cell, int p)
{
    if (p < cell.width)
        return ivec2(2 * p + 1, 0);
    p -= cell.width;
    if (p < cell.height)
        return ivec2(2 * cell.width, 2 * p + 1);
    p -= cell.height;
    if (p < cell.width)
        return ivec2(2 * (cell.width - p) - 1, 2 * cell.height);
    p -= cell.width;
    return ivec2(0, 2 * (cell.height - p) - 1);
}

/* The first point of the side after that of p, which is p's first partner. */
int firstPartner(Frame cell, int p)
{
    int right = cell.width, bottom = right + cell.height, left = bottom + cell.width;
    return p < right ? right : p < bottom ? bottom : p < left ? left : left + cell.height;
}

/* The first chord of a row that is not on the left side. */
int rowStart(Frame cell, int s)
{
    int w = cell.width, h = cell.height;
    if (s < w)
        return s * (w + 2 * h);
    if (s < w + h)
        return w * (w + 2 * h) + (s - w) * (w + h);
    return w * (w + 2 * h) + h * (w + h) + (s - w - h) * h;
}

/* The number of the chord of two points on different sides. */
int chordIndex(Frame cell, int p, int q)
{
    int s = min(p, q);
    return rowStart(cell, s) + max(p, q) - firstPartner(cell, s);
}

/* The ends of chord i. */
ivec2 chordAt(Frame cell, int i)
{
    int w = cell.width, h = cell.height;
    int right = w * (w + 2 * h), bottom = right + h * (w + h);
    int start = i < right ? 0 : i < bottom ? right : bottom;
    int first = i < right ? 0 : i < bottom ? w : w + h;
    int length = i < right ? w + 2 * h : i < bottom ? w + h : h;
    int row = quotient(i - start, length);
    return ivec2(first + row, firstPartner(cell, first) + i - start - row * length);
}

/* The pixels of a chord from p to q, as struct Raster, but for one: a pixel at an end on the right
or bottom border is among them, though it is beyond the cell. */
struct Raster
{
    bool xMajor;
    int first, count, minor, rest, step, modulus;
};

Raster rasterOf(ivec2 p, ivec2 q)
{
    Raster raster;
    raster.xMajor = abs(q.x - p.x) >= abs(q.y - p.y);
    if (!raster.xMajor)
    {
        p = p.yx;
        q = q.yx;
    }
    if (q.x < p.x)
    {
        ivec2 other = p;
        p = q;
        q = other;
    }
    int dx = q.x - p.x, dy = q.y - p.y;
    raster.first = p.x / 2;
    raster.count = (q.x - 1) / 2 - raster.first + 1;
    raster.modulus = 2 * dx;
    raster.step = 2 * dy;
    int numerator = p.y * dx + dy * (2 * raster.first + 1 - p.x);
    raster.minor = quotient(numerator, raster.modulus);
    raster.rest = numerator - raster.minor * raster.modulus;
    return raster;
}

/* To the next pixel. */
void advance(inout Raster raster)
{
    raster.rest += raster.step;
    int over = int(raster.rest >= raster.modulus), under = int(raster.rest < 0);
    raster.rest += (under - over) * raster.modulus;
    raster.minor += over - under;
}

#ifdef END_COSINES
/* The bin of a direction, as directionBin in orientation.cpp; each number is less than 2^16. */
int directionBin(ivec2 direction)
{
    const int endCosine[16] = int[16](END_COSINES);
    if (direction.y < 0 || (direction.y == 0 && direction.x < 0))
        direction = -direction;
    int bin = 0;
    for (int span = 8; span > 0; span /= 2)
        if (endCosine[bin + span] * direction.y >= endCosine[abs(8 - bin - span)] * direction.x)
            bin += span;
    return bin;
}
#endif
