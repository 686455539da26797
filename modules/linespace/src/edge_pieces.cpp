// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "edge_pieces.hpp"

#include "vectors.hpp"

#include <cstring>

namespace cv {
namespace linespace {

namespace {

const int PARALLEL = EdgePieces::PARALLEL, LENGTH = EdgePieces::LENGTH;
const int MARGIN = EdgePlanes::MARGIN;
static_assert(PARALLEL <= MARGIN, "reads beyond a row");

//! The number of a way by its steps, all 0 or 1, or all 0 or -1.
inline int wayOf(int first, int second, int third)
{
    const int rising = 4 * first + 2 * second + third;
    return rising >= 0 ? rising : 7 - rising;
}

/** Sums along the ways that begin at some pixels, v(k, i) being the pixels i rows below these, k
columns on; calls store(way, sums). */
template<class Values, class Pixels, class Store>
inline void sumWays(Pixels v, Store store)
{
    for (int sign = 1; sign >= -1; sign -= 2)
        for (int first = 0; first < 2; ++first)
        {
            const Values begin = v_add(v(0, 0), v(1, sign * first));
            for (int second = 0; second < 2; ++second)
                for (int third = 0; third < 2; ++third)
                {
                    if (sign < 0 && first + second + third == 0)
                        continue;
                    const int middle = sign * (first + second);
                    const Values end = v_add(v(2, middle), v(3, middle + sign * third));
                    store(wayOf(sign * first, sign * second, sign * third), v_add(begin, end));
                }
        }
}

/** Where the pieces of a family of chords are in the sums: a chord that is at (row + fraction /
2^32) in the first column of a group, and rises by the increment / 2^32 in each, takes one of four
ways, the later the larger its fraction. */
struct Ways
{
    ptrdiff_t offsets[LENGTH]; //!< of the ways
    uint limits[LENGTH - 1];   //!< the k-th way is that of fractions above the k-1 lowest of these

    Ways(int64 increment, ptrdiff_t wayStride)
    {
        // A chord has passed one pixel more after k columns if its fraction is above 2^32 - 1 less
        // that of k increments.
        uint lowest[LENGTH - 1];
        for (int k = 1; k < LENGTH; ++k)
            lowest[k - 1] = limits[k - 1] = ~(uint)(k * increment);
        std::sort(limits, limits + LENGTH - 1);
        for (int which = 0; which < LENGTH; ++which)
        {
            int passed[LENGTH] = {0};
            for (int k = 1; k < LENGTH; ++k)
            {
                const bool carries = which > 0 && lowest[k - 1] <= limits[which - 1];
                passed[k] = (int)(k * increment >> 32) + carries;
            }
            offsets[which] = wayStride * wayOf(passed[1] - passed[0], passed[2] - passed[1],
                                               passed[3] - passed[2]);
        }
    }
};

} // namespace

Size EdgePieces::sizeOf(const Cell& frame, bool isBetweenTopAndBottom)
{
    return isBetweenTopAndBottom ? Size(frame.width, frame.height)
                                 : Size(frame.height, frame.width);
}

double EdgePieces::memory(const Cell& frame, bool isBetweenTopAndBottom)
{
    const Size size = sizeOf(frame, isBetweenTopAndBottom);
    return (double)WAYS * (size.height / LENGTH) * (size.width + MARGIN) + 2 * MARGIN;
}

bool EdgePieces::suits(const EdgePlanes& planes, bool isBetweenTopAndBottom)
{
    const Size size = sizeOf(planes.frame(), isBetweenTopAndBottom);
    return LINESPACE_SIMD128 && !planes.isOriented() && !planes.isWeighted() &&
           std::min(size.width, size.height) >= LEAST_SIDE && size.height <= MOST_COLUMNS &&
           memory(planes.frame(), isBetweenTopAndBottom) < INT_MAX;
}

void EdgePieces::reset(const EdgePlanes& planes, bool isBetweenTopAndBottom)
{
    planes_ = &planes;
    isBetweenTopAndBottom_ = isBetweenTopAndBottom;
    size_ = sizeOf(planes.frame(), isBetweenTopAndBottom);
    plane_ = (isBetweenTopAndBottom ? planes.upright() : planes.transposed())[EdgePlanes::VOTES];
    buffer_.allocate((size_t)memory(planes.frame(), isBetweenTopAndBottom));
    stride_ = size_.width + MARGIN;
    wayStride_ = stride_ * (size_.height / LENGTH);
    std::memset(buffer_.data(), 0, MARGIN);
    sums_ = buffer_.data() + MARGIN;
    parallel_for_(Range(0, size_.height / LENGTH),
                  [this](const Range& range)
                  {
                      for (int group = range.start; group < range.end; ++group)
                          sumRow(group);
                  });
}

#if LINESPACE_SIMD128

void EdgePieces::sumRow(int group)
{
    const uchar* const pixels = plane_.row(LENGTH * group);
    uchar* const out = sums_ + group * stride_;
    for (int x = 0; x < size_.width; x += PARALLEL)
    {
        x = std::min(x, size_.width - PARALLEL); // the last ones overlap those before
        sumWays<v_uint8x16>(
            [=](int k, int i) { return v_load(pixels + k * plane_.stride + x + i); },
            [=](int way, const v_uint8x16& sums) { v_store(out + way * wayStride_ + x, sums); });
    }
    for (int way = 0; way < WAYS; ++way) // for who reads beyond a row
        std::memset(out + way * wayStride_ + size_.width, 0, MARGIN);
}

//! Where a family is at some column.
struct EdgePieces::Walk
{
    int64 position, increment; //!< 2^-32 pixels, of the chord with u = 0
    Ways ways;

