// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "edge_planes.hpp"

#include <cstring>

namespace cv {
namespace linespace {

double EdgePlanes::memory(const Cell& frame, bool weighted, bool oriented)
{
    const double w = frame.width, h = frame.height;
    const double plane = (w + MARGIN) * h + (h + MARGIN) * w + 2 * MARGIN;
    return plane * ((oriented ? 2 : 0) + (weighted || !oriented ? 1 : 0));
}

void EdgePlanes::clear()
{
    buffer_.release();
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
        Mat inner[2];
        for (int copy = 0; copy < 2; ++copy)
        {
            const Plane& plane = planes_[copy][i];
            std::memset(plane.data - MARGIN, 0, planeBytes(copy));
            inner[copy] =
                Mat(copy == 0 ? image.height : image.width, copy == 0 ? image.width : image.height,
                    CV_8UC1, plane.data, plane.stride);
        }
        if (i == VOTES)
            edges.votes.copyTo(inner[0]);
        else
            for (int y = 0; y < image.height; ++y)
            {
                const ushort* bits = edges.directions.ptr<ushort>(y);
                uchar* out = upright()[i].row(y);
                for (int x = 0; x < image.width; ++x)
                    out[x] = (uchar)(i == LOW_BITS ? bits[x] : bits[x] >> 8);
            }
        transpose(inner[0], inner[1]);
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
