// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "edge_planes.hpp"

#include "transposition.hpp"

#include <cstring>

namespace cv {
namespace linespace {

namespace {

const int BLOCK = 16;                // rows and columns that are transposed at once
const int ROWS_PER_TASK = 4 * BLOCK; // the bytes of a cache line of a transposed row

//! Zeros around an image of a plane, up to the frame and in the margins.
void clearAround(const EdgePlanes::Plane& plane, Size image, Size frame)
{
    std::memset(plane.data - EdgePlanes::MARGIN, 0, EdgePlanes::MARGIN);
    for (int y = 0; y < image.height; ++y)
        std::memset(plane.row(y) + image.width, 0, plane.stride - image.width);
    std::memset(plane.row(image.height), 0, (frame.height - image.height) * plane.stride);
}

void copyRow(const EdgeMap& edges, int plane, int y, uchar* out)
{
    if (plane == EdgePlanes::VOTES)
    {
        std::memcpy(out, edges.votes.ptr<uchar>(y), edges.votes.cols);
        return;
    }
    const ushort* bits = edges.directions.ptr<ushort>(y);
    const int shift = plane == EdgePlanes::LOW_BITS ? 0 : 8;
    for (int x = 0; x < edges.directions.cols; ++x)
        out[x] = (uchar)(bits[x] >> shift);
}

void transposePixels(const EdgePlanes::Plane& from, const Range& rows, const Range& columns,
                     const EdgePlanes::Plane& to)
{
    for (int x = columns.start; x < columns.end; ++x)
        for (int y = rows.start; y < rows.end; ++y)
            to.row(x)[y] = from.row(y)[x];
}

void transposeRows(const EdgePlanes::Plane& from, const Range& rows, int width,
                   const EdgePlanes::Plane& to)
{
    int y = rows.start, x = 0;
#if LINESPACE_SIMD128
    for (; x + BLOCK <= width; x += BLOCK)
        for (y = rows.start; y + BLOCK <= rows.end; y += BLOCK)
        {
            v_uint8x16 block[BLOCK];
            for (int i = 0; i < BLOCK; ++i)
                block[i] = v_load(from.row(y + i) + x);
            transposeBytes(block);
            for (int i = 0; i < BLOCK; ++i)
                v_store(to.row(x + i) + y, block[i]);
        }
#endif
    transposePixels(from, Range(rows.start, y), Range(x, width), to);
    transposePixels(from, Range(y, rows.end), Range(0, width), to);
}

} // namespace

double EdgePlanes::memory(const Cell& frame, bool weighted, bool oriented)
{
    const double w = frame.width, h = frame.height;
    const double plane = (w + MARGIN) * h + (h + MARGIN) * w + 2 * MARGIN;
    return plane * ((oriented ? 2 : 0) + (weighted || !oriented ? 1 : 0));
}

void EdgePlanes::clear()
{
    buffer_.release();
    oriented_ = weighted_ = false;
}

//! Of one of the planes, upright or transposed; the last row has a margin behind it as well.
size_t EdgePlanes::planeBytes(int copy) const
{
    const size_t width = copy == 0 ? frame_.width : frame_.height,
                 height = copy == 0 ? frame_.height : frame_.width;
    return (width + MARGIN) * height + MARGIN;
}

size_t EdgePlanes::bytes() const
{
    return (has(VOTES) + has(LOW_BITS) + has(HIGH_BITS)) * (planeBytes(0) + planeBytes(1));
}

void EdgePlanes::layOut()
{
    buffer_.allocate(bytes());
    uchar* next = buffer_.data();
    for (int copy = 0; copy < 2; ++copy)
        for (int i = 0; i < PLANES; ++i)
        {
            planes_[copy][i] = Plane();
            if (has(i))
            {
                planes_[copy][i].data = next + MARGIN;
                planes_[copy][i].stride = (copy == 0 ? frame_.width : frame_.height) + MARGIN;
                next += planeBytes(copy);
            }
        }
}

void EdgePlanes::reset(const EdgeMap& edges, const Cell& frame)
{
    frame_ = frame;
    oriented_ = edges.isOriented();
    weighted_ = edges.weighted;
    layOut();
    const Size image = edges.votes.size();
    for (int i = 0; i < PLANES; ++i)
    {
        if (!has(i))
            continue;
        const Plane &upright = planes_[0][i], &transposed = planes_[1][i];
        clearAround(upright, image, Size(frame.width, frame.height));
        clearAround(transposed, Size(image.height, image.width), Size(frame.height, frame.width));
        parallel_for_(Range(0, (image.height + ROWS_PER_TASK - 1) / ROWS_PER_TASK),
                      [&](const Range& range)
                      {
                          const Range rows(range.start * ROWS_PER_TASK,
                                           std::min(image.height, range.end * ROWS_PER_TASK));
                          for (int y = rows.start; y < rows.end; ++y)
                              copyRow(edges, i, y, upright.row(y));
                          transposeRows(upright, rows, image.width, transposed);
                      });
    }
}

void EdgePlanes::copyTo(EdgePlanes& other) const
{
    other.frame_ = frame_;
    other.oriented_ = oriented_;
    other.weighted_ = weighted_;
    other.layOut();
    std::memcpy(other.buffer_.data(), buffer_.data(), bytes());
}

void EdgePlanes::remove(Point pixel)
{
    for (int i = 0; i < PLANES; ++i)
        if (has(i))
        {
            upright()[i].row(pixel.y)[pixel.x] = 0;
            transposed()[i].row(pixel.x)[pixel.y] = 0;
        }
}

} // namespace linespace
} // namespace cv