    Walk() : position(0), increment(0), ways(0, 0) {}

    //! Where the next groups of columns are in the sums, from the first of them on, rounded up to
    //! four.
    void next(int groups, ptrdiff_t stride, int* offsets)
    {
        const int64 step = LENGTH * increment;
        int rows[4];
        uint fractions[4];
        for (int k = 0; k < 4; ++k)
        {
            rows[k] = (int)((position + k * step) >> 32) + k * (int)stride + (int)ways.offsets[0];
            fractions[k] = (uint)(position + k * step);
        }
        const v_uint32x4 sign = v_setall_u32(0x80000000u); // comparisons are signed
        const auto ordered = [&](const v_uint32x4& values)
        {
            return v_reinterpret_as_s32(v_xor(values, sign));
        };
        v_int32x4 fraction = ordered(v_load(fractions)), place = v_load(rows);
        const v_int32x4 fractionStep = v_setall_s32((int)(4 * step)),
                        placeStep = v_setall_s32((int)(4 * step >> 32) + 4 * (int)stride);
        v_int32x4 limits[LENGTH - 1], farther[LENGTH - 1];
        for (int k = 0; k < LENGTH - 1; ++k)
        {
            limits[k] = ordered(v_setall_u32(ways.limits[k]));
            farther[k] = v_setall_s32((int)(ways.offsets[k + 1] - ways.offsets[k]));
        }
        for (int group = 0; group < groups; group += 4)
        {
            v_int32x4 offset = place;
            for (int k = 0; k < LENGTH - 1; ++k)
                offset = v_add(offset, v_and(v_gt(fraction, limits[k]), farther[k]));
            v_store(offsets + group, offset);
            const v_int32x4 before = fraction;
            fraction = v_add(fraction, fractionStep);
            const v_int32x4 carry = v_gt(before, fraction); // -1 where it has passed 1
            place = v_sub(v_add(place, placeStep), carry);
        }
        position += groups * step;
    }
};

EdgePieces::Walk EdgePieces::walkOf(int difference) const
{
    const Cell& frame = planes_->frame();
    const int u = std::max(0, difference), v = u - difference;
    const int s = frame.firstPoint(isBetweenTopAndBottom_ ? SIDE_TOP : SIDE_RIGHT) + u,
              e = frame.firstPoint(isBetweenTopAndBottom_ ? SIDE_BOTTOM : SIDE_LEFT) + size_.width -
                  1 - v;
    const Chord chord = {s, e};
    const Raster raster(frame, chord);
    Walk walk;
    const bool isExact = raster.fixedPoint(walk.position, walk.increment);
    CV_DbgAssert(isExact && raster.first == 0 && raster.count == size_.height &&
                 raster.xMajor != isBetweenTopAndBottom_);
    CV_UNUSED(isExact);
    walk.position -= (int64)u << 32;
    walk.ways = Ways(walk.increment, wayStride_);
    return walk;
}

namespace {

inline void addBytes(const v_uint8x16& even, const v_uint8x16& odd, int* votes)
{
    v_uint16x8 low[2], high[2];
    v_expand(even, low[0], high[0]);
    v_expand(odd, low[1], high[1]);
    v_uint32x4 quarters[4];
    v_expand(v_add(low[0], low[1]), quarters[0], quarters[1]);
    v_expand(v_add(high[0], high[1]), quarters[2], quarters[3]);
    for (int i = 0; i < 4; ++i)
        v_store(votes + 4 * i, v_add(v_load(votes + 4 * i), v_reinterpret_as_s32(quarters[i])));
}

const int MOST_GROUPS = 124; // until one of two sums of bytes may be full; a multiple of 4

//! Adds what is at the offsets of some groups to the votes of some strips.
template<int STRIPS>
inline void sumStrips(const uchar* sums, const int* starts, const int* offsets, int groups,
                      int* votes)
{
    const uchar* own[STRIPS];
    v_uint8x16 even[STRIPS], odd[STRIPS];
    for (int i = 0; i < STRIPS; ++i)
    {
        own[i] = sums + starts[i];
        even[i] = odd[i] = v_setzero_u8();
    }
    int group = 0;
    for (; group + 4 <= groups; group += 4)
        for (int k = 0; k < 4; k += 2)
        {
            const ptrdiff_t first = offsets[group + k], second = offsets[group + k + 1];
            for (int i = 0; i < STRIPS; ++i)
            {
                even[i] = v_add(even[i], v_load(own[i] + first));
                odd[i] = v_add(odd[i], v_load(own[i] + second));
            }
        }
    for (; group < groups; ++group)
        for (int i = 0; i < STRIPS; ++i)
            (group % 2 ? odd : even)[i] =
                v_add((group % 2 ? odd : even)[i], v_load(own[i] + offsets[group]));
    for (int i = 0; i < STRIPS; ++i)
        addBytes(even[i], odd[i], votes + i * PARALLEL);
}

} // namespace

void EdgePieces::count(const Family* families, int familyCount, const int* starts, int* votes) const
{
    CV_DbgAssert(familyCount <= MOST_FAMILIES);
    Walk walks[MOST_FAMILIES];
    int strips = 0;
    for (int i = 0; i < familyCount; ++i)
    {
        walks[i] = walkOf(families[i].difference);
        strips += families[i].strips;
    }
    std::fill(votes, votes + strips * PARALLEL, 0);
    const int groups = size_.height / LENGTH;
    // All families for some columns, before the cache has forgotten these.
    const int parts = (groups + MOST_GROUPS - 1) / MOST_GROUPS;
    const int most = ((groups + parts - 1) / parts + 3) / 4 * 4;
    CV_DbgAssert(most <= MOST_GROUPS);
    int offsets[MOST_GROUPS];
    for (int first = 0; first < groups; first += most)
    {
        const int now = std::min(most, groups - first);
        const uchar* const sums = sums_ + first * stride_;
        for (int i = 0, strip = 0; i < familyCount; ++i)
        {
            walks[i].next(now, stride_, offsets);
            const int end = strip + families[i].strips;
            for (; strip + 2 <= end; strip += 2)
                sumStrips<2>(sums, starts + strip, offsets, now, votes + strip * PARALLEL);
            for (; strip < end; ++strip)
                sumStrips<1>(sums, starts + strip, offsets, now, votes + strip * PARALLEL);
        }
    }
    for (int i = 0, strip = 0; i < familyCount; ++i)
        for (const int end = strip + families[i].strips; strip < end; ++strip)
            for (int column = LENGTH * groups; column < size_.height; ++column)
            {
                const int64 position =
                    walks[i].position + (column - LENGTH * groups) * walks[i].increment;
                const uchar* const own =
                    plane_.row(column) + (ptrdiff_t)(position >> 32) + starts[strip];
                for (int k = 0; k < PARALLEL; ++k)
                    votes[strip * PARALLEL + k] += own[k];
            }
}

#else

void EdgePieces::sumRow(int)
{
}

void EdgePieces::count(const Family*, int, const int*, int*) const
{
    CV_Error(Error::StsInternal, "suits() is false");
}

#endif

} // namespace linespace
} // namespace cv
