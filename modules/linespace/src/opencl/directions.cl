// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The directions that edge pixels vote for, by the gradients of the image (doc/algorithm.md,
// section 6), as orientation.cpp finds them: in integers, also where the gradients are of floating
// point, so that no device rounds otherwise. Each work item writes what is its own. Gradients that
// are not given are estimated from the map; the root in these is an integer's.
//
// FLOATS: gradients are float, else short. BINS: of directions. CENTRE_COSINES: of their centres.

__constant int CENTRE_COSINE[] = {CENTRE_COSINES};

#ifdef FLOATS

#define COMPONENT uint /* the bits of a float */

inline int isFinite(uint value)
{
    return (value & 0x7F800000u) != 0x7F800000u;
}

/* A finite float without its sign is mantissaOf() times 2 to the power of exponentOf() - 150. */
inline int exponentOf(uint value)
{
    return max((int)(value >> 23 & 255), 1);
}
inline int mantissaOf(uint value)
{
    return (int)((value & 0x7FFFFFu) | ((value & 0x7F800000u) != 0 ? 0x800000u : 0u));
}

/* A float divided by 2 to the power of `exponent` - 150, to the nearest integer, of two the even
one; less than 2^15 but for rounding, and 32767 at most. */
inline int scaled(uint value, int exponent)
{
    const int mantissa = mantissaOf(value), shift = exponent - exponentOf(value);
    int result = 0; /* of more places than a mantissa and its half have */
    if (shift <= 0)
        result = mantissa << -shift;
    else if (shift < 25)
    {
        const int rest = mantissa & ((1 << shift) - 1), half_ = 1 << (shift - 1);
        result = mantissa >> shift;
        result += rest > half_ || (rest == half_ && (result & 1));
    }
    return value >> 31 ? -result : min(result, 32767);
}

inline int2 quantised(uint x, uint y)
{
    const uint larger = max(x & 0x7FFFFFFFu, y & 0x7FFFFFFFu);
    if (larger == 0)
        return (int2)(0, 0);
    /* The larger one becomes 15 bits long. */
    const int length = 32 - (int)clz(mantissaOf(larger));
    const int exponent = exponentOf(larger) + length - 15;
    return (int2)(scaled(x, exponent), scaled(y, exponent));
}

#else

#define COMPONENT short

inline int2 quantised(short x, short y)
{
    return (int2)(x, y);
}

#endif

/* As DirectionRule::bitsOf. */
inline ushort bitsOf(int2 gradient, long sineSquared)
{
    const long x = gradient.x, y = gradient.y, limit = sineSquared * (x * x + y * y);
    ushort bits = 0;
    for (int bin = 0; bin < BINS; ++bin)
    {
        const int sine = CENTRE_COSINE[bin < BINS / 2 ? BINS / 2 - 1 - bin : bin - BINS / 2];
        const long product = x * CENTRE_COSINE[bin] + y * sine;
        bits |= (ushort)(product * product <= limit) << bin;
    }
    return bits;
}

/* Bits of every pixel, 0 where it does not vote; *wrong becomes 1 if a gradient anywhere is not
finite. Global size: columns, rows. */
__kernel void findDirections(__global const uchar* image, int step, int offset, int rows,
                             int columns MASK_PARAMETERS, __global const uchar* dx, int dxStep,
                             int dxOffset, __global const uchar* dy, int dyStep, int dyOffset,
                             long sineSquared, __global ushort* bits, __global int* wrong)
{
    const int x = get_global_id(0), y = get_global_id(1);
    if (x >= columns || y >= rows)
        return;
    const COMPONENT gx = *(__global const COMPONENT*)(dx + dxOffset + (size_t)y * dxStep +
                                                      x * sizeof(COMPONENT));
    const COMPONENT gy = *(__global const COMPONENT*)(dy + dyOffset + (size_t)y * dyStep +
                                                      x * sizeof(COMPONENT));
#ifdef FLOATS
    if (!isFinite(gx) || !isFinite(gy))
    {
        atomic_or(wrong, 1);
        return;
    }
#endif
    bits[(size_t)y * columns + x] = votesAt(image, step, offset MASK_ARGUMENTS, x, y)
                                        ? bitsOf(quantised(gx, gy), sineSquared)
                                        : (ushort)0;
}

