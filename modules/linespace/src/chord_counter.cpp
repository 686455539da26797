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

double ChordCounter::memory(const Cell& frame, bool weighted, bool oriented)
{
    const double w = frame.width, h = frame.height;
    const double plane = (w + MARGIN) * h + (h + MARGIN) * w + 2 * MARGIN;
    return plane * ((oriented ? 2 : 0) + (weighted || !oriented ? 1 : 0));
}

void ChordCounter::clear()
{
    for (int i = 0; i < PLANES; ++i)
    {
        upright_[i].buffer.release();
        transposed_[i].buffer.release();
    }
}

void ChordCounter::reset(const EdgeMap& edges, const Cell& frame)
{
    frame_ = frame;
    oriented_ = edges.isOriented();
    weighted_ = edges.weighted;
    const Size image = edges.votes.size();
    for (int i = 0; i < PLANES; ++i)
    {
        if (!uses(i))
            continue;
        Plane* const planes[2] = {&upright_[i], &transposed_[i]};
        const int widths[2] = {frame.width, frame.height}, heights[2] = {frame.height, frame.width};
        Mat inner[2];
        for (int k = 0; k < 2; ++k)
        {
            Plane& plane = *planes[k];
            plane.stride = (ptrdiff_t)widths[k] + MARGIN;
            const size_t size = plane.stride * heights[k] + MARGIN;
            plane.buffer.allocate(size);
            std::fill(plane.buffer.data(), plane.buffer.data() + size, (uchar)0);
            inner[k] = Mat(k == 0 ? image.height : image.width, k == 0 ? image.width : image.height,
                           CV_8UC1, plane.row(0), plane.stride);
        }
        if (i == VOTES)
            edges.votes.copyTo(inner[0]);
        else
            for (int y = 0; y < image.height; ++y)
            {
                const ushort* bits = edges.directions.ptr<ushort>(y);
                uchar* out = upright_[i].row(y);
                for (int x = 0; x < image.width; ++x)
                    out[x] = (uchar)(i == LOW_BITS ? bits[x] : bits[x] >> 8);
            }
        transpose(inner[0], inner[1]);
    }
}

int ChordCounter::votes(Chord chord) const
{
    const Raster raster(frame_, chord);
    const Plane* const planes = raster.xMajor ? upright_ : transposed_;
    if (!oriented_)
    {
        const uchar* const values = planes[VOTES].row(0);
        return sumAlong(raster, planes[VOTES].stride,
                        [=](ptrdiff_t pixel) { return values[pixel]; });
    }
    const int bin = directionBin(frame_, chord), shift = bin % 8;
    const Plane& own = planes[bin < 8 ? LOW_BITS : HIGH_BITS];
    const uchar* const bits = own.row(0);
    if (!weighted_)
        return sumAlong(raster, own.stride,
                        [=](ptrdiff_t pixel) { return bits[pixel] >> shift & 1; });
    const uchar* const values = planes[VOTES].row(0);
    return sumAlong(raster, own.stride,
                    [=](ptrdiff_t pixel) { return (bits[pixel] >> shift & 1) * values[pixel]; });
}

void ChordCounter::remove(Point pixel)
{
    for (int i = 0; i < PLANES; ++i)
        if (uses(i))
        {
            upright_[i].row(pixel.y)[pixel.x] = 0;
            transposed_[i].row(pixel.x)[pixel.y] = 0;
        }
}

} // namespace linespace
} // namespace cv
