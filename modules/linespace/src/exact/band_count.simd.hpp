// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The votes of one chord in a band, compiled once per instruction set (band_count.dispatch.cpp).
//
// Why this is faster than a walk along the chord: a vector holds the exact positions, quotient and
// remainder, of the chord in 8 to 32 columns and takes them all to the next ones by two additions
// and one comparison; each tests a bit of its column's word.

#include "../precomp.hpp"
#include "../vectors.hpp"
#include "chord_band.hpp"
#include "parallel_band.hpp"

namespace cv {
namespace linespace {

CV_CPU_OPTIMIZATION_NAMESPACE_BEGIN

int countBand(const BandWords& band, const Raster& raster);
void countParallelsOf(const ParallelColumns& columns, int d, int* votes);

#ifndef CV_CPU_OPTIMIZATION_DECLARATIONS_ONLY

namespace {

//! From a pixel's position to that of the one so many columns on: numbers are mod 2^16.
struct Stride
{
    int quotient, remainder;
    //! Twice as many.
    Stride twice(int modulus) const
    {
        Stride result = {2 * quotient, 2 * remainder};
        if (result.remainder >= modulus)
        {
            result.remainder -= modulus;
            ++result.quotient;
        }
        return result;
    }
};

#if LINESPACE_SIMD

enum
{
    LANES = CV_SIMD_WIDTH / 2
};

//! Positions of a chord in LANES columns.
struct Positions
{
    v_uint16 minor, rest, modulus;
    //! Adds a stride in the lanes of a mask.
    void add(const v_uint16& quotient, const v_uint16& remainder)
    {
        rest = v_add_wrap(rest, remainder);
        const v_uint16 carry = v_eq(v_max(rest, modulus), rest); // where rest >= modulus, -1
        rest = v_sub_wrap(rest, v_and(modulus, carry));
        minor = v_sub_wrap(v_add_wrap(minor, quotient), carry);
    }
};

//! 1 where bit n of a word is set, n < 16; any number where n is larger.
inline v_uint16 bitOf(const v_uint16& words, const v_uint16& n)
{
    const v_uint16 one = vx_setall_u16(1);
#if CV_AVX_512BW
    return v_and(v_uint16(_mm512_srlv_epi16(words.val, n.val)), one);
#elif CV_AVX2
    // 2^n has its bit in the lower byte or in the upper one: tables for both, and none beyond.
    const __m256i low = _mm256_setr_epi8(1, 2, 4, 8, 16, 32, 64, -128, 0, 0, 0, 0, 0, 0, 0, 0, //
                                         1, 2, 4, 8, 16, 32, 64, -128, 0, 0, 0, 0, 0, 0, 0, 0),
                  high = _mm256_setr_epi8(0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 4, 8, 16, 32, 64, -128, //
                                          0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 4, 8, 16, 32, 64, -128),
                  both = _mm256_or_si256(n.val, _mm256_slli_epi16(n.val, 8)),
                  power = _mm256_blendv_epi8(_mm256_shuffle_epi8(low, both),
                                             _mm256_shuffle_epi8(high, both),
                                             _mm256_set1_epi16((short)0xff00));
    const v_uint16 isSet = v_ne(v_and(words, v_uint16(power)), vx_setzero_u16());
    return v_and(isSet, one);
#elif CV_NEON
    const int16x8_t right = vnegq_s16(vreinterpretq_s16_u16(n.val));
    return v_and(v_uint16(vshlq_u16(words.val, right)), one);
#else
    v_uint16 rest = words;
    rest = v_select(v_ne(v_and(n, vx_setall_u16(8)), vx_setzero_u16()), v_shr<8>(rest), rest);
    rest = v_select(v_ne(v_and(n, vx_setall_u16(4)), vx_setzero_u16()), v_shr<4>(rest), rest);
    rest = v_select(v_ne(v_and(n, vx_setall_u16(2)), vx_setzero_u16()), v_shr<2>(rest), rest);
    rest = v_select(v_ne(v_and(n, one), vx_setzero_u16()), v_shr<1>(rest), rest);
    return v_and(rest, one);
#endif
}

inline v_uint16 laneNumbers()
{
    ushort numbers[LANES];
    for (int i = 0; i < LANES; ++i)
        numbers[i] = (ushort)i;
    return vx_load(numbers);
}

//! Words of a vector by position: a number of the planes ones, twos, fours ... for each bit.
class BitCounts
{
public:
    enum
    {
        PLANES = 6,
        MOST = 60 //!< vectors until it is full, a multiple of 4
    };
    BitCounts()
    {
        for (int k = 0; k < PLANES; ++k)
            planes_[k] = vx_setzero_u16();
    }
    //! Four vectors: carry-save adders.
    void add(const v_uint16& a, const v_uint16& b, const v_uint16& c, const v_uint16& d)
    {
        v_uint16 twos[2], fours;
        addThree(planes_[0], a, b, twos[0]);
        addThree(planes_[0], c, d, twos[1]);
        addThree(planes_[1], twos[0], twos[1], fours);
        for (int k = 2; k < PLANES; ++k)
        {
            const v_uint16 carry = v_and(planes_[k], fours);
            planes_[k] = v_xor(planes_[k], fours);
            fours = carry;
        }
    }
    //! Adds how often each of the bits around the middle one was set.
    void addTo(int* votes) const
    {
        addBit<0>(votes);
        addBit<1>(votes);
        addBit<2>(votes);
        addBit<3>(votes);
        addBit<4>(votes);
        addBit<5>(votes);
        addBit<6>(votes);
    }

private:
    //! sum becomes the lower bit of sum + a + b, carry the upper one.
    static void addThree(v_uint16& sum, const v_uint16& a, const v_uint16& b, v_uint16& carry)
    {
        const v_uint16 differ = v_xor(sum, a);
        carry = v_or(v_and(sum, a), v_and(differ, b));
        sum = v_xor(differ, b);
    }
    template<int I>
    void addBit(int* votes) const
    {
        const int up = 15 - (PARALLEL_PIXELS / 2 - PARALLEL_REACH + I);
        int sum = 0;
        for (int k = 0; k < PLANES; ++k)
            sum += popcount(v_signmask(v_reinterpret_as_s16(v_shl<up>(planes_[k])))) << k;
        votes[I] += sum;
    }
    static int popcount(int mask)
    {
#if defined __GNUC__
        return __builtin_popcount((unsigned)mask);
#else
        int count = 0;
        for (unsigned rest = (unsigned)mask; rest; rest &= rest - 1)
            ++count;
        return count;
#endif
    }

