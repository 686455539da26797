// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// ChordCounter::countParallel: one load of 16 pixels and one add per pixel of the raster.

#include "chord_counter.hpp"
#include "vectors.hpp"

namespace cv {
namespace linespace {

namespace {

const int PARALLEL = ChordCounter::PARALLEL;
const int MOST_STEPS = 252; // pixels until a sum of bytes, or of weights in shorts, may be full

//! The pixels of a raster, as offsets from the first pixel of a plane.
struct Steps
{
    ptrdiff_t major, majorStride, minorStride;
    int64 minor, increment;

    ptrdiff_t next()
    {
        const ptrdiff_t pixel = major + (ptrdiff_t)(minor >> 32) * minorStride;
        major += majorStride;
        minor += increment;
        return pixel;
    }
};

//! Those that cross the rows of the plane: all, in a frame as high as wide. No multiplication.
struct StepsAcross : Steps
{
    explicit StepsAcross(const Steps& steps) : Steps(steps) {}

    ptrdiff_t next()
    {
        const ptrdiff_t pixel = major + (ptrdiff_t)(minor >> 32);
        major += majorStride;
        minor += increment;
        return pixel;
    }
};

static_assert(PARALLEL <= (int)EdgePlanes::MARGIN, "reads beyond a row");

#if LINESPACE_SIMD128

void addBytes(const v_uint8x16& sums, int* votes)
{
    uchar bytes[PARALLEL];
    v_store(bytes, sums);
    for (int i = 0; i < PARALLEL; ++i)
        votes[i] += bytes[i];
}

void addShorts(const v_uint16x8& low, const v_uint16x8& high, int* votes)
{
    ushort shorts[PARALLEL];
    v_store(shorts, low);
    v_store(shorts + 8, high);
    for (int i = 0; i < PARALLEL; ++i)
        votes[i] += shorts[i];
}

//! Of an oriented map, the pixels that have the bit.
template<bool IsOriented>
inline v_uint8x16 voting(const v_uint8x16& values, const uchar* bits, const v_uint8x16& bit)
{
    return IsOriented ? v_and(values, v_eq(v_and(v_load(bits), bit), bit)) : values;
}

/** Adds what `count` pixels say, and goes on by as many: 255 at most without weights, 257 with.
Without weights every pixel of `values` that is read is 0 or 1; of an oriented map there are no
values then, as pixels that do not vote have no bits. */
template<bool IsWeighted, bool IsOriented, class AnySteps>
void sumParallelBy(AnySteps& allSteps, int count, const uchar* values, const uchar* bits,
                   uchar ownBit, int* votes)
{
    AnySteps steps = allSteps; // in registers
    const v_uint8x16 bit = v_setall_u8(ownBit), one = v_setall_u8(1);
    if (IsWeighted)
    {
        v_uint16x8 low = v_setzero_u16(), high = low;
        for (; count > 0; --count)
        {
            const ptrdiff_t pixel = steps.next();
            v_uint16x8 first, second;
            v_expand(voting<IsOriented>(v_load(values + pixel), bits + pixel, bit), first, second);
            low = v_add(low, first);
            high = v_add(high, second);
        }
        addShorts(low, high, votes);
        allSteps = steps;
        return;
    }
    const auto next = [&]()
    {
        const ptrdiff_t pixel = steps.next();
        return IsOriented ? voting<true>(one, bits + pixel, bit) : v_load(values + pixel);
    };
    v_uint8x16 even = v_setzero_u8(), odd = even;
    for (; count >= 4; count -= 4)
    {
        even = v_add(even, next());
        odd = v_add(odd, next());
        even = v_add(even, next());
        odd = v_add(odd, next());
    }
    for (; count > 0; --count)
        even = v_add(even, next());
    addBytes(v_add(even, odd), votes);
    allSteps = steps;
}

#else

template<bool IsWeighted, bool IsOriented, class AnySteps>
void sumParallelBy(AnySteps& allSteps, int count, const uchar* values, const uchar* bits,
                   uchar ownBit, int* votes)
{
    for (; count > 0; --count)
    {
        const ptrdiff_t pixel = allSteps.next();
        for (int i = 0; i < PARALLEL; ++i)
            if (!IsOriented || (bits[pixel + i] & ownBit))
                votes[i] += IsOriented && !IsWeighted ? 1 : values[pixel + i];
    }
}

#endif

template<bool IsWeighted, bool IsOriented>
void sumParallel(Steps& steps, int count, const uchar* values, const uchar* bits, uchar ownBit,
                 int* votes)
{
    if (steps.minorStride != 1)
        return sumParallelBy<IsWeighted, IsOriented>(steps, count, values, bits, ownBit, votes);
    StepsAcross across(steps);
    sumParallelBy<IsWeighted, IsOriented>(across, count, values, bits, ownBit, votes);
    steps = across;
}

} // namespace

/** Votes of the chords (s + i, e - i), i = 0 to PARALLEL - 1, of one between opposite sides, s < e:
they are parallel, and their rasters are the chord's, shifted by i pixels. What is said of chords
that would leave the two sides has no meaning. False if the chord is too long for it. */
bool ChordCounter::countParallel(Chord chord, int* votes) const
{
    const bool downwards = frame_.sideOf(chord.s) == SIDE_TOP;
    CV_DbgAssert(frame_.sideOf(chord.e) == frame_.sideOf(chord.s) + 2);
    const Raster raster(frame_, chord);
    Steps steps;
    if (!raster.fixedPoint(steps.minor, steps.increment))
        return false;
    // From the top, s + 1 is one to the right; from the right, one down.
    const EdgePlanes::Plane* const planes = downwards ? planes_.upright() : planes_.transposed();
    const bool oriented = planes_.isOriented(), weighted = planes_.isWeighted();
    const int bin = oriented ? directionBin(frame_, chord) : 0;
    const EdgePlanes::Plane* const own = oriented ? &planes[EdgePlanes::planeOf(bin)] : 0;
    const ptrdiff_t stride = planes[own ? EdgePlanes::LOW_BITS : EdgePlanes::VOTES].stride;
    const bool alongRows = raster.xMajor == downwards;
    steps.majorStride = alongRows ? 1 : stride;
    steps.minorStride = alongRows ? stride : 1;
    steps.major = raster.first * steps.majorStride;
    const uchar* const values =
        planes_.has(EdgePlanes::VOTES) ? planes[EdgePlanes::VOTES].row(0) : 0;
    const uchar* const bits = own ? own->row(0) : 0;
    const auto sum = oriented ? (weighted ? sumParallel<true, true> : sumParallel<false, true>)
                              : (weighted ? sumParallel<true, false> : sumParallel<false, false>);
    std::fill(votes, votes + PARALLEL, 0);
    for (int left = raster.count; left > 0; left -= MOST_STEPS)
        sum(steps, std::min<int>(left, MOST_STEPS), values, bits, EdgePlanes::bitOf(bin), votes);
    return true;
}

} // namespace linespace
} // namespace cv
