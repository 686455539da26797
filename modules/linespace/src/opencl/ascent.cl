// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// From the cascade's maxima to chords with the most exact votes (doc/algorithm.md, section 4.2), as
// ascent.hpp defines it.
//
// Candidates are threes of numbers, (votes, s, e), after a first one whose first number is how many
// there are; those that still climb have CLIMBING votes. In a round all climb one step: what their
// neighbourhoods need is marked, each marked chord is counted once, each candidate moves to the
// strongest chord around it. Chords are counted by squares of 8 x 8 neighbours (vote_squares.hpp),
// a bit each of a uint2 of marks. Marks are set by atomic_or and everything else is written by one
// item, so nothing depends on the order of items.
//
// BITS: of a map without weights, whose pixels are bits, 32 across the chords in a word; without it
// they are bytes. LANES: chords that an item counts at once. EXACT: the type of exact votes.
// RADIUS: of the neighbourhood; 0: candidates are only counted, where they are.

enum
{
    SQUARE = 8,
    CLIMBING = -1,
    MARGIN = 2, /* words before the bits of a column */
    MARGIN_AFTER = 3,
    FRACTION = 27 /* bits after the point of a position across a chord */
};

#ifdef BITS

/* Bits are those of EdgeBits; with bins, one after another. */
inline int wordsOf(int length)
{
    return (length + 31) / 32 + MARGIN + MARGIN_AFTER;
}
inline __global const uint* columnsOf(__global const uint* bits, Frame frame, int bin, int xMajor)
{
    const int upright = frame.width * wordsOf(frame.height);
    const int transposed = frame.height * wordsOf(frame.width);
    return bits + bin * (upright + transposed) + (xMajor ? 0 : upright);
}

#define MAP_PARAMETERS , __global const uint *bits
#define MAP_ARGUMENTS , bits

#ifdef END_COSINES
#define BIN_OF(p, q) directionBin((q) - (p))
#else
#define BIN_OF(p, q) 0
#endif

typedef struct __attribute__((packed))
{
    uchar16 values;
} Pixels; /* at any address */
typedef struct __attribute__((packed))
{
    ushort16 values;
} PixelDirections;

/* 1 for those of 16 pixels of a row that vote for a bin, 0 beyond the image. */
inline uchar16 voting(__global const uchar* image, int step, int offset, int rows,
                      int columns MASK_PARAMETERS DIRECTIONS_PARAMETERS, int bin, int x, int y)
{
    uchar16 result = 0;
    if (y < 0 || y >= rows || x <= -16 || x >= columns)
        return result;
    if (x < 0 || x + 16 > columns)
    {
        uchar single[16];
        for (int i = 0; i < 16; ++i)
            single[i] = x + i >= 0 && x + i < columns &&
                        votesAt(image, step, offset MASK_ARGUMENTS, x + i, y)
#ifdef END_COSINES
                        && *(__global const ushort*)(directions + directionOffset +
                                                     y * directionStep +
                                                     (x + i) * (int)sizeof(ushort)) >> bin & 1
#endif
                ;
        return vload16(0, single);
    }
    result = min(((__global const Pixels*)(image + offset + y * step + x))->values, (uchar16)1);
#ifdef MASKED
    result &=
        min(((__global const Pixels*)(mask + maskOffset + y * maskStep + x))->values, (uchar16)1);
#endif
#ifdef END_COSINES
    result &= convert_uchar16(((__global const PixelDirections*)(directions + directionOffset +
                                                                 y * directionStep +
                                                                 x * (int)sizeof(ushort)))
                                      ->values >>
                                  (ushort)bin &
                              (ushort)1);
#endif
    return result;
}

/* The low bits of 16 bytes that are 0 or 1. */
inline uint bitsOfBytes(uchar16 bytes)
{
    const ulong2 gathered = as_ulong2(bytes) * (ulong)0x0102040810204080 >> (ulong)56;
    return (uint)(gathered.x | gathered.y << 8);
}

