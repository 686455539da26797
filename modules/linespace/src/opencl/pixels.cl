// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The pixels of the edge map and the exact votes of a chord, for the programs that read them: each
// is compiled after chords.cl and this text.
//
// BINARY: a pixel votes if it is not 0; else by its value. MASKED: only where the mask is not 0.
// END_COSINES, BINS: those of orientation.cpp; a chord has the votes of the pixels whose directions
// have its bin.

#ifdef MASKED
#define MASK_PARAMETERS , __global const uchar *mask, int maskStep, int maskOffset
#define MASK_ARGUMENTS , mask, maskStep, maskOffset
#else
#define MASK_PARAMETERS
#define MASK_ARGUMENTS
#endif

inline uchar votesAt(__global const uchar* image, int step, int offset MASK_PARAMETERS, int x, int y)
{
    const uchar votes = image[offset + y * step + x];
#ifdef MASKED
    if (!mask[maskOffset + y * maskStep + x])
        return 0;
#endif
#ifdef BINARY
    return votes != 0;
#else
    return votes;
#endif
}

#ifdef END_COSINES
__constant int END_COSINE[] = {END_COSINES};

/* The bin of the direction of a chord, as directionBin in orientation.cpp. */
inline int directionBin(int2 direction)
{
    if (direction.y < 0 || (direction.y == 0 && direction.x < 0))
        direction = -direction;
    int bin = 0;
    for (int span = BINS / 2; span > 0; span /= 2)
        bin += span * ((long)END_COSINE[bin + span] * direction.y -
                           (long)END_COSINE[abs(BINS / 2 - bin - span)] * direction.x >=
                       0);
    return bin;
}
#define DIRECTIONS_PARAMETERS                                                                      \
    , __global const uchar *directions, int directionStep, int directionOffset
#define DIRECTIONS_ARGUMENTS , directions, directionStep, directionOffset
#else
#define DIRECTIONS_PARAMETERS
#define DIRECTIONS_ARGUMENTS
#endif

/* The votes of chord (s, e) of a frame: those of the pixels of its raster, as struct Raster in
plan.hpp; of an oriented map, of those that vote for the chord's bin. */
inline int votesOfChord(int width, int height, int s, int e, __global const uchar* image, int step,
                        int offset, int rows,
                        int columns MASK_PARAMETERS DIRECTIONS_PARAMETERS)
{
    const int2 p = borderPoint(width, height, s), q = borderPoint(width, height, e);
#ifdef END_COSINES
    const ushort bit = (ushort)(1 << directionBin(q - p));
#endif
    const Raster raster = rasterOf(p, q);
    int minor = raster.minor, rest = raster.rest, sum = 0;
    for (int major = raster.first; major < raster.first + raster.count; ++major)
    {
        const int x = raster.xMajor ? major : minor, y = raster.xMajor ? minor : major;
        if (x < columns && y < rows)
        {
            const int votes = votesAt(image, step, offset MASK_ARGUMENTS, x, y);
#ifdef END_COSINES
            if (*(__global const ushort*)(directions + directionOffset + y * directionStep +
                                          x * (int)sizeof(ushort)) &
                bit)
#endif
                sum += votes;
        }
        rest += raster.step;
        const int over = rest >= raster.modulus, under = rest < 0;
        rest += (under - over) * raster.modulus;
        minor += over - under;
    }
    return sum;
}
