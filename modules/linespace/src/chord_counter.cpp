// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "chord_counter.hpp"

namespace cv {
namespace linespace {

namespace {

/** The sum of vote(index of the pixel) over a raster, in rows of `stride`. Four sums at a time, as
none has to wait for the others. */
template<class Vote>
int sumAlong(const Raster& raster, ptrdiff_t stride, Vote vote)
{
    int64 row, increment;
    if (!raster.fixedPoint(row, increment))
    {
        int sum = 0;
        raster.forEachPixel([&](int x, int y)
                            { sum += vote(raster.xMajor ? y * stride + x : x * stride + y); });
        return sum;
    }
    int sums[4] = {0, 0, 0, 0};
    ptrdiff_t column = raster.first;
    const ptrdiff_t end = column + raster.count;
    for (; column + 4 <= end; column += 4, row += 4 * increment)
        for (int k = 0; k < 4; ++k)
            sums[k] += vote((ptrdiff_t)((row + k * increment) >> 32) * stride + column + k);
    for (; column < end; ++column, row += increment)
        sums[0] += vote((ptrdiff_t)(row >> 32) * stride + column);
    return sums[0] + sums[1] + sums[2] + sums[3];
}

} // namespace

int ChordCounter::votes(Chord chord) const
{
    const Raster raster(frame_, chord);
    const EdgePlanes::Plane* const planes = planes_.along(raster.xMajor);
    if (!planes_.isOriented())
    {
        const uchar* const values = planes[EdgePlanes::VOTES].row(0);
        return sumAlong(raster, planes[EdgePlanes::VOTES].stride,
                        [=](ptrdiff_t pixel) { return values[pixel]; });
    }
    const int bin = directionBin(frame_, chord), shift = bin % 8;
    const EdgePlanes::Plane& own = planes[EdgePlanes::planeOf(bin)];
    const uchar* const bits = own.row(0);
    if (!planes_.isWeighted())
        return sumAlong(raster, own.stride,
                        [=](ptrdiff_t pixel) { return bits[pixel] >> shift & 1; });
    const uchar* const values = planes[EdgePlanes::VOTES].row(0);
    return sumAlong(raster, own.stride,
                    [=](ptrdiff_t pixel) { return (bits[pixel] >> shift & 1) * values[pixel]; });
}

int ChordCounter::voteAcross(const EdgePlanes::Plane* planes, int column, int minor, int bin) const
{
    if (planes_.isOriented() &&
        !(planes[EdgePlanes::planeOf(bin)].row(column)[minor] & EdgePlanes::bitOf(bin)))
        return 0;
    return planes_.has(EdgePlanes::VOTES) ? planes[EdgePlanes::VOTES].row(column)[minor] : 1;
}

int ChordCounter::pixels(Chord chord) const
{
    const Raster raster(frame_, chord);
    const EdgePlanes::Plane* const planes = planes_.across(raster.xMajor);
    const int bin = planes_.isOriented() ? directionBin(frame_, chord) : 0;
    int count = 0;
    raster.forEachPixel(
        [&](int x, int y)
        {
            const int column = raster.xMajor ? x : y, minor = raster.xMajor ? y : x;
            count += voteAcross(planes, column, minor, bin) != 0;
        });
    return count;
}

} // namespace linespace
} // namespace cv