/* The bits of columns along x, 16 columns and a word of each. Global size: columns of the frame / 16,
words and bins. */
__kernel void packColumns(__global const uchar* image, int step, int offset, int rows,
                          int columns MASK_PARAMETERS DIRECTIONS_PARAMETERS, int width, int height,
                          __global uint* bits)
{
    const Frame frame = {width, height};
    const int words = wordsOf(height), x = get_global_id(0) * 16;
    const int bin = get_global_id(1) / words, word = get_global_id(1) - bin * words;
    if (x >= width)
        return;
    const int first = (word - MARGIN) * 32, begin = max(first, 0), end = min(first + 32, rows);
    uint16 result = 0;
    for (int y = begin; y < end; ++y)
        result |= convert_uint16(voting(image, step, offset, rows,
                                        columns MASK_ARGUMENTS DIRECTIONS_ARGUMENTS, bin, x, y))
                  << (uint)(y - first);
    uint single[16];
    vstore16(result, 0, single);
    __global uint* const out =
        (__global uint*)columnsOf(bits, frame, bin, 1) + (size_t)x * words + word;
    for (int i = 0; i < min(16, width - x); ++i)
        out[i * words] = single[i];
}

/* The bits of columns along y: the image's rows. Global size: words, rows of the frame and bins. */
__kernel void packRows(__global const uchar* image, int step, int offset, int rows,
                       int columns MASK_PARAMETERS DIRECTIONS_PARAMETERS, int width, int height,
                       __global uint* bits)
{
    const Frame frame = {width, height};
    const int words = wordsOf(width), word = get_global_id(0);
    const int bin = get_global_id(1) / height, y = get_global_id(1) - bin * height;
    if (word >= words)
        return;
    uint result = 0;
    for (int part = 0; part < 2; ++part)
        result |=
            bitsOfBytes(voting(image, step, offset, rows,
                               columns MASK_ARGUMENTS DIRECTIONS_ARGUMENTS, bin,
                               (word - MARGIN) * 32 + part * 16, y))
            << part * 16;
    ((__global uint*)columnsOf(bits, frame, bin, 0))[(size_t)y * words + word] = result;
}

/* The votes of a chord. */
inline int countChord(Frame frame, int s, int e MAP_PARAMETERS)
{
    const int2 p = borderPoint(frame.width, frame.height, s);
    const int2 q = borderPoint(frame.width, frame.height, e);
    const Raster raster = rasterOf(p, q);
    const int words = wordsOf(raster.xMajor ? frame.height : frame.width);
    __global const uint* column =
        columnsOf(bits, frame, BIN_OF(p, q), raster.xMajor) + (size_t)raster.first * words;
    int minor = raster.minor + 32 * MARGIN, rest = raster.rest, sum = 0;
    for (int i = 0; i < raster.count; ++i, column += words)
    {
        sum += column[minor >> 5] >> (minor & 31) & 1;
        rest += raster.step;
        const int over = rest >= raster.modulus, under = rest < 0;
        rest += (under - over) * raster.modulus;
        minor += over - under;
    }
    return sum;
}

#else /* not BITS */

#define MAP_PARAMETERS                                                                             \
    , __global const uchar *image, int step, int offset, int rows,                                 \
        int columns MASK_PARAMETERS DIRECTIONS_PARAMETERS
#define MAP_ARGUMENTS , image, step, offset, rows, columns MASK_ARGUMENTS DIRECTIONS_ARGUMENTS

inline int countChord(Frame frame, int s, int e MAP_PARAMETERS)
{
    return votesOfChord(frame.width, frame.height, s, e MAP_ARGUMENTS);
}

#endif

#if RADIUS == 0

/* Candidates that do not climb: each gets its exact votes. Global size: candidates that there may
be. */
__kernel void countCandidates(__global int* candidates, int room, int width,
                              int height MAP_PARAMETERS)
{
    const int i = get_global_id(0);
    if (i >= min(candidates[0], room))
        return;
    const Frame frame = {width, height};
    __global int* const candidate = candidates + 3 * (i + 1);
    candidate[0] = countChord(frame, candidate[1], candidate[2] MAP_ARGUMENTS);
}

#else