    v_uint16 planes_[PLANES];
};

//! The words of one column each, turned by d steps of the chord's end: where the pixel of the turned
//! chord is one further, the word is shifted.
class TurnedWords
{
public:
    TurnedWords(const ParallelColumns& columns, int turns)
        : columns_(columns), turns_(turns), modulus_(vx_setall_u16((ushort)columns.modulus)),
          first_(
              v_add_wrap(v_shl<1>(laneNumbers()), vx_setall_u16((ushort)(2 * columns.first + 1))))
    {
    }
    v_uint16 at(int i) const
    {
        v_uint16 word = vx_load(columns_.words + i), rest = vx_load(columns_.rests + i);
        const v_uint16 step = v_add_wrap(first_, vx_setall_u16((ushort)(2 * i)));
        for (int k = 0; k < turns_; ++k)
        {
            rest = v_add_wrap(rest, step);
            const v_uint16 carry = v_eq(v_max(rest, modulus_), rest);
            rest = v_sub_wrap(rest, v_and(modulus_, carry));
            word = v_select(carry, v_shr<1>(word), word);
        }
        for (int k = 0; k > turns_; --k)
        {
            const v_uint16 borrow = v_gt(step, rest);
            rest = v_add_wrap(v_sub_wrap(rest, step), v_and(modulus_, borrow));
            word = v_select(borrow, v_shl<1>(word), word);
        }
        return word;
    }

private:
    const ParallelColumns& columns_;
    const int turns_;
    const v_uint16 modulus_, first_;
};

#endif

} // namespace

void countParallelsOf(const ParallelColumns& columns, int d, int* votes)
{
#if LINESPACE_SIMD
    const TurnedWords words(columns, d);
    for (int i = 0; i < columns.count;)
    {
        const int end = std::min(columns.count, i + BitCounts::MOST * LANES);
        BitCounts counts;
        for (; i < end; i += 4 * LANES)
            counts.add(words.at(i), words.at(i + LANES), words.at(i + 2 * LANES),
                       words.at(i + 3 * LANES));
        counts.addTo(votes);
    }
#else
    countParallelsOneByOne(columns, d, votes);
#endif
}

int countBand(const BandWords& band, const Raster& raster)
{
    const ushort* const words = band.words + (raster.first - band.first);
    const short* const starts = band.starts + (raster.first - band.first);
#if LINESPACE_SIMD
    // A stride's remainder is not negative.
    Stride stride = {raster.step < 0 ? -1 : 0,
                     raster.step < 0 ? raster.step + raster.modulus : raster.step};
    if (stride.remainder == raster.modulus) // a diagonal
    {
        stride.remainder = 0;
        ++stride.quotient;
    }
    const v_uint16 numbers = laneNumbers();
    Positions at = {vx_setall_u16((ushort)raster.minor), vx_setall_u16((ushort)raster.remainder),
                    vx_setall_u16((ushort)raster.modulus)};
    for (int step = 1; step < LANES; step *= 2)
    {
        const v_uint16 isOdd = v_ne(v_and(numbers, vx_setall_u16((ushort)step)), vx_setzero_u16());
        at.add(v_and(vx_setall_u16((ushort)stride.quotient), isOdd),
               v_and(vx_setall_u16((ushort)stride.remainder), isOdd));
        stride = stride.twice(raster.modulus);
    }
    const v_uint16 quotient = vx_setall_u16((ushort)stride.quotient),
                   remainder = vx_setall_u16((ushort)stride.remainder);
    v_uint16 sums = vx_setzero_u16();
    int i = 0;
    for (; i + LANES <= raster.count; i += LANES)
    {
        const v_uint16 bits = bitOf(
            vx_load(words + i), v_sub_wrap(at.minor, v_reinterpret_as_u16(vx_load(starts + i))));
        sums = v_add_wrap(sums, bits);
        at.add(quotient, remainder);
    }
    if (i < raster.count)
    {
        const v_uint16 isIn = v_gt(vx_setall_u16((ushort)(raster.count - i)), numbers);
        const v_uint16 bits = bitOf(
            vx_load(words + i), v_sub_wrap(at.minor, v_reinterpret_as_u16(vx_load(starts + i))));
        sums = v_add_wrap(sums, v_and(bits, isIn));
    }
    return (int)v_reduce_sum(sums);
#else
    int votes = 0, minor = raster.minor, rest = raster.remainder;
    for (int i = 0; i < raster.count; ++i, raster.next(minor, rest))
        votes += words[i] >> (minor - starts[i]) & 1;
    return votes;
#endif
}

#endif // CV_CPU_OPTIMIZATION_DECLARATIONS_ONLY

CV_CPU_OPTIMIZATION_NAMESPACE_END

} // namespace linespace
} // namespace cv
