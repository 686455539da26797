// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// A copy of the edge map that is read along and across lines of any slope.

#ifndef OPENCV_LINESPACE_EDGE_PLANES_HPP
#define OPENCV_LINESPACE_EDGE_PLANES_HPP

#include "stages.hpp"

namespace cv {
namespace linespace {

/** An edge map in planes of one byte per pixel, padded with zeros to the frame, so that no chord
needs clipping, and kept with x and y exchanged as well, so that lines of any slope run along rows
or across them as suits. Pixels can be taken out. */
class EdgePlanes
{
public:
    //! Votes where they are needed, and the low and high byte of an oriented map's bits, which are
    //! 0 where a pixel does not vote.
    enum
    {
        VOTES,
        LOW_BITS,
        HIGH_BITS,
        PLANES
    };
    enum
    {
        MARGIN = 16 //!< bytes of zeros around each row, for who reads more than a pixel at once
    };
    struct Plane
    {
        uchar* data;
        ptrdiff_t stride;
        Plane() : data(0), stride(0) {}
        uchar* row(int y) const { return data + y * stride; }
    };

    EdgePlanes() : oriented_(false), weighted_(false) {}

    //! Copies the map. Memory is kept from call to call.
    void reset(const EdgeMap& edges, const Cell& frame);
    void copyTo(EdgePlanes& other) const;
    void clear();
    //! Bytes that reset() and copyTo() allocate.
    static double memory(const Cell& frame, bool weighted, bool oriented);

    const Cell& frame() const { return frame_; }
    bool isOriented() const { return oriented_; }
    bool isWeighted() const { return weighted_; }
    bool has(int plane) const { return plane == VOTES ? weighted_ || !oriented_ : oriented_; }

    //! Where a bin of an oriented map has its bits.
    static int planeOf(int bin) { return bin < 8 ? LOW_BITS : HIGH_BITS; }
    static uchar bitOf(int bin) { return (uchar)(1 << bin % 8); }

    //! The planes whose rows are the image's rows, or its columns.
    const Plane* upright() const { return planes_[0]; }
    const Plane* transposed() const { return planes_[1]; }
    //! Those whose rows run along lines of a major axis, or across: one for each of its columns.
    const Plane* along(bool xMajor) const { return planes_[!xMajor]; }
    const Plane* across(bool xMajor) const { return planes_[xMajor]; }

    //! Takes out an edge pixel.
    void remove(Point pixel);

private:
    size_t planeBytes(int copy) const;
    //! Of all planes, upright and transposed.
    size_t bytes() const;
    void layOut();

    Cell frame_;
    bool oriented_, weighted_;
    Buffer buffer_;
    Plane planes_[2][PLANES]; //!< upright and transposed
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_EDGE_PLANES_HPP