/* A cell with a border point for each run of SQUARE of a frame's, of each side from its first one
on. */
inline Frame runsOf(Frame frame)
{
    const Frame runs = {(frame.width + SQUARE - 1) / SQUARE, (frame.height + SQUARE - 1) / SQUARE};
    return runs;
}

/* Of the side of point p of a frame: its first point, its number of points, its first run. */
inline int3 sideAndRuns(Frame frame, int p)
{
    const Frame runs = runsOf(frame);
    const int w = frame.width, h = frame.height;
    return p < w           ? (int3)(0, w, 0)
           : p < w + h     ? (int3)(w, h, runs.width)
           : p < 2 * w + h ? (int3)(w + h, w, runs.width + runs.height)
                           : (int3)(2 * w + h, h, 2 * runs.width + runs.height);
}

/* The square of two runs, p < q. */
inline int squareOf(Frame runs, int p, int q)
{
    return rowStart(runs, p) + q - sideOf(runs, p).y;
}

/* The first chord of a square. */
inline int2 firstChordOf(Frame frame, int square)
{
    const Frame runs = runsOf(frame);
    const int2 pair = chordAt(runs, square);
    int2 result;
    for (int k = 0; k < 2; ++k)
    {
        const int run = k ? pair.y : pair.x;
        const int firstRun = sideOf(runs, run).x;
        const int first = firstRun == 0                          ? 0
                          : firstRun == runs.width               ? frame.width
                          : firstRun == runs.width + runs.height ? frame.width + frame.height
                                                                 : 2 * frame.width + frame.height;
        if (k)
            result.y = first + (run - firstRun) * SQUARE;
        else
            result.x = first + (run - firstRun) * SQUARE;
    }
    return result;
}

/* The square and the bit there of a chord, s < e. */
inline int2 placeOf(Frame frame, int s, int e)
{
    const int3 sideS = sideAndRuns(frame, s), sideE = sideAndRuns(frame, e);
    const int u = s - sideS.x, w = e - sideE.x;
    return (int2)(squareOf(runsOf(frame), sideS.z + u / SQUARE, sideE.z + w / SQUARE),
                  u % SQUARE * SQUARE + w % SQUARE);
}

/* Chord (s + i, e + j) on the ring, the smaller end first. Is false if its ends are on one side. */
inline bool neighbourOf(Frame frame, int s, int e, int i, int j, int2* neighbour)
{
    const int points = 2 * (frame.width + frame.height);
    const int p = (s + i + points) % points, q = (e + j + points) % points;
    *neighbour = (int2)(min(p, q), max(p, q));
    return neighbour->y >= sideOf(frame, neighbour->x).y;
}

/* The neighbourhood of a chord, wherever it is, is walked by j < NEIGHBOURS: the j-th chord and where
it stands, as placeOf; false if it is none. */
#define NEIGHBOURS ((2 * RADIUS + 1) * (2 * RADIUS + 1))
inline bool findNeighbour(Frame frame, int s, int e, int j, int2* neighbour, int2* place)
{
    if (!neighbourOf(frame, s, e, j / (2 * RADIUS + 1) - RADIUS, j % (2 * RADIUS + 1) - RADIUS,
                     neighbour))
        return false;
    *place = placeOf(frame, neighbour->x, neighbour->y);
    return true;
}

/* Whether a neighbourhood keeps to the sides of its middle. */
inline bool isInside(int u, int w, int pointsS, int pointsE)
{
    return min(u, w) >= RADIUS && u + RADIUS < pointsS && w + RADIUS < pointsE;
}

/* Global size: squares. */
__kernel void clearMarks(__global uint2* wanted, __global uint2* counted, int squares)
{
    const int square = get_global_id(0);
    if (square < squares)
        wanted[square] = counted[square] = (uint2)0;
}

inline void want(__global uint* wanted, int square, ulong chords)
{
    const uint2 halves = as_uint2(chords);
    if (halves.x)
        atomic_or(wanted + 2 * square, halves.x);
    if (halves.y)
        atomic_or(wanted + 2 * square + 1, halves.y);
}

