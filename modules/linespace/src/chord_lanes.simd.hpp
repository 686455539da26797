// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Counts neighbouring chords together, column by column: the ascent's inner loop
// (doc/algorithm.md, section 4.2), compiled once per instruction set.
//
// Why this is faster than one chord after the other:
// - neighbours are near each other, so one load of 16 pixels across the chords serves all of them
//   in a column, and a byte shuffle picks each one's pixel;
// - a chord's position is a byte and its fraction 16 bits, exact enough for a few columns: an add
//   and a comparison tell 16 chords whether they pass to the next pixel;
// - what is prepared for each chord, a division among it, is done for four at once.
// With AVX2 a column of 32 chords takes about 10 instructions; without a byte shuffle of that width
// there is nothing to gain.

#include "chord_lanes.hpp"

#if CV_AVX2
#include <immintrin.h>
#endif

namespace cv {
namespace linespace {

CV_CPU_OPTIMIZATION_NAMESPACE_BEGIN

//! Whether this instruction set is worth it.
bool hasLanes();

//! The votes of each lane in the map's columns.
void countLanes(const ChordLanes& lanes, const LaneMap& map, int* votes);

#ifndef CV_CPU_OPTIMIZATION_DECLARATIONS_ONLY

#if CV_AVX2

namespace {

inline __m256i load(const void* from)
{
    return _mm256_loadu_si256((const __m256i*)from);
}

/** Where the lanes are at a column, in pixels beyond the start of the window and fractions of 2^-32
pixels, and what is added to the fractions in each column; a falling lane's slope is taken plus 1.
Both are rounded up, as in Raster::fixedPoint. */
struct LaneState
{
    uint fraction[ChordLanes::COUNT], increment[ChordLanes::COUNT];
    int position[ChordLanes::COUNT];
};

//! The low 32 bits of integers from 0 to 2^32 - 1.
inline __m128i toUnsigned(__m256d values)
{
    const __m256i bits =
        _mm256_castpd_si256(_mm256_add_pd(values, _mm256_set1_pd(4503599627370496.))); // 2^52
    return _mm256_castsi256_si128(
        _mm256_permutevar8x32_epi32(bits, _mm256_setr_epi32(0, 2, 4, 6, 0, 2, 4, 6)));
}

/** Quotients by dx are taken with its reciprocal, which is wrong by less than 2^-18 for quotients
below 2^33; those that are not integers differ from these by at least 1 / dx >= 2^-14, so with 2^-16
they are rounded to the right side. Numerators are below 2^31 and products exact. */
void start(const ChordLanes& lanes, int column, int window, LaneState& state)
{
    const __m256d tie = _mm256_set1_pd(1. / 65536), one = _mm256_set1_pd(4294967296.);
    const __m128i twice = _mm_set1_epi32(2 * column + 1);
    for (int i = 0; i < ChordLanes::COUNT; i += 4)
    {
        const __m128i x = _mm_loadu_si128((const __m128i*)(lanes.x + i)),
                      y = _mm_loadu_si128((const __m128i*)(lanes.y + i)),
                      dx = _mm_loadu_si128((const __m128i*)(lanes.dx + i)),
                      dy = _mm_loadu_si128((const __m128i*)(lanes.dy + i));
        const __m128i numerator = _mm_srai_epi32(
            _mm_add_epi32(_mm_mullo_epi32(y, dx), _mm_mullo_epi32(_mm_sub_epi32(twice, x), dy)), 1);
        const __m128i slope = _mm_add_epi32(dy, _mm_and_si128(_mm_srai_epi32(dy, 31), dx));
        const __m256d n = _mm256_cvtepi32_pd(numerator), d = _mm256_cvtepi32_pd(dx),
                      reciprocal = _mm256_div_pd(_mm256_set1_pd(1), d);
        const __m256d quotient = _mm256_floor_pd(_mm256_add_pd(_mm256_mul_pd(n, reciprocal), tie));
        const __m256d rest = _mm256_sub_pd(n, _mm256_mul_pd(quotient, d));
        const __m256d scale = _mm256_mul_pd(reciprocal, one);
        const __m256d fraction = _mm256_ceil_pd(_mm256_sub_pd(_mm256_mul_pd(rest, scale), tie)),
                      increment = _mm256_ceil_pd(
                          _mm256_sub_pd(_mm256_mul_pd(_mm256_cvtepi32_pd(slope), scale), tie));
        _mm_storeu_si128((__m128i*)(state.fraction + i), toUnsigned(fraction));
        _mm_storeu_si128((__m128i*)(state.increment + i), toUnsigned(increment));
        _mm_storeu_si128((__m128i*)(state.position + i),
                         _mm_sub_epi32(_mm256_cvtpd_epi32(quotient), _mm_set1_epi32(window)));
    }
}

//! Fractions of 2^-16, rounded up, minus 2^15: signed comparisons order them. The order of the
//! lanes is 0-3, 8-11, 4-7, 12-15.
inline __m256i toShorts(__m256i first, __m256i second)
{
    const __m256i up = _mm256_set1_epi32(0xffff);
    return _mm256_xor_si256(
        _mm256_packus_epi32(_mm256_srli_epi32(_mm256_add_epi32(first, up), 16),
                            _mm256_srli_epi32(_mm256_add_epi32(second, up), 16)),
        _mm256_set1_epi16((short)0x8000));
}

//! Groups of four lanes in the order in which two toShorts are packed into bytes, and back.
inline __m256i toPacked(__m256i bytes)
{
    return _mm256_permutevar8x32_epi32(bytes, _mm256_setr_epi32(0, 2, 4, 6, 1, 3, 5, 7));
}
inline __m256i fromPacked(__m256i bytes)
{
    return _mm256_permutevar8x32_epi32(bytes, _mm256_setr_epi32(0, 4, 1, 5, 2, 6, 3, 7));
}

inline __m256i bytesOf(const int* values)
{
    const __m256i first = _mm256_packs_epi32(load(values), load(values + 8)),
                  second = _mm256_packs_epi32(load(values + 16), load(values + 24));
    // 0-3, 8-11, 16-19, 24-27, 4-7, 12-15, 20-23, 28-31: that of toPacked already
    return _mm256_packus_epi16(first, second);
}

inline __m256i lookUp(const uchar* window, __m256i position)
{
    return _mm256_shuffle_epi8(_mm256_broadcastsi128_si256(_mm_loadu_si128((const __m128i*)window)),
                               position);
}

//! Sums of bytes, or of weights in shorts, until they are full.
template<bool IsWeighted>
struct LaneSums
{
    enum
    {
        MOST_COLUMNS = 248 // a multiple of LaneMap::RUN; of 1 in bytes, or of 255 in shorts
    };
    __m256i low, high;

