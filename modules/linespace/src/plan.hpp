// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The geometry of the Line Space, in integers, shared by every back end (doc/algorithm.md, sections
// 2 and 3): border points and chords of a cell, the raster of a chord, the grid of an image, the
// merges of the cascade. Coordinates are doubled, so that the midpoints of unit edges and the
// centres of pixels are integers: pixel (x, y) covers [2x, 2x + 2) x [2y, 2y + 2) and has its
// centre at (2x + 1, 2y + 1).
//
// A plan holds one short record per level, less than 4 KiB in all for any image: no table of chords
// is kept, because at the top levels it would be larger than the votes themselves (6 n^2 entries
// for an n x n image); crossings are computed where they are needed.

#ifndef OPENCV_LINESPACE_PLAN_HPP
#define OPENCV_LINESPACE_PLAN_HPP

#include "precomp.hpp"

namespace cv {
namespace linespace {

enum Side
{
    SIDE_TOP,
    SIDE_RIGHT,
    SIDE_BOTTOM,
    SIDE_LEFT
};

//! A pair of border points; canonical if s < e. Valid if they lie on different sides.
struct Chord
{
    int s, e;
};

/** A rectangle of width x height pixels, each 1 to 2^28, with width + height <= 2^28.

Chords are stored by rows: all partners e of s = 0, then those of s = 1, and so on, where the
partners of s are the border points of the sides after its own, which are consecutive. So row s has
rowLength(sideOf(s)) entries, and the table w^2 + h^2 + 4 w h. */
struct Cell
{
    int width, height;

    Cell() : width(0), height(0) {}
    Cell(int w, int h) : width(w), height(h) {}

    int borderCount() const { return 2 * (width + height); }

    size_t chordCount() const
    {
        const size_t w = width, h = height;
        return w * w + h * h + 4 * w * h;
    }

    int firstPoint(int side) const
    {
        return side == SIDE_TOP      ? 0
               : side == SIDE_RIGHT  ? width
               : side == SIDE_BOTTOM ? width + height
                                     : 2 * width + height;
    }

    int pointCount(int side) const { return side & 1 ? height : width; }

    int sideOf(int p) const
    {
        return p < width                ? SIDE_TOP
               : p < width + height     ? SIDE_RIGHT
               : p < 2 * width + height ? SIDE_BOTTOM
                                        : SIDE_LEFT;
    }

    //! Position of border point p in doubled coordinates of the cell.
    Point borderPoint(int p) const;

    bool isChord(int s, int e) const { return sideOf(s) != sideOf(e); }

    //! The first of the consecutive partners of the points of a side; the last one is borderCount()
    //! - 1.
    int firstPartner(int side) const { return firstPoint(side) + pointCount(side); }
    int rowLength(int side) const { return borderCount() - firstPartner(side); }

    //! Index of chord (s, e), s < e.
    size_t chordIndex(int s, int e) const { return rowStart(s) + (e - firstPartner(sideOf(s))); }

    //! Index of the first chord of row s, which must not lie on the left side.
    size_t rowStart(int s) const;

    //! Index of the chord of p and q in either order.
    size_t chordIndexOf(int p, int q) const { return p < q ? chordIndex(p, q) : chordIndex(q, p); }

    //! How chordIndexOf(p, q) changes from p to p + 1 on the same side.
    ptrdiff_t chordStride(int p, int q) const { return p < q ? rowLength(sideOf(p)) : 1; }
};

/** The pixels of a chord (DDA). The major axis is the longer one, x on a tie; every column (row)
whose centre lies between the two ends, ends included, has one pixel, at the floor of the exact
rational; a pixel outside of the cell does not count, which happens only at an end on the right or
bottom border.

The quotient and remainder are carried from step to step, so no product is larger than
4 width height + 2 max(width, height), formed once per chord in 64 bits; the steps themselves stay
in 32. */
struct Raster
{
    bool xMajor;
    int first;     //!< major coordinate of the first pixel
    int count;     //!< number of pixels, may be 0
    int minor;     //!< minor coordinate of the first pixel
    int remainder; //!< of the first pixel, in [0, modulus)
    int step;      //!< added to the remainder at each pixel, |step| <= modulus
    int modulus;

    Raster() : xMajor(true), first(0), count(0), minor(0), remainder(0), step(0), modulus(1) {}
    Raster(const Cell& cell, Chord chord);

    /** The same without a carry, for loops that must be fast: the i-th pixel has the minor
    coordinate (start + i increment) >> 32. Both are rounded up, so after i steps the sum is too
    large by less than (i + 1) 2^-32, while the exact coordinate is at least 1 / modulus below the
    next integer: false if count modulus > 2^32 and that may not suffice (chords beyond 32768
    pixels). */
    bool fixedPoint(int64& start, int64& increment) const;

    //! From a pixel's minor coordinate and remainder to the next one's.
    void next(int& position, int& rest) const
    {
        rest += step;
        if (rest >= modulus)
        {
            rest -= modulus;
            ++position;
        }
        else if (rest < 0)
        {
            rest += modulus;
            --position;
        }
    }

    //! Calls visit(x, y) for every pixel.
    template<class Visit>
    void forEachPixel(Visit visit) const
    {
        int position = minor, rest = remainder;
        for (int i = 0; i < count; ++i, next(position, rest))
            if (xMajor)
                visit(first + i, position);
            else
                visit(position, first + i);
    }
};

/** Two equal neighbours A (left or upper, child 0) and B (right or lower, child 1) become one cell.
Their shared side has sharedCount() border points, numbered 0, 1, ... downwards or to the right. */
struct Merge
{
    Cell child, parent;
    bool horizontal;

