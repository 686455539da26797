// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The geometry of the cascade of strips, in integers (doc/algorithm.md, section 3b): families,
// strips, the crossings of a chord with the strips' sides, bundles, and which chord of the image a
// chord of a family is.

#ifndef OPENCV_LINESPACE_STRIP_PLAN_HPP
#define OPENCV_LINESPACE_STRIP_PLAN_HPP

#include "../plan.hpp"

namespace cv {
namespace linespace {

enum
{
    STRIP = 64,      //!< columns of a strip
    LEAF_BUNDLE = 4, //!< side of the bundles of one strip
    FINE_BUNDLE = 8, //!< side of the bundles whose chords are counted one by one
    MOST_BUNDLE = 64 //!< side of the largest bundles
};

//! The quotient of integers rounded down, divisor > 0.
inline int64 floorDiv(int64 a, int64 b)
{
    const int64 quotient = a / b;
    return quotient - (a % b < 0);
}

//! The same rounded up.
inline int64 ceilDiv(int64 a, int64 b)
{
    return -floorDiv(-a, b);
}

/** The chords that are not steeper than a diagonal, seen along the major axis: "columns" are those
of the image if that is x, else its rows. The strips cover columns 0 to width() - 1, of which those
from `length` on are beyond the image and 0. */
struct StripFamily
{
    bool xMajor;
    int length; //!< columns of the image
    int across; //!< pixels of a column
    int strips;

    StripFamily() : xMajor(true), length(0), across(0), strips(0) {}
    StripFamily(Size image, bool isXMajor);
    int width() const { return strips * STRIP; }

    //! Where the chord (y, t) crosses the side between strip i - 1 and strip i: the border point nearest
    //! to y + t i / strips, of two the larger, is y + crossing(t, i).
    int crossing(int t, int i) const
    {
        return (int)floorDiv(2 * (int64)t * i + strips, 2 * (int64)strips);
    }

    //! The columns of the image that the chord (y, t) has a pixel of the image in, or one more.
    int visibleColumns(int y, int t) const;

    /** The chord of the image nearest to the chord (y, t), from (0, y + 1/2) to (width(), y + t +
    1/2): its ends are the border edges through which that leaves the image.
    @return false if it misses the image, or two ends are on one side. */
    bool imageChord(int y, int t, Chord& chord) const;
};

/** Bundles of chords of a node, a run of strips: bundle (T, Y) holds the chords (y, t), y = side Y
... side Y + side - 1 and t likewise. T runs from -reach to reach - 1, Y from first(T) to end(T) -
1. */
struct BundleGrid
{
    int side, reach, across; //!< across: bundles of a column of the image, rounded up
    BundleGrid() : side(0), reach(0), across(0) {}
    BundleGrid(const StripFamily& family, int strips, int bundleSide)
        : side(bundleSide), reach(strips * STRIP / bundleSide),
          across((family.across + bundleSide - 1) / bundleSide)
    {
    }
    int first(int T) const { return -std::max(T + 1, 0); }
    int end(int T) const { return across + std::max(-T, 0); }
};

//! The side of the bundles of a node of so many strips: they grow with its width, which keeps the
//! chords of one bundle together as well as those of a narrow one.
int bundleSide(int strips);

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_STRIP_PLAN_HPP
