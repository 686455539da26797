// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// ChordCounter::countParallel: one load of 16 pixels and one add per pixel of the raster.

#include "chord_counter.hpp"
#include "vectors.hpp"

namespace cv {
namespace linespace {

namespace {

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

static_assert((int)ChordCounter::PARALLEL <= (int)EdgePlanes::MARGIN, "reads beyond a row");

#if LINESPACE_SIMD128

void addBytes(const v_uint8x16& sums, int* votes)
{
    uchar bytes[ChordCounter::PARALLEL];
    v_store(bytes, sums);
    for (int i = 0; i < ChordCounter::PARALLEL; ++i)
        votes[i] += bytes[i];
}

void addShorts(const v_uint16x8& low, const v_uint16x8& high, int* votes)
{
    ushort shorts[ChordCounter::PARALLEL];
    v_store(shorts, low);
    v_store(shorts + 8, high);
    for (int i = 0; i < ChordCounter::PARALLEL; ++i)
        votes[i] += shorts[i];
}

//! Of an oriented map, the pixels that have the bit.
template<bool IsOriented>
inline v_uint8x16 voting(const v_uint8x16& values, const uchar* bits, const v_uint8x16& bit)
{
    return IsOriented ? values & ((v_load(bits) & bit) == bit) : values;
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
            low = low + first;
            high = high + second;
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
        even = even + next();
        odd = odd + next();
        even = even + next();
        odd = odd + next();
    }
    for (; count > 0; --count)
        even = even + next();
    addBytes(even + odd, votes);
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
        for (int i = 0; i < ChordCounter::PARALLEL; ++i)
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

//! A chord on its way: what sumParallel needs to go on.
struct ChordCounter::ParallelWalk
{
    Steps steps;
    int left; //!< pixels
    const uchar *values, *bits;
    uchar bit;
};

void ChordCounter::countParallel(const ParallelChords* chords, int count, int* votes) const
{
    CV_DbgAssert(count <= MOST_PARALLEL);
    ParallelWalk walks[MOST_PARALLEL];
    int longest = 0;
    std::fill(votes, votes + count * PARALLEL, 0);
    for (int i = 0; i < count; ++i)
    {
        walks[i].left = 0;
        if (!startParallel(chords[i], walks[i]))
            countOneByOne(chords[i], votes + i * PARALLEL);
        longest = std::max(longest, walks[i].left);
    }
    const bool oriented = planes_.isOriented(), weighted = planes_.isWeighted();
    const auto sum = oriented ? (weighted ? sumParallel<true, true> : sumParallel<false, true>)
                              : (weighted ? sumParallel<true, false> : sumParallel<false, false>);
    // All of them for some columns, before the cache has forgotten these.
    const int columns = 128;
    for (int done = 0; done < longest; done += columns)
        for (int i = 0; i < count; ++i)
        {
            ParallelWalk& walk = walks[i];
            const int now = std::min(columns, walk.left);
            if (now <= 0) // not started, or done
                continue;
            sum(walk.steps, now, walk.values, walk.bits, walk.bit, votes + i * PARALLEL);
            walk.left -= now;
        }
}

bool ChordCounter::startParallel(const ParallelChords& chords, ParallelWalk& walk) const
{
    const Chord chord = chords.chord;
    const bool downwards = frame_.sideOf(chord.s) == SIDE_TOP;
    CV_DbgAssert(frame_.sideOf(chord.e) == frame_.sideOf(chord.s) + 2);
    const Raster raster(frame_, chord);
    if (!raster.fixedPoint(walk.steps.minor, walk.steps.increment))
        return false;
    // From the top, s + 1 is one to the right; from the right, one down.
    const EdgePlanes::Plane* const planes = downwards ? planes_.upright() : planes_.transposed();
    const int bin = planes_.isOriented() ? directionBin(frame_, chord) : 0;
    const EdgePlanes::Plane* const own =
        planes_.isOriented() ? &planes[EdgePlanes::planeOf(bin)] : 0;
    const ptrdiff_t stride = planes[own ? EdgePlanes::LOW_BITS : EdgePlanes::VOTES].stride;
    const bool alongRows = raster.xMajor == downwards;
    walk.steps.majorStride = alongRows ? 1 : stride;
    walk.steps.minorStride = alongRows ? stride : 1;
    walk.steps.major = raster.first * walk.steps.majorStride;
    walk.left = raster.count;
    walk.values =
        planes_.has(EdgePlanes::VOTES) ? planes[EdgePlanes::VOTES].row(0) - chords.before : 0;
    walk.bits = own ? own->row(0) - chords.before : 0;
    walk.bit = EdgePlanes::bitOf(bin);
    return true;
}

void ChordCounter::countOneByOne(const ParallelChords& chords, int* votes) const
{
    const Chord chord = chords.chord;
    for (int i = 0; i < PARALLEL; ++i)
    {
        const Chord one = {chord.s + i - chords.before, chord.e - i + chords.before};
        if (one.s >= 0 && one.e < frame_.borderCount() &&
            frame_.sideOf(one.s) == frame_.sideOf(chord.s) &&
            frame_.sideOf(one.e) == frame_.sideOf(chord.e))
            votes[i] = this->votes(one);
    }
}

} // namespace linespace
} // namespace cv
