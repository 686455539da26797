// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Implements doc/algorithm.md, sections 2 and 3. Integers only.

#include "plan.hpp"

namespace cv {
namespace linespace {

namespace {

//! floor(a / b) for a >= 0, b > 0; the only division that decides on a pixel or a crossing.
int64 floorDivide(int64 a, int64 b)
{
    CV_DbgAssert(a >= 0 && b > 0);
    return a / b;
}

//! ceil(a / b) for b > 0.
int64 ceilDivide(int64 a, int64 b)
{
    return a >= 0 ? (a + b - 1) / b : -(-a / b);
}

} // namespace

Point Cell::borderPoint(int p) const
{
    const int side = sideOf(p), i = p - firstPoint(side);
    switch (side)
    {
    case SIDE_TOP: return Point(2 * i + 1, 0);
    case SIDE_RIGHT: return Point(2 * width, 2 * i + 1);
    case SIDE_BOTTOM: return Point(2 * (width - i) - 1, 2 * height);
    default: return Point(0, 2 * (height - i) - 1);
    }
}

size_t Cell::rowStart(int s) const
{
    const size_t w = width, h = height;
    const int side = sideOf(s);
    CV_DbgAssert(side != SIDE_LEFT);
    const size_t before = side == SIDE_TOP     ? 0
                          : side == SIDE_RIGHT ? w * (w + 2 * h)
                                               : w * (w + 2 * h) + h * (w + h);
    return before + (size_t)(s - firstPoint(side)) * rowLength(side);
}

bool Raster::fixedPoint(int64& start, int64& increment) const
{
    const int64 one = (int64)1 << 32;
    if ((int64)count * modulus > one)
        return false;
    start = minor * one + ceilDivide(remainder * one, modulus);
    increment = ceilDivide(step * one, modulus);
    return true;
}

Raster::Raster(const Cell& cell, Chord chord)
{
    Point p = cell.borderPoint(chord.s), q = cell.borderPoint(chord.e);
    xMajor = std::abs(q.x - p.x) >= std::abs(q.y - p.y);
    // From here on x is the major axis.
    if (!xMajor)
    {
        std::swap(p.x, p.y);
        std::swap(q.x, q.y);
    }
    if (q.x < p.x)
        std::swap(p, q);
    const int minorLimit = xMajor ? cell.height : cell.width;
    const int dx = q.x - p.x, dy = q.y - p.y;

    first = p.x / 2; // first centre 2 first + 1 >= p.x
    int last = (q.x - 1) / 2;
    modulus = 2 * dx;
    step = 2 * dy;
    const int64 numerator = (int64)p.y * dx + (int64)dy * (2 * first + 1 - p.x);
    minor = (int)floorDivide(numerator, modulus);
    remainder = (int)(numerator - (int64)minor * modulus);

    // Only an end point itself can lie on the far border, where its pixel belongs to the neighbour.
    if (p.y == 2 * minorLimit && 2 * first + 1 == p.x)
    {
        ++first;
        remainder += step;
        if (remainder < 0)
        {
            remainder += modulus;
            --minor;
        }
    }
    if (q.y == 2 * minorLimit && 2 * last + 1 == q.x)
        --last;
    count = std::max(0, last - first + 1);
}

Merge::Merge(const Cell& childCell, bool isHorizontal)
    : child(childCell), parent(isHorizontal ? 2 * childCell.width : childCell.width,
                               isHorizontal ? childCell.height : 2 * childCell.height),
      horizontal(isHorizontal)
{
}

int Merge::sharedPoint(int childNumber, int m) const
{
    const int w = child.width, h = child.height;
    if (horizontal)
        return childNumber == 0 ? w + m : 2 * w + 2 * h - 1 - m;
    return childNumber == 0 ? 2 * w + h - 1 - m : m;
}

int Merge::childOf(int p) const
{
    const int side = parent.sideOf(p), i = p - parent.firstPoint(side);
    if (horizontal)
        return side == SIDE_RIGHT || (side == SIDE_TOP && i >= child.width) ||
               (side == SIDE_BOTTOM && i < child.width);
    return side == SIDE_BOTTOM || (side == SIDE_RIGHT && i >= child.height) ||
           (side == SIDE_LEFT && i < child.height);
}

int Merge::childPoint(int p) const
{
    const int side = parent.sideOf(p), i = p - parent.firstPoint(side);
    const int n = child.pointCount(side);
    return child.firstPoint(side) + (i >= n ? i - n : i);
}

void Merge::relativeTo(int p, int& along, int& across) const
{
    const Point point = parent.borderPoint(p);
    along = horizontal ? point.y : point.x;
    across = horizontal ? point.x - 2 * child.width : point.y - 2 * child.height;
}

int Merge::crossing(int s, int e) const
{
    int alongA, acrossA, alongB, acrossB;
    relativeTo(s, alongA, acrossA);
    relativeTo(e, alongB, acrossB);
    if (acrossA > acrossB)
    {
        std::swap(alongA, alongB);
        std::swap(acrossA, acrossB);
    }
    CV_DbgAssert(acrossA < 0 && acrossB > 0);
    // The weighted mean of the two ends where across is 0; the weights are positive.
    const int64 numerator = (int64)alongA * acrossB - (int64)alongB * acrossA;
    const int m = (int)floorDivide(numerator, 2 * ((int64)acrossB - acrossA));
    CV_DbgAssert(0 <= m && m < sharedCount());
    return m;
}

int Merge::direction(int p) const
{
    int along, across, alongNext, acrossNext;
    relativeTo(p, along, across);
    relativeTo(p + 1, alongNext, acrossNext);
    if (acrossNext == across)
        return alongNext > along ? 1 : -1;
    // The nearer p comes to the shared line, the nearer the crossing comes to p, which lies at the
    // start or the end of that line.
    const bool comesNearer = std::abs(acrossNext) < std::abs(across);
    return comesNearer == (along == 0) ? -1 : 1;
}

CrossingRun::CrossingRun(const Merge& merge, int s, int e)
{
    int alongS, acrossS, alongE, acrossE;
    merge.relativeTo(s, alongS, acrossS);
    merge.relativeTo(e, alongE, acrossE);
    // The step to the next border point: along for the sides parallel to the shared one, across
    // for the others, which begin and end on its line's ends.
    const int side = merge.parent.sideOf(e);
    const int step = side == SIDE_TOP || side == SIDE_RIGHT ? 2 : -2;
    const bool isParallel = merge.horizontal == (side == SIDE_RIGHT || side == SIDE_LEFT);
    const int alongStep = isParallel ? step : 0, acrossStep = isParallel ? 0 : step;
    // In that order both are positive if s lies on A, else both are negative: the same quotient.
    numerator_ = (double)alongS * acrossE - (double)alongE * acrossS;
    denominator_ = 2. * ((double)acrossE - acrossS);
    numeratorStep_ = (double)alongS * acrossStep - (double)alongStep * acrossS;
    denominatorStep_ = 2. * acrossStep;
}

void outermostCrossings(const Merge& merge, int length, int s, int e, CrossingRun& least,
                        CrossingRun& most)
{
    // A crossing moves one way with either end, so the outermost two chords tell.
    const int lastS = merge.direction(s) > 0 ? length - 1 : 0,
              lastE = merge.direction(e) > 0 ? length - 1 : 0;
    least = CrossingRun(merge, s + length - 1 - lastS, e + length - 1 - lastE);
    most = CrossingRun(merge, s + lastS, e + lastE);
}

int rowSegments(const Merge& merge, int s, Segment segments[MAX_SEGMENTS])
{
    const Cell &parent = merge.parent, &child = merge.child;
    const int childS = merge.childOf(s), childE = 1 - childS;
    const int pointS = merge.childPoint(s);
    int n = 0;
    for (int side = parent.sideOf(s) + 1; side <= SIDE_LEFT; ++side)
    {
        // A side of the parent is one side of one child, or the same side of both, half and half.
        const int length = child.pointCount(side);
        const int end = parent.firstPoint(side) + parent.pointCount(side);
        for (int e = parent.firstPoint(side); e < end; e += length)
        {
            Segment& segment = segments[n++];
            const int pointE = merge.childPoint(e);
            segment.firstEnd = e;
            segment.count = length;
            segment.childS = childS;
            segment.isCrossing = merge.childOf(e) != childS;
            if (!segment.isCrossing)
            {
                segment.chordS = child.chordIndex(pointS, pointE);
                segment.strideS = segment.chordE = segment.strideE = segment.stepE = 0;
                continue;
            }
            const int shareS = merge.sharedPoint(childS, 0), shareE = merge.sharedPoint(childE, 0);
            segment.chordS = child.chordIndexOf(pointS, shareS);
            segment.strideS = merge.sharedDirection(childS) * child.chordStride(shareS, pointS);
            segment.chordE = child.chordIndexOf(pointE, shareE);
            segment.strideE = merge.sharedDirection(childE) * child.chordStride(shareE, pointE);
            segment.stepE = child.chordStride(pointE, shareE);
        }
    }
    CV_DbgAssert(n <= MAX_SEGMENTS);
    return n;
}

AxisGrid chooseAxisGrid(int length, int cellSize)
{
    AxisGrid best = {0, 0};
    for (int a = 0; a < 31; ++a)
    {
        const int cells = 1 << a;
        const int side = (int)(((int64)length + cells - 1) / cells);
        const bool allowed =
            (2 * side >= cellSize && side <= 3 * cellSize) || (a == 0 && length <= 3 * cellSize);
        if (allowed)
        {
            // Smallest frame, then the side nearest to the wanted one as a ratio, then the smaller
            // side.
            const int64 frame = (int64)cells * side, bestFrame = (int64)best.cells * best.side;
            const int64 high = std::max(side, cellSize), low = std::min(side, cellSize);
            const int64 bestHigh = std::max(best.side, cellSize),
                        bestLow = std::min(best.side, cellSize);
            const bool better =
                best.cells == 0 || frame < bestFrame ||
                (frame == bestFrame && (high * bestLow < bestHigh * low ||
                                        (high * bestLow == bestHigh * low && side < best.side)));
            if (better)
            {
                best.cells = cells;
                best.side = side;
            }
        }
        if (2 * side < cellSize)
            break;
    }
    CV_DbgAssert(best.cells > 0);
    return best;
}

Ptr<const Plan> Plan::exact(Size image)
{
    Plan* plan = new Plan(image);
    Ptr<const Plan> result(plan);
    Level level;
    level.cell = Cell(image.width, image.height);
    level.grid = Size(1, 1);
    level.horizontal = false;
    level.maxVotes = std::max(image.width, image.height);
    plan->levels_.push_back(level);
    return result;
}

Ptr<const Plan> Plan::cascaded(Size image, int cellSize)
{
    Plan* plan = new Plan(image);
    Ptr<const Plan> result(plan);
    const AxisGrid x = chooseAxisGrid(image.width, cellSize),
                   y = chooseAxisGrid(image.height, cellSize);
    Level level;
    level.cell = Cell(x.side, y.side);
    level.grid = Size(x.cells, y.cells);
    level.horizontal = false;
    int inner = 2; // cells of level 0 along and down one cell of this level
    for (;;)
    {
        // Every crossing that a chord makes can be rounded half a pixel away, which lengthens its
        // polyline by as much at most, and each of its parts can count half a pixel more than its
        // length.
        level.maxVotes = std::max(level.cell.width, level.cell.height) + inner - 2;
        plan->levels_.push_back(level);
        const bool columns = level.grid.width > 1, rows = level.grid.height > 1;
        if (!columns && !rows)
            break;
        level.horizontal = columns && (!rows || plan->levels_.size() == 1 || !level.horizontal);
        const Merge merge(level.cell, level.horizontal);
        level.cell = merge.parent;
        (level.horizontal ? level.grid.width : level.grid.height) /= 2;
        inner = x.cells / level.grid.width + y.cells / level.grid.height;
    }
    return result;
}

void Plan::cellOrder(int l, std::vector<int>& rowBits, std::vector<int>& columnBits) const
{
    const Level& level = levels_[l];
    rowBits.assign(level.grid.height, 0);
    columnBits.assign(level.grid.width, 0);
    int bit = (int)level.cellCount() / 2; // the next merge decides on the half of the table
    int rowShift = 0, columnShift = 0;
    for (int t = l + 1; t < levelCount(); ++t, bit /= 2)
    {
        std::vector<int>& bits = levels_[t].horizontal ? columnBits : rowBits;
        int& shift = levels_[t].horizontal ? columnShift : rowShift;
        for (size_t i = 0; i < bits.size(); ++i)
            bits[i] |= (i >> shift & 1) ? bit : 0;
        ++shift;
    }
}

std::vector<int> Plan::cellCorners() const
{
    const Level& first = level(0);
    std::vector<int> rowBits, columnBits;
    cellOrder(0, rowBits, columnBits);
    std::vector<int> corners(2 * first.cellCount());
    for (int row = 0; row < first.grid.height; ++row)
        for (int column = 0; column < first.grid.width; ++column)
        {
            int* const corner = &corners[2 * (rowBits[row] + columnBits[column])];
            corner[0] = column * first.cell.width;
            corner[1] = row * first.cell.height;
        }
    return corners;
}

int Plan::visibleLength(Chord chord) const
{
    const Raster raster(frame(), chord);
    const int majorLimit = raster.xMajor ? image_.width : image_.height;
    const int minorLimit = raster.xMajor ? image_.height : image_.width;
    // The minor coordinate is monotone along the chord: the pixels inside are those before it
    // reaches the limit, or those after it left it.
    int begin = 0, end = std::min(raster.count, majorLimit - raster.first);
    if (end <= 0)
        return 0;
    const int64 start = (int64)raster.minor * raster.modulus + raster.remainder;
    const int64 limit = (int64)minorLimit * raster.modulus;
    if (raster.step > 0) // inside while start + i step < limit
        end = start >= limit
                  ? 0
                  : (int)std::min<int64>(end, (limit - start + raster.step - 1) / raster.step);
    else if (start >= limit) // inside from the first i with start + i step < limit
        begin = raster.step == 0
                    ? end
                    : (int)std::min<int64>(end, (start - limit) / -(int64)raster.step + 1);
    return std::max(0, end - begin);
}

void Plan::leastVisibleLengths(int s, int firstEnd, int stride, int count, int steps,
                               int* lengths) const
{
    const int side = frame().sideOf(firstEnd);
    const int step = side == SIDE_TOP || side == SIDE_RIGHT ? 2 * stride : -2 * stride;
    const bool isAcross = side == SIDE_TOP || side == SIDE_BOTTOM;
    const Point first = frame().borderPoint(firstEnd) - frame().borderPoint(s);
    const Point next(isAcross ? step : 0, isAcross ? 0 : step);
    // Of columns that were added to the image, a chord that moves by more columns than rows can
    // lose all, and of the rows what its slope makes of them.
    const int columns = frame().width - image_.width, rows = frame().height - image_.height;
    const bool isPadded = columns > 0 || rows > 0;
    for (int i = 0; i < count; ++i)
    {
        // Doubled; a step moves an end by one pixel at most, also around a corner.
        const int dx = std::max(0, std::abs(first.x + i * next.x) - 4 * steps),
                  dy = std::max(0, std::abs(first.y + i * next.y) - 4 * steps);
        const int major = std::max(dx, dy);
        // An end may lose a pixel to rounding, the one on a far border another.
        int length = major / 2 - 2;
        if (isPadded)
        {
            const int along = dx >= dy ? columns : rows, across = dx >= dy ? rows : columns;
            const float lost = along + across * ((float)major / std::max(1, std::min(dx, dy)));
            length -= (int)std::min(lost + 0.999f, (float)major);
        }
        lengths[i] = std::max(0, length);
    }
}

int Plan::mostVisibleLength(Chord chord) const
{
    const Point difference = frame().borderPoint(chord.e) - frame().borderPoint(chord.s);
    return std::max(std::abs(difference.x), std::abs(difference.y)) / 2 + 1;
}

} // namespace linespace
} // namespace cv
