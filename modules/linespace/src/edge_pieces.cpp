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
            const Values begin = v(0, 0) + v(1, sign * first);
            for (int second = 0; second < 2; ++second)
                for (int third = 0; third < 2; ++third)
                {
                    if (sign < 0 && first + second + third == 0)
                        continue;
                    const int middle = sign * (first + second);
                    store(wayOf(sign * first, sign * second, sign * third),
                          begin + (v(2, middle) + v(3, middle + sign * third)));
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
    plane_ =
        (isBetweenTopAndBottom ? planes.upright() : planes.transposed())[EdgePlanes::VOTES];
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
        sumWays<v_uint8x16>([=](int k, int i) { return v_load(pixels + k * plane_.stride + x + i); },
                            [=](int way, const v_uint8x16& sums)
                            { v_store(out + way * wayStride_ + x, sums); });
    }
    for (int way = 0; way < WAYS; ++way) // for who reads beyond a row
        std::memset(out + way * wayStride_ + size_.width, 0, MARGIN);
}

void EdgePieces::count(int difference, const int* starts, int strips, int* votes) const
{
    const Cell& frame = planes_->frame();
    const int u = std::max(0, difference), v = u - difference;
    const int s = frame.firstPoint(isBetweenTopAndBottom_ ? SIDE_TOP : SIDE_RIGHT) + u,
              e = frame.firstPoint(isBetweenTopAndBottom_ ? SIDE_BOTTOM : SIDE_LEFT) +
                  size_.width - 1 - v;
    const Chord chord = {s, e};
    const Raster raster(frame, chord);
    int64 position, increment;
    const bool isExact = raster.fixedPoint(position, increment);
    CV_DbgAssert(isExact && raster.first == 0 && raster.count == size_.height &&
                 raster.xMajor != isBetweenTopAndBottom_);
    CV_UNUSED(isExact);
    position -= (int64)u << 32; // of u = 0

    std::fill(votes, votes + strips * PARALLEL, 0);
    const Ways ways(increment, wayStride_);
    const int groups = size_.height / LENGTH;
    const int MOST_GROUPS = 60; // until a byte may be full; a multiple of 4
    ptrdiff_t offsets[MOST_GROUPS];
    for (int first = 0; first < groups; first += MOST_GROUPS)
    {
        const int count = std::min(MOST_GROUPS, groups - first);
        const uchar* const sums = sums_ + first * stride_;
        for (int group = 0; group < count; ++group, position += LENGTH * increment)
        {
            const uint fraction = (uint)position;
            const int which = (fraction > ways.limits[0]) + (fraction > ways.limits[1]) +
                              (fraction > ways.limits[2]);
            offsets[group] = ways.offsets[which] + group * stride_ + (ptrdiff_t)(position >> 32);
        }
        for (int strip = 0; strip < strips; ++strip)
        {
            const uchar* const own = sums + starts[strip];
            v_uint8x16 even = v_setzero_u8(), odd = even;
            int group = 0;
            for (; group + 2 <= count; group += 2)
            {
                even = even + v_load(own + offsets[group]);
                odd = odd + v_load(own + offsets[group + 1]);
            }
            if (group < count)
                even = even + v_load(own + offsets[group]);
            uchar bytes[PARALLEL];
            v_store(bytes, even + odd);
            for (int i = 0; i < PARALLEL; ++i)
                votes[strip * PARALLEL + i] += bytes[i];
        }
    }
    for (int column = LENGTH * groups; column < size_.height; ++column, position += increment)
        for (int strip = 0; strip < strips; ++strip)
        {
            const uchar* const own =
                plane_.row(column) + (ptrdiff_t)(position >> 32) + starts[strip];
            for (int i = 0; i < PARALLEL; ++i)
                votes[strip * PARALLEL + i] += own[i];
        }
}

#else

void EdgePieces::sumRow(int) {}

void EdgePieces::count(int, const int*, int, int*) const
{
    CV_Error(Error::StsInternal, "suits() is false");
}

#endif

} // namespace linespace
} // namespace cv