    LaneSums() : low(_mm256_setzero_si256()), high(low) {}
    void add(__m256i pixels)
    {
        if (!IsWeighted)
        {
            low = _mm256_add_epi8(low, pixels);
            return;
        }
        const __m256i zero = _mm256_setzero_si256();
        low = _mm256_add_epi16(low, _mm256_unpacklo_epi8(pixels, zero));
        high = _mm256_add_epi16(high, _mm256_unpackhi_epi8(pixels, zero));
    }
    void flush(int* votes)
    {
        uchar bytes[32];
        ushort shorts[32];
        if (IsWeighted)
        {
            // low: the packed lanes 0-7, 16-23
            const __m256i first = _mm256_permute2x128_si256(low, high, 0x20),
                          second = _mm256_permute2x128_si256(low, high, 0x31);
            _mm256_storeu_si256((__m256i*)shorts, first);
            _mm256_storeu_si256((__m256i*)(shorts + 16), second);
            static const int GROUPS[8] = {0, 4, 1, 5, 2, 6, 3, 7}; // as in fromPacked
            for (int lane = 0; lane < 32; ++lane)
                votes[lane] += shorts[4 * GROUPS[lane / 4] + lane % 4];
        }
        else
        {
            _mm256_storeu_si256((__m256i*)bytes, fromPacked(low));
            for (int lane = 0; lane < 32; ++lane)
                votes[lane] += bytes[lane];
        }
        *this = LaneSums();
    }
};

//! Columns from one rounding of the fractions to the next: after i of them a fraction is too large
//! by less than (i + 2) 2^-16, and what is not an integer is 1 / dx below the next one at least.
int runOf(const ChordLanes& lanes)
{
    int most = 0;
    for (int i = 0; i < lanes.count; ++i)
        most = std::max(most, lanes.dx[i]);
    int run = LaneMap::RUN;
    while ((run + 2) * most > 65536)
        run /= 2;
    CV_DbgAssert(run >= 2);
    return run;
}

template<bool IsWeighted, bool IsOriented>
void countLanesOf(const ChordLanes& lanes, const LaneMap& map, int* votes)
{
    const LaneLine& guide = map.guide;
    const int64 one = (int64)1 << 32, numerator = guide.at(map.firstColumn);
    // The floor's remainder, also of numerators below 0.
    int64 row = numerator / guide.dx, rest = numerator % guide.dx;
    if (rest < 0)
    {
        rest += guide.dx;
        --row;
    }
    int64 position = row * one + (rest * one + guide.dx - 1) / guide.dx;
    const int64 slope = guide.dy * one,
                advance = slope >= 0 ? (slope + guide.dx - 1) / guide.dx : -(-slope / guide.dx);

    int base = (int)row - ChordLanes::REACH;
    LaneState state;
    start(lanes, map.firstColumn, base, state);
    const int run = runOf(lanes), drift = map.falling ? -1 : 0;
    const ptrdiff_t step = map.stride + drift;

    __m256i fraction[4], longStep[4], increments[4];
    for (int k = 0; k < 4; ++k)
    {
        fraction[k] = load(state.fraction + 8 * k);
        increments[k] = load(state.increment + 8 * k);
        longStep[k] = _mm256_mullo_epi32(increments[k], _mm256_set1_epi32(run));
    }
    const __m256i sign = _mm256_set1_epi16((short)0x8000);
    const __m256i stepA = _mm256_xor_si256(toShorts(increments[0], increments[1]), sign),
                  stepB = _mm256_xor_si256(toShorts(increments[2], increments[3]), sign);
    const __m256i bit = IsOriented ? toPacked(load(lanes.bit)) : _mm256_setzero_si256(),
                  unit = _mm256_set1_epi8(1);
    __m256i pixel = bytesOf(state.position);
    std::fill(votes, votes + ChordLanes::COUNT, 0);

    const uchar* values = map.votes + map.firstColumn * map.stride;
    const uchar* bits = map.bits + map.firstColumn * map.stride;
    LaneSums<IsWeighted> sums;
    for (int column = 0; column < map.columns;)
    {
        const int end = std::min<int>(map.columns, column + LaneSums<IsWeighted>::MOST_COLUMNS);
        for (; column < end; column += run)
        {
            const int now = (int)(position >> 32) - ChordLanes::REACH;
            pixel = _mm256_sub_epi8(pixel, _mm256_set1_epi8((char)(now - base)));
            base = now;
            __m256i restA = toShorts(fraction[0], fraction[1]),
                    restB = toShorts(fraction[2], fraction[3]);
            const auto nextColumn = [&](ptrdiff_t at)
            {
                if (!IsOriented)
                    sums.add(lookUp(values + at, pixel));
                else
                {
                    const __m256i own = _mm256_and_si256(lookUp(bits + at, pixel), bit);
                    const __m256i voting = _mm256_min_epu8(own, unit);
                    sums.add(IsWeighted
                                 ? _mm256_and_si256(lookUp(values + at, pixel),
                                                    _mm256_sub_epi8(_mm256_setzero_si256(), voting))
                                 : voting);
                }
                const __m256i nextA = _mm256_add_epi16(restA, stepA),
                              nextB = _mm256_add_epi16(restB, stepB);
                // -1 where the fraction has passed 1
                pixel =
                    _mm256_sub_epi8(pixel, _mm256_packs_epi16(_mm256_cmpgt_epi16(restA, nextA),
                                                              _mm256_cmpgt_epi16(restB, nextB)));
                restA = nextA;
                restB = nextB;
            };
            ptrdiff_t window = column * map.stride + base;
            const int count = std::min(run, map.columns - column);
            if (count == LaneMap::RUN) // without a test in each column
                for (int i = 0; i < LaneMap::RUN; ++i, window += step)
                    nextColumn(window);
            else
                for (int i = 0; i < count; ++i, window += step)
                    nextColumn(window);
            base += drift * count;
            position += count * advance;
            for (int k = 0; k < 4; ++k)
                fraction[k] = _mm256_add_epi32(fraction[k], longStep[k]);
        }
        sums.flush(votes);
    }
}

} // namespace

bool hasLanes()
{
    return true;
}

void countLanes(const ChordLanes& lanes, const LaneMap& map, int* votes)
{
    if (map.bits)
        (map.weighted ? countLanesOf<true, true> : countLanesOf<false, true>)(lanes, map, votes);
    else
        (map.weighted ? countLanesOf<true, false> : countLanesOf<false, false>)(lanes, map, votes);
}

#else

bool hasLanes()
{
    return false;
}

void countLanes(const ChordLanes&, const LaneMap&, int*)
{
    CV_Error(Error::StsInternal, "hasChordLanes() is false");
}

#endif // CV_AVX2

#endif // CV_CPU_OPTIMIZATION_DECLARATIONS_ONLY

CV_CPU_OPTIMIZATION_NAMESPACE_END

} // namespace linespace
} // namespace cv