/* Marks the neighbourhoods of the candidates that climb; with isFirst, all do. Global size: candidates
that there may be. */
__kernel void wantNeighbours(__global int* candidates, int room, int width, int height, int isFirst,
                             __global uint* wanted)
{
    const int i = get_global_id(0);
    if (i >= min(candidates[0], room))
        return;
    __global int* const candidate = candidates + 3 * (i + 1);
    if (isFirst)
        candidate[0] = CLIMBING;
    if (candidate[0] != CLIMBING)
        return;
    const Frame frame = {width, height};
    const int s = candidate[1], e = candidate[2];
    const int3 sideS = sideAndRuns(frame, s), sideE = sideAndRuns(frame, e);
    const int u = s - sideS.x, w = e - sideE.x;
    if (!isInside(u, w, sideS.y, sideE.y))
    {
        for (int j = 0; j < NEIGHBOURS; ++j)
        {
            int2 neighbour, place;
            if (findNeighbour(frame, s, e, j, &neighbour, &place))
                want(wanted, place.x, (ulong)1 << place.y);
        }
        return;
    }
    const Frame runs = runsOf(frame);
    for (int k = (u - RADIUS) / SQUARE; k <= (u + RADIUS) / SQUARE; ++k)
    {
        const int top = max(u - RADIUS - SQUARE * k, 0);
        const int bottom = min(u + RADIUS - SQUARE * k, SQUARE - 1);
        const ulong rows = ~(ulong)0 << SQUARE * top & ~(ulong)0 >> SQUARE * (SQUARE - 1 - bottom);
        for (int l = (w - RADIUS) / SQUARE; l <= (w + RADIUS) / SQUARE; ++l)
        {
            const int left = max(w - RADIUS - SQUARE * l, 0);
            const int right = min(w + RADIUS - SQUARE * l, SQUARE - 1);
            const ulong row = 0xff << left & 0xff >> (SQUARE - 1 - right);
            want(wanted, squareOf(runs, sideS.z + k, sideE.z + l),
                 rows & row * (ulong)0x0101010101010101);
        }
    }
}

#if LANES > 1

/* rest / modulus < 1 in units of 2^-FRACTION, one more than its floor. */
inline uint fractionOf(int rest, int modulus)
{
    const int high = quotient(rest << 14, modulus);
    return ((uint)high << 13) + quotient(((rest << 14) - high * modulus) << 13, modulus) + 1;
}

