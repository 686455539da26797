// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Chords and their pixels, as in plan.hpp: what the programs of this directory share. Each is
// compiled after this text.

#define CONCAT_(a, b) a##b
#define CONCAT(a, b) CONCAT_(a, b)

/* The floor of a quotient >= 0, exactly: the estimate is wrong by one at most. */
inline int quotient(int numerator, int denominator)
{
    int result = (int)((float)numerator / (float)denominator);
    const int rest = numerator - result * denominator;
    return result + (rest >= denominator) - (rest < 0);
}

/* Where border point p of a frame is, in doubled coordinates (Cell::borderPoint). */
inline int2 borderPoint(int width, int height, int p)
{
    if (p < width)
        return (int2)(2 * p + 1, 0);
    p -= width;
    if (p < height)
        return (int2)(2 * width, 2 * p + 1);
    p -= height;
    if (p < width)
        return (int2)(2 * (width - p) - 1, 2 * height);
    p -= width;
    return (int2)(0, 2 * (height - p) - 1);
}

/* The pixels of a chord from p to q, as struct Raster, but for one: a pixel at an end on the right or
bottom border is among them, though it is beyond the frame. */
typedef struct
{
    int xMajor, first, count, minor, rest, step, modulus;
} Raster;

inline Raster rasterOf(int2 p, int2 q)
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
        const int2 other = p;
        p = q;
        q = other;
    }
    const int dx = q.x - p.x, dy = q.y - p.y;
    raster.first = p.x / 2;
    raster.count = (q.x - 1) / 2 - raster.first + 1;
    raster.modulus = 2 * dx;
    raster.step = 2 * dy;
    const int numerator = p.y * dx + dy * (2 * raster.first + 1 - p.x);
    raster.minor = quotient(numerator, raster.modulus);
    raster.rest = numerator - raster.minor * raster.modulus;
    return raster;
}

/* The table of a cell, as struct Cell. */
typedef struct
{
    int width, height;
} Frame;

/* The first point of the side of p, and of the next side. */
inline int2 sideOf(Frame frame, int p)
{
    const int right = frame.width, bottom = right + frame.height, left = bottom + frame.width;
    return p < right    ? (int2)(0, right)
           : p < bottom ? (int2)(right, bottom)
           : p < left   ? (int2)(bottom, left)
                        : (int2)(left, left + frame.height);
}

/* The first chord of a row that is not on the left side. */
inline int rowStart(Frame frame, int s)
{
    const int w = frame.width, h = frame.height;
    if (s < w)
        return s * (w + 2 * h);
    if (s < w + h)
        return w * (w + 2 * h) + (s - w) * (w + h);
    return w * (w + 2 * h) + h * (w + h) + (s - w - h) * h;
}

/* The ends of chord i of the table. */
inline int2 chordAt(Frame frame, int i)
{
    const int w = frame.width, h = frame.height;
    const int right = w * (w + 2 * h), bottom = right + h * (w + h);
    const int start = i < right ? 0 : i < bottom ? right : bottom;
    const int first = i < right ? 0 : i < bottom ? w : w + h;
    const int length = i < right ? w + 2 * h : i < bottom ? w + h : h;
    const int row = (i - start) / length;
    return (int2)(first + row, sideOf(frame, first).y + i - start - row * length);
}
