// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Counts neighbouring chords together, column by column: the ascent's inner loop
// (doc/algorithm.md, section 4.2), compiled once per instruction set.
//
// Why this is faster than one chord after the other: neighbours differ by two pixels at most, so
// one load of 16 pixels across the chords serves all of them in a column, a byte shuffle picks each
// one's pixel, and their rasters advance in 16-bit lanes. With AVX2 a column of 32 chords takes
// about 15 instructions; without a byte shuffle of that width there is nothing to gain.

#include "chord_lanes.hpp"

#if CV_AVX2
#include <immintrin.h>
#endif

namespace cv {
namespace linespace {

CV_CPU_OPTIMIZATION_NAMESPACE_BEGIN

//! Whether this instruction set is worth it.
bool hasLanes();

//! Adds each lane's votes in map.columns columns to votes[lane].
void countLanes(const ChordLanes& lanes, const LaneMap& map, int* votes);

#ifndef CV_CPU_OPTIMIZATION_DECLARATIONS_ONLY

#if CV_AVX2

namespace {

inline __m256i load(const void* from)
{
    return _mm256_loadu_si256((const __m256i*)from);
}

//! Lanes 0 to 7 and 16 to 23, or from 8 the others: _mm256_packs_epi16 joins them in order.
inline __m256i loadShorts(const short* from)
{
    return _mm256_inserti128_si256(_mm256_castsi128_si256(_mm_loadu_si128((const __m128i*)from)),
                                   _mm_loadu_si128((const __m128i*)(from + 16)), 1);
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
        // 31 * 8 pixels of 1, or 32 * 8 of 255
        MOST_RUNS = IsWeighted ? 32 : 31
    };
    __m256i low, high;
    int runs;

    LaneSums() : low(_mm256_setzero_si256()), high(low), runs(0) {}
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
        ushort shorts[2][16];
        _mm256_storeu_si256((__m256i*)bytes, low);
        _mm256_storeu_si256((__m256i*)shorts[0], low);
        _mm256_storeu_si256((__m256i*)shorts[1], high);
        for (int lane = 0; lane < 32; ++lane)
            votes[lane] +=
                IsWeighted ? shorts[lane / 8 % 2][lane % 8 + lane / 16 * 8] : bytes[lane];
        *this = LaneSums();
    }
    void endRun(int* votes)
    {
        if (++runs == MOST_RUNS)
            flush(votes);
    }
};

template<bool IsWeighted, bool IsOriented>
void countLanesOf(const ChordLanes& lanes, const LaneMap& map, int* votes)
{
    // The next remainder is the smaller, as unsigned numbers, of remainder + step and that less the
    // modulus: the latter is either in [0, modulus) or wraps to more than any remainder. Two
    // instructions wait for each other from column to column, not four as with a comparison.
    const __m256i stepA = loadShorts(lanes.step), stepB = loadShorts(lanes.step + 8);
    const __m256i wrapA = _mm256_sub_epi16(stepA, loadShorts(lanes.modulus)),
                  wrapB = _mm256_sub_epi16(stepB, loadShorts(lanes.modulus + 8));
    const __m256i direction = load(lanes.direction), bit = load(lanes.bit),
                  one = _mm256_set1_epi8(1);
    __m256i restA = loadShorts(lanes.rest), restB = loadShorts(lanes.rest + 8),
            position = load(lanes.position);
    LaneSums<IsWeighted> sums;
    int base = (int)(map.start >> 32) - map.below;
    for (int column = 0; column < map.columns; column += LaneMap::RUN)
    {
        const int now = (int)((map.start + column * map.increment) >> 32) - map.below;
        position = _mm256_sub_epi8(position, _mm256_set1_epi8((char)(now - base)));
        base = now;
        const ptrdiff_t first = column * map.stride + base;
        const int count = std::min<int>(LaneMap::RUN, map.columns - column);
        for (int i = 0; i < count; ++i)
        {
            const ptrdiff_t window = first + i * map.stride;
            if (!IsOriented)
                sums.add(lookUp(map.votes + window, position));
            else
            {
                const __m256i own = _mm256_and_si256(lookUp(map.bits + window, position), bit);
                const __m256i voting = _mm256_min_epu8(own, one);
                sums.add(IsWeighted
                             ? _mm256_and_si256(lookUp(map.votes + window, position),
                                                _mm256_sub_epi8(_mm256_setzero_si256(), voting))
                             : voting);
            }
            const __m256i wrappedA = _mm256_add_epi16(restA, wrapA),
                          wrappedB = _mm256_add_epi16(restB, wrapB);
            restA = _mm256_min_epu16(_mm256_add_epi16(restA, stepA), wrappedA);
            restB = _mm256_min_epu16(_mm256_add_epi16(restB, stepB), wrappedB);
            const __m256i carryA = _mm256_cmpeq_epi16(restA, wrappedA),
                          carryB = _mm256_cmpeq_epi16(restB, wrappedB);
            position = _mm256_add_epi8(
                position, _mm256_and_si256(_mm256_packs_epi16(carryA, carryB), direction));
        }
        sums.endRun(votes);
    }
    sums.flush(votes);
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