/* Counts LANES chords of a square at once, whose ends are SQUARE - 1 border points apart at most, so in
any column of the chords there their pixels are as near one another; each is drawn on beyond its ends,
where there are no pixels, to the columns of the others. In RUN columns they pass RUN pixels more, and so
all are in one window of 32. Positions across a chord have FRACTION bits after the point and are rounded
up: after n columns of a chord of up to n pixels they are too large by (n + 1) 2^-FRACTION, which is less
than the distance 1 / (2 n) of all below an integer if n (n + 1) < 2^26. */
inline void countLanes(Frame frame, const int* s, const int* e, int* votes MAP_PARAMETERS)
{
    enum
    {
        RUN = 8,
        LEAST_COLUMNS = 80 /* of a chord; directions of shorter ones differ too much */
    };
    Raster rasters[LANES];
    int bins[LANES];
    for (int lane = 0; lane < LANES; ++lane)
    {
        const int2 p = borderPoint(frame.width, frame.height, s[lane]);
        const int2 q = borderPoint(frame.width, frame.height, e[lane]);
        rasters[lane] = rasterOf(p, q);
        bins[lane] = BIN_OF(p, q);
    }
    uint left = (1u << LANES) - 1;
    while (left)
    {
        const int guide = 31 - (int)clz(left & -left);
        const Raster raster = rasters[guide];
        if (raster.count < LEAST_COLUMNS)
        {
            votes[guide] = countChord(frame, s[guide], e[guide] MAP_ARGUMENTS);
            left &= left - 1;
            continue;
        }
        /* All that read the same bits. */
        uint together = 0;
        int first = raster.first, end = first + raster.count;
        for (int lane = 0; lane < LANES; ++lane)
            if (left >> lane & 1 && rasters[lane].xMajor == raster.xMajor &&
                bins[lane] == bins[guide])
            {
                together |= 1u << lane;
                first = min(first, rasters[lane].first);
                end = max(end, rasters[lane].first + rasters[lane].count);
            }
        left &= ~together;
        uint starts[LANES], increments[LANES];
        long position = 0;
        int base = 0;
        const int ahead = raster.step < 0 ? 18 : 10; /* from a window's first pixel to the guide */
        for (int k = 0; k < LANES; ++k)
        {
            const int lane = k == 0 ? guide : k <= guide ? k - 1 : k;
            const Raster own = rasters[lane];
            const int whole = own.step >= own.modulus ? 1 : own.step < 0 ? -1 : 0;
            increments[lane] =
                ((uint)whole << FRACTION) +
                fractionOf((own.step - whole * own.modulus) / 2, own.modulus / 2);
            const long start = ((long)own.minor << FRACTION) +
                               fractionOf(own.rest / 2, own.modulus / 2) -
                               (long)(own.first - first) * (int)increments[lane];
            if (k == 0)
            {
                position = start;
                base = (int)(start >> FRACTION) - ahead;
            }
            starts[lane] = (uint)(start - ((long)base << FRACTION));
        }
        const CONCAT(uint, LANES) increment = CONCAT(vload, LANES)(0, increments);
        CONCAT(uint, LANES) at = CONCAT(vload, LANES)(0, starts), sums = 0;
        const int words = wordsOf(raster.xMajor ? frame.height : frame.width);
        const long steps = (long)RUN * (int)increments[guide];
        __global const uint* column =
            columnsOf(bits, frame, bins[guide], raster.xMajor) + (size_t)first * words;
        for (int c = first; c < end; c += RUN)
        {
            const int place = base + 32 * MARGIN;
            __global const uint* word = column + (place >> 5);
            for (int k = 0; k < min((int)RUN, end - c); ++k, word += words, at += increment)
            {
                const uint window = (uint)((((ulong)word[1] << 32) | word[0]) >> (place & 31));
                sums += (CONCAT(uint, LANES))(window) >> (at >> (uint)FRACTION) & 1u;
            }
            column += RUN * words;
            position += steps;
            const int next = (int)(position >> FRACTION) - ahead;
            at -= (uint)(next - base) << FRACTION;
            base = next;
        }
        uint counts[LANES];
        CONCAT(vstore, LANES)(sums, 0, counts);
        for (int lane = 0; lane < LANES; ++lane)
            if (together >> lane & 1)
                votes[lane] = (int)counts[lane];
    }
}

#endif

/* Counts the chords that are wanted and not yet counted, the i-th one of a square at votes[64 square +
i]: an item takes LANES of them, and then those after the LANES that each other one takes. Global size:
squares, items for each. */
__kernel void countWanted(int width, int height, int squares, __global const uint2* wanted,
                          __global const uint2* counted MAP_PARAMETERS, __global EXACT* votes)
{
    const int square = get_global_id(0);
    if (square >= squares)
        return;
    ulong chords = as_ulong(wanted[square] & ~counted[square]);
    if (!chords)
        return;
    const Frame frame = {width, height};
    const int2 first = firstChordOf(frame, square);
    for (int skipped = get_global_id(1) * LANES; chords;
         skipped = ((int)get_global_size(1) - 1) * LANES)
    {
        for (int k = 0; k < skipped && chords; ++k)
            chords &= chords - 1;
        int places[LANES], s[LANES], e[LANES], own[LANES], count = 0;
        for (; count < LANES && chords; ++count, chords &= chords - 1)
        {
            const int place = 63 - (int)clz(chords & -chords);
            places[count] = place;
            s[count] = first.x + place / SQUARE;
            e[count] = first.y + place % SQUARE;
        }
        if (count == 0)
            break;
#if LANES > 1
        for (int lane = count; lane < LANES; ++lane)
        {
            s[lane] = s[0];
            e[lane] = e[0];
        }
        countLanes(frame, s, e, own MAP_ARGUMENTS);
#else
        own[0] = countChord(frame, s[0], e[0] MAP_ARGUMENTS);
#endif
        for (int lane = 0; lane < count; ++lane)
            votes[(size_t)square * 64 + places[lane]] = (EXACT)own[lane];
    }
}

