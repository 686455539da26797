// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "strip_plan.hpp"

namespace cv {
namespace linespace {

namespace {

//! Columns that a node with bundles of the smallest side may have.
const int NARROW = 240;

//! Border points of the image, by the sides that a family sees.
struct FamilyBorder
{
    const Cell frame;
    const bool xMajor;

    FamilyBorder(const StripFamily& family)
        : frame(family.xMajor ? Cell(family.length, family.across)
                              : Cell(family.across, family.length)),
          xMajor(family.xMajor)
    {
    }
    //! On the side before the first column, at a pixel across.
    int before(int pixel) const { return xMajor ? left(pixel) : top(pixel); }
    int behind(int pixel) const { return xMajor ? right(pixel) : bottom(pixel); }
    //! On the side across pixel 0, at a column.
    int above(int column) const { return xMajor ? top(column) : left(column); }
    int below(int column) const { return xMajor ? bottom(column) : right(column); }

private:
    int top(int x) const { return x; }
    int right(int y) const { return frame.firstPoint(SIDE_RIGHT) + y; }
    int bottom(int x) const { return frame.firstPoint(SIDE_LEFT) - 1 - x; }
    int left(int y) const { return frame.borderCount() - 1 - y; }
};

} // namespace

StripFamily::StripFamily(Size image, bool isXMajor)
    : xMajor(isXMajor), length(isXMajor ? image.width : image.height),
      across(isXMajor ? image.height : image.width), strips((length + STRIP - 1) / STRIP)
{
}

int StripFamily::visibleColumns(int y, int t) const
{
    const int64 run = width(), twice = 2 * (int64)std::abs(t);
    // Doubled ways to the image's sides, before which and behind which it is outside.
    const int64 up = 2 * (int64)y + 1, down = 2 * (int64)across - up;
    if (t == 0)
        return up > 0 && down > 0 ? length : 0;
    const int64 before = t > 0 ? -up : -down, behind = t > 0 ? down : up;
    const int64 first = std::max((int64)0, floorDiv(before * run, twice)),
                last = std::min((int64)length, ceilDiv(behind * run, twice));
    return (int)std::max((int64)0, last - first);
}

bool StripFamily::imageChord(int y, int t, Chord& chord) const
{
    const FamilyBorder border(*this);
    const int64 run = width(), start = 2 * (int64)y + 1; // doubled
    // Where the chord is across the image at its first column, and at its last one, times 2 run.
    const int64 end = start * run + 2 * (int64)t * length;
    int ends[2];
    if (start > 0 && start < 2 * (int64)across)
        ends[0] = border.before(y);
    else
    {
        const bool isAbove = start < 0;
        if (isAbove ? t <= 0 : t >= 0)
            return false;
        const int64 way = isAbove ? -start : start - 2 * (int64)across;
        const int64 column = way * run / (2 * (int64)std::abs(t));
        if (column >= length)
            return false;
        ends[0] = isAbove ? border.above((int)column) : border.below((int)column);
    }
    if (end >= 0 && end < 2 * run * across)
        ends[1] = border.behind((int)(end / (2 * run)));
    else
    {
        const bool isAbove = end < 0;
        if (isAbove ? t >= 0 : t <= 0)
            return false;
        const int64 way = isAbove ? start : 2 * (int64)across - start;
        if (way < 0)
            return false;
        const int column = (int)std::min(way * run / (2 * (int64)std::abs(t)), (int64)length - 1);
        ends[1] = isAbove ? border.above(column) : border.below(column);
    }
    chord.s = std::min(ends[0], ends[1]);
    chord.e = std::max(ends[0], ends[1]);
    return border.frame.isChord(chord.s, chord.e);
}

int bundleSide(int strips)
{
    int side = LEAF_BUNDLE;
    while (side < MOST_BUNDLE && strips * STRIP > NARROW * (side / LEAF_BUNDLE))
        side *= 2;
    return side;
}

} // namespace linespace
} // namespace cv