#ifdef FLOATS

/* The 3 x 3 Sobel derivatives of the map, 1 where a pixel votes, for the image with a margin of one
pixel, beyond which they are 0. Global size: columns + 2, rows + 2. */
__kernel void findSlopes(__global const uchar* image, int step, int offset, int rows,
                         int columns MASK_PARAMETERS, __global char2* slopes)
{
    const int column = get_global_id(0), row = get_global_id(1);
    if (column >= columns + 2 || row >= rows + 2)
        return;
    int2 slope = 0;
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i)
        {
            const int x = column - 1 + i, y = row - 1 + j;
            if (x >= 0 && x < columns && y >= 0 && y < rows &&
                votesAt(image, step, offset MASK_ARGUMENTS, x, y))
                slope += (int2)(i * (2 - abs(j)), j * (2 - abs(i)));
        }
    slopes[(size_t)row * (columns + 2) + column] = convert_char2(slope);
}

/* sqrt(square) + addend, both less than 2^22, in single precision, to the nearest: the root is
taken to 31 bits, and the last bit of all tells whether there are more. For all sums that slopes make
this is what double precision, then rounded to single, gives. */
inline float rootPlus(int square, int addend)
{
    if (square == 0)
        return (float)addend;
    const int places = ((int)clz((ulong)square) - 2) / 2;
    const ulong radicand = (ulong)square << 2 * places;
    ulong root = 0;
    for (ulong bit = 1ul << 31; bit > 0; bit >>= 1)
        root += (root + bit) * (root + bit) <= radicand ? bit : 0ul;
    const ulong sum = 2 * (root + ((ulong)addend << places)) + (root * root != radicand);
    return ldexp(convert_float_rte(sum), -places - 1);
}

/* The bits of every pixel by the gradients that estimateGradients finds. Global size: columns,
rows. */
__kernel void estimateDirections(__global const uchar* image, int step, int offset, int rows,
                                 int columns MASK_PARAMETERS, __global const char2* slopes,
                                 long sineSquared, __global ushort* bits)
{
    enum
    {
        REACH = 3
    };
    const int x = get_global_id(0), y = get_global_id(1);
    if (x >= columns || y >= rows)
        return;
    ushort result = 0;
    if (votesAt(image, step, offset MASK_ARGUMENTS, x, y))
    {
        int difference = 0, product = 0;
        for (int v = max(y - REACH, -1); v <= min(y + REACH, rows); ++v)
            for (int u = max(x - REACH, -1); u <= min(x + REACH, columns); ++u)
            {
                const int2 slope = convert_int2(slopes[(size_t)(v + 1) * (columns + 2) + u + 1]);
                difference += slope.x * slope.x - slope.y * slope.y;
                product += 2 * slope.x * slope.y;
            }
        const uint along = as_uint((float)product);
        const uint across = as_uint(rootPlus(difference * difference + product * product,
                                             (int)abs(difference)));
        result = bitsOf(difference >= 0 ? quantised(across, along) : quantised(along, across),
                        sineSquared);
    }
    bits[(size_t)y * columns + x] = result;
}

#endif // FLOATS

/* What the host reads, side by side without gaps, from a place in a buffer on. Global size: columns,
rows, as of the next two. */
__kernel void copyVotes(__global const uchar* image, int step, int offset, int rows,
                        int columns MASK_PARAMETERS, __global uchar* pixels, int start)
{
    const int x = get_global_id(0), y = get_global_id(1);
    if (x < columns && y < rows)
        pixels[start + (size_t)y * columns + x] = votesAt(image, step, offset MASK_ARGUMENTS, x, y);
}

#define COPY(name, ELEMENT)                                                                        \
    __kernel void name(__global const uchar* image, int step, int offset, int rows, int columns,   \
                       __global uchar* pixels, int start)                                          \
    {                                                                                              \
        const int x = get_global_id(0), y = get_global_id(1);                                      \
        if (x < columns && y < rows)                                                               \
            ((__global ELEMENT*)(pixels + start))[(size_t)y * columns + x] =                       \
                ((__global const ELEMENT*)(image + offset + y * step))[x];                         \
    }
COPY(copyDirections, ushort)
#ifdef FLOATS
COPY(copyGradients, uint)
#else
COPY(copyGradients, ushort)
#endif