/* Global size: squares. */
__kernel void markCounted(__global uint2* wanted, __global uint2* counted, int squares)
{
    const int square = get_global_id(0);
    if (square >= squares)
        return;
    const uint2 chords = wanted[square];
    if (!(chords.x | chords.y))
        return;
    counted[square] |= chords;
    wanted[square] = 0;
}

/* The total order, as isStronger in peaks.hpp: (votes, s, e). */
inline bool isStronger(int3 a, int3 b)
{
    return a.x != b.x ? a.x > b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

/* The strongest chord of a neighbourhood that was counted. */
inline int3 strongestAround(Frame frame, __global const EXACT* votes, int s, int e)
{
    const int3 sideS = sideAndRuns(frame, s), sideE = sideAndRuns(frame, e);
    const int u = s - sideS.x, w = e - sideE.x;
    int3 best = (int3)(-1, 0, 0);
    if (!isInside(u, w, sideS.y, sideE.y))
    {
        for (int j = 0; j < NEIGHBOURS; ++j)
        {
            int2 neighbour, place;
            if (!findNeighbour(frame, s, e, j, &neighbour, &place))
                continue;
            const int3 other =
                (int3)(votes[(size_t)place.x * 64 + place.y], neighbour.x, neighbour.y);
            if (isStronger(other, best))
                best = other;
        }
        return best;
    }
    const Frame runs = runsOf(frame);
    for (int i = u - RADIUS; i <= u + RADIUS; ++i)
    {
        __global const EXACT* const row =
            votes + (size_t)squareOf(runs, sideS.z + i / SQUARE, sideE.z) * 64 + i % SQUARE * SQUARE;
        for (int j = w - RADIUS; j <= w + RADIUS; ++j)
        {
            const int own = row[j / SQUARE * 64 + j % SQUARE];
            if (own > best.x) /* those before come first in the order */
                best = (int3)(own, sideS.x + i, sideE.x + j);
        }
    }
    return best;
}

/* Each candidate that climbs moves to the strongest chord around it, or is there. Global size:
candidates that there may be. */
__kernel void takeSteps(__global int* candidates, int room, int width, int height,
                        __global const EXACT* votes)
{
    const int i = get_global_id(0);
    if (i >= min(candidates[0], room))
        return;
    __global int* const candidate = candidates + 3 * (i + 1);
    if (candidate[0] != CLIMBING)
        return;
    const Frame frame = {width, height};
    const int3 best = strongestAround(frame, votes, candidate[1], candidate[2]);
    if (best.y == candidate[1] && best.z == candidate[2])
        candidate[0] = best.x;
    candidate[1] = best.y;
    candidate[2] = best.z;
}

/* The few candidates that climb for more steps than there are rounds go on alone, and count what was
not counted for others. Global size: candidates that there may be. */
__kernel void climbOn(__global int* candidates, int room, int width, int height,
                      __global const uint2* counted,
                      __global const EXACT* votes MAP_PARAMETERS)
{
    const int i = get_global_id(0);
    if (i >= min(candidates[0], room))
        return;
    __global int* const candidate = candidates + 3 * (i + 1);
    if (candidate[0] != CLIMBING)
        return;
    const Frame frame = {width, height};
    int3 own = (int3)(-1, candidate[1], candidate[2]), best = own;
    do
    {
        own = best;
        for (int j = 0; j < NEIGHBOURS; ++j)
        {
            int2 neighbour, place;
            if (!findNeighbour(frame, own.y, own.z, j, &neighbour, &place))
                continue;
            const bool isKnown = as_ulong(counted[place.x]) >> place.y & 1;
            const int3 other =
                (int3)(isKnown ? (int)votes[(size_t)place.x * 64 + place.y]
                               : countChord(frame, neighbour.x, neighbour.y MAP_ARGUMENTS),
                       neighbour.x, neighbour.y);
            if (isStronger(other, best))
                best = other;
        }
    } while (best.y != own.y || best.z != own.z);
    vstore3(best, 0, candidate);
}

#endif // RADIUS
