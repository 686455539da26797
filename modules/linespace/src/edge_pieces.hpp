// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Sums of four edge pixels along every straight piece of four columns, and with them the exact
// votes of many parallel chords between opposite sides.
//
// Why this is faster than pixel by pixel: within four columns a chord takes one of 15 ways, so a
// table of the sums along these, made once for a map, saves three of four reads; and chords
// between opposite sides that are parallel have the same raster, shifted, so 16 of them are read
// at once and all of a family take the same ways, which are found once.

#ifndef OPENCV_LINESPACE_EDGE_PIECES_HPP
#define OPENCV_LINESPACE_EDGE_PIECES_HPP

#include "edge_planes.hpp"

namespace cv {
namespace linespace {

/** The sums for chords between one pair of opposite sides, of maps without weights or directions.
Columns are what such a chord passes from side to side, rows of the planes here; it must be no
shorter along them than across. */
class EdgePieces
{
public:
    enum
    {
        PARALLEL = 16, //!< chords that are counted like one
        LENGTH = 4,    //!< columns of a piece
        WAYS = 15,     //!< from one pixel to four columns on, by steps of 0 or 1, or 0 or -1
        LEAST_SIDE = 16,
        MOST_COLUMNS = 32768 //!< for Raster::fixedPoint
    };

    EdgePieces() : planes_(0), isBetweenTopAndBottom_(false), sums_(0), stride_(0), wayStride_(0) {}

    //! Whether chords between these sides can be counted so.
    static bool suits(const EdgePlanes& planes, bool isBetweenTopAndBottom);
    //! Makes the tables. Memory is kept from call to call; the planes must outlive the use.
    void reset(const EdgePlanes& planes, bool isBetweenTopAndBottom);
    void clear() { buffer_.release(); }
    //! Bytes that reset() allocates.
    static double memory(const Cell& frame, bool isBetweenTopAndBottom);

    /** Chords with equal u - v, where u and v are the positions of s and e along their sides, v
    counted the other way: less than the sides' length in size, and than the number of columns. */
    struct Family
    {
        int difference;
        int strips; //!< of PARALLEL chords with consecutive u
    };
    /** Votes of strips, the first ones those of the first family, and so on.
    @param starts least u of each; one of the chords at least must not leave the sides.
    @param votes PARALLEL for each; those of chords that leave the sides have no meaning. */
    void count(const Family* families, int familyCount, const int* starts, int* votes) const;

    enum
    {
        MOST_FAMILIES = 16 //!< at once, best next to each other
    };

private:
    static Size sizeOf(const Cell& frame, bool isBetweenTopAndBottom);
    void sumRow(int group);
    struct Walk;
    Walk walkOf(int difference) const;

    const EdgePlanes* planes_;
    bool isBetweenTopAndBottom_;
    Size size_; //!< pixels across the columns, and columns
    EdgePlanes::Plane plane_;
    Buffer buffer_;
    uchar* sums_; //!< [way][group of columns][pixel across]
    ptrdiff_t stride_, wayStride_;
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_EDGE_PIECES_HPP