    Merge() : horizontal(true) {}
    Merge(const Cell& childCell, bool isHorizontal);

    int sharedCount() const { return horizontal ? child.height : child.width; }

    //! The border point of a child that is point m of the shared side.
    int sharedPoint(int childNumber, int m) const;
    //! 1 or -1: how sharedPoint changes with m.
    int sharedDirection(int childNumber) const { return horizontal == (childNumber == 0) ? 1 : -1; }

    //! Which child a border point of the parent lies on, and its number there.
    int childOf(int p) const;
    int childPoint(int p) const;

    /** Where chord (s, e), whose ends lie on different children, crosses the shared side: the floor
    of the exact coordinate, which is the nearest border point, of two the larger; 0 to
    sharedCount() - 1. */
    int crossing(int s, int e) const;

    //! Doubled coordinates of p along and across the shared side, relative to the latter's line and
    //! start.
    void relativeTo(int p, int& along, int& across) const;

    /** 1 or -1: how crossing(p, q) changes with p, if it does, from p to p + 1 on one side of one
    child, for any q on the other child. */
    int direction(int p) const;
};

/** crossing(s, e + i), all e + i on one side of one child. Numerator and denominator are affine in i
and, below 2^53, exact in double; the quotient's relative error of 2^-53 is less than its distance
1 / denominator to the next integer, unless it is one. So the truncated quotient is the exact floor,
for cells of up to 2^25 x 2^25 pixels. */
class CrossingRun
{
public:
    CrossingRun() : numerator_(0), numeratorStep_(0), denominator_(1), denominatorStep_(0) {}
    CrossingRun(const Merge& merge, int s, int e);
    int at(int i) const { return (int)(numerator(i) / denominator(i)); }
    double numerator(int i) const { return numerator_ + i * numeratorStep_; }
    double denominator(int i) const { return denominator_ + i * denominatorStep_; }

private:
    double numerator_, numeratorStep_, denominator_, denominatorStep_;
};

/** The crossings of the chords between the two runs of `length` border points from s and from e on,
on one side of one child each: those of (s + i, e + k length + j), i and j < length, lie between
least.at(k length) and most.at(k length). */
void outermostCrossings(const Merge& merge, int length, int s, int e, CrossingRun& least,
                        CrossingRun& most);

/** A run of chords (s, e) of one row of the parent, e = firstEnd .. firstEnd + count - 1, that all
lie in one child (chordS + i is the i-th one's index there, chordE is unused), or that all cross the
shared side: with m = crossing(s, e), the part at s is chord chordS + m strideS of child childS, and
the part at e = firstEnd + i is chord chordE + m strideE + i stepE of the other child. */
struct Segment
{
    int firstEnd, count;
    bool isCrossing;
    int childS;
    ptrdiff_t chordS, strideS;
    ptrdiff_t chordE, strideE, stepE;
};

//! The segments of row s of the parent, in the order of their ends; at most MAX_SEGMENTS.
enum
{
    MAX_SEGMENTS = 6
};
int rowSegments(const Merge& merge, int s, Segment segments[MAX_SEGMENTS]);

/** A level of the cascade: a grid of equal cells. Tables of a level are stored [chord][cell], where
the cells stand in bit-reversed order: the cells A of the next merge first, then the cells B in the
same order. */
struct Level
{
    Cell cell;
    Size grid;
    bool horizontal; //!< the merge that led here; meaningless at level 0
    int maxVotes;    //!< no chord has more edge pixels (doc/algorithm.md, section 3.4)
    size_t cellCount() const { return (size_t)grid.width * grid.height; }
    size_t tableSize() const { return cell.chordCount() * cellCount(); }
};

//! Everything the back ends need to know about an image size; immutable.
class Plan
{
public:
    //! The plan of METHOD_EXACT: one level, one cell, the image.
    static Ptr<const Plan> exact(Size image);
    //! The plan of METHOD_CASCADED for the wanted cell size.
    static Ptr<const Plan> cascaded(Size image, int cellSize);

    Size imageSize() const { return image_; }
    const Cell& frame() const { return levels_.back().cell; }
    int levelCount() const { return (int)levels_.size(); }
    const Level& level(int l) const { return levels_[l]; }
    //! The merge that leads from level l - 1 to level l, l >= 1.
    Merge merge(int l) const { return Merge(levels_[l - 1].cell, levels_[l].horizontal); }

    /** Index of the cells of a level in its table: cell (row, column) of the grid has the index
    rowBits[row] + columnBits[column]. */
    void cellOrder(int l, std::vector<int>& rowBits, std::vector<int>& columnBits) const;
    //! x and y of the first pixel of each cell of level 0, in the order of its table.
    std::vector<int> cellCorners() const;

    /** Number of pixels of a chord of the frame that lie in the image: the largest number of votes
    the chord could have. */
    int visibleLength(Chord chord) const;
    /** Bounds of visibleLength, quicker than itself, of the chords (s, firstEnd + i stride), all ends
    on one side, i = 0 .. count - 1.
    @param lengths not more than the visible length of that chord, nor of any other whose ends are
    at most `steps` border points from its ends on the ring. */
    void leastVisibleLengths(int s, int firstEnd, int stride, int count, int steps,
                             int* lengths) const;
    //! Not less than visibleLength.
    int mostVisibleLength(Chord chord) const;

private:
    Plan(Size image) : image_(image) {}

    Size image_;
    std::vector<Level> levels_;
};

//! Number of halvings and cell side for one axis of the grid (doc/algorithm.md, section 3.1).
struct AxisGrid
{
    int cells, side;
};
AxisGrid chooseAxisGrid(int length, int cellSize);

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_PLAN_HPP
