// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "naive_cascade.hpp"

#include "directions.hpp"

#include <algorithm>
#include <chrono>
#include <vector>

namespace cascade {

namespace {

int borderCount(cv::Size cell)
{
    return 2 * (cell.width + cell.height);
}

int sideOf(cv::Size cell, int number)
{
    return number < cell.width                     ? 0
           : number < cell.width + cell.height     ? 1
           : number < 2 * cell.width + cell.height ? 2
                                                   : 3;
}

//! The inverse of borderPoint().
int numberOf(cv::Size cell, cv::Point point)
{
    const int w = cell.width, h = cell.height;
    if (point.y == 0)
        return point.x / 2;
    if (point.x == 2 * w)
        return w + point.y / 2;
    if (point.y == 2 * h)
        return w + h + (w - 1 - point.x / 2);
    return 2 * w + h + (h - 1 - point.y / 2);
}

//! Pixels on the raster of a chord of a cell (section 2.3) that vote for the chord's bin.
int rasterVotes(const cv::Mat1w& cell, int s, int e)
{
    cv::Point from = borderPoint(cell.size(), s), to = borderPoint(cell.size(), e);
    const int bin = directionBin(to - from);
    const bool isXMajor = std::abs(to.x - from.x) >= std::abs(to.y - from.y);
    if (!isXMajor)
    {
        std::swap(from.x, from.y);
        std::swap(to.x, to.y);
    }
    if (from.x > to.x)
        std::swap(from, to);
    const int minorSize = isXMajor ? cell.rows : cell.cols;
    int votes = 0;
    for (int major = from.x / 2; 2 * major + 1 <= to.x; ++major)
    {
        const int steps = 2 * major + 1 - from.x;
        if (steps < 0)
            continue;
        // The doubled minor coordinate, halved and rounded down; never negative.
        const int minor =
            (from.y * (to.x - from.x) + steps * (to.y - from.y)) / (2 * (to.x - from.x));
        if (minor < minorSize)
            votes += (isXMajor ? cell(minor, major) : cell(major, minor)) >> bin & 1;
    }
    return votes;
}

//! A grid of equal cells, each with its table of votes.
struct Level
{
    cv::Size cell, grid;
    std::vector<cv::Mat1i> tables; //!< by rows of the grid

    const cv::Mat1i& table(int row, int column) const { return tables[row * grid.width + column]; }
};

cv::Mat1i cellVotes(const cv::Mat1w& cell)
{
    cv::Mat1i votes(borderCount(cell.size()), borderCount(cell.size()), 0);
    for (int s = 0; s < votes.rows; ++s)
        for (int e = s + 1; e < votes.cols; ++e)
            if (!areOnOneSide(cell.size(), s, e))
                votes(s, e) = votes(e, s) = rasterVotes(cell, s, e);
    return votes;
}

Level firstLevel(const cv::Mat1w& voters, int cellSize)
{
    Level level{cv::Size(cellSize, cellSize), voters.size() / cellSize, {}};
    for (int row = 0; row < level.grid.height; ++row)
        for (int column = 0; column < level.grid.width; ++column)
            level.tables.push_back(cellVotes(
                voters(cv::Rect(cv::Point(column * cellSize, row * cellSize), level.cell))));
    return level;
}

/** Whether a tie goes to the larger point: for every other position of the chord's end on the first
child, and, so that the parts of one chord do not all go the same way, every other crossing. */
bool unbiasedTie(int endOnFirst, int crossing)
{
    return (endOnFirst + crossing) % 2 == 0;
}

//! A chord of the parent as parts of its two children, first and second.
struct Parts
{
    int first = -1, second = -1; //!< the ends' numbers on the children; -1: no end there
    int other = -1;              //!< if both ends are on one child, the other one's number there
    int joints[2], jointCount = 0;
};

class Merge
{
public:
    Merge(cv::Size child, bool horizontal, CrossingRule rule)
        : child_(child), parent_(horizontal ? cv::Size(2 * child.width, child.height)
                                            : cv::Size(child.width, 2 * child.height)),
          horizontal_(horizontal), rule_(rule)
    {
    }

    cv::Size parent() const { return parent_; }

    //! Number of point m of the shared side on the first (left, upper) or second child.
    int sharedNumber(bool onSecond, int m) const
    {
        const int across = onSecond ? 0 : 2 * (horizontal_ ? child_.width : child_.height);
        return numberOf(child_,
                        horizontal_ ? cv::Point(across, 2 * m + 1) : cv::Point(2 * m + 1, across));
    }

    Parts partsOf(int s, int e, MergeCost& cost) const
    {
        cv::Point from = borderPoint(parent_, s), to = borderPoint(parent_, e);
        const bool fromSecond = isOnSecond(from), toSecond = isOnSecond(to);
        Parts parts;
        if (fromSecond == toSecond)
        {
            (fromSecond ? parts.second : parts.first) = childNumber(from);
            parts.other = childNumber(to);
            return parts;
        }
        if (fromSecond)
            std::swap(from, to);
        parts.first = childNumber(from);
        parts.second = childNumber(to);
        addJoints(from, to, parts, cost);
        return parts;
    }

private:
    //! Doubled coordinate across the shared side, 0 on it, and along it.
    int across(cv::Point p) const
    {
        return horizontal_ ? p.x - 2 * child_.width : p.y - 2 * child_.height;
    }
    int along(cv::Point p) const { return horizontal_ ? p.y : p.x; }

    bool isOnSecond(cv::Point p) const { return across(p) > 0; }
    int childNumber(cv::Point p) const
    {
        if (isOnSecond(p))
            (horizontal_ ? p.x -= 2 * child_.width : p.y -= 2 * child_.height);
        return numberOf(child_, p);
    }

    void addJoints(cv::Point from, cv::Point to, Parts& parts, MergeCost& cost) const
    {
        // The crossing is at numerator / denominator pixels from the side's start.
        const int numerator = along(from) * across(to) - along(to) * across(from);
        const int denominator = 2 * (across(to) - across(from));
        const int nearest = numerator / denominator, rest = numerator % denominator;
        const int last = (horizontal_ ? child_.height : child_.width) - 1;
        parts.joints[0] = nearest;
        parts.jointCount = 1;
        cost.ties += rest == 0;
        if (rule_ == CrossingRule::NEAREST_UNBIASED && rest == 0 &&
            !unbiasedTie(parts.first, nearest))
            parts.joints[0] = nearest - 1;
        if (rule_ == CrossingRule::BOTH_NEIGHBOURS && 2 * rest != denominator)
        {
            const int neighbour = 2 * rest < denominator ? nearest - 1 : nearest + 1;
            if (neighbour >= 0 && neighbour <= last)
                parts.joints[parts.jointCount++] = neighbour;
        }
        cost.tiesUp += rest == 0 && parts.jointCount == 1 && parts.joints[0] == nearest;
    }

    cv::Size child_, parent_;
    bool horizontal_;
    CrossingRule rule_;
};

int mergedVotes(const Merge& merge, const Parts& parts, const cv::Mat1i& first,
                const cv::Mat1i& second)
{
    if (parts.jointCount == 0)
        return parts.second < 0 ? first(parts.first, parts.other)
                                : second(parts.second, parts.other);
    int most = 0;
    for (int i = 0; i < parts.jointCount; ++i)
        most = std::max(most, first(parts.first, merge.sharedNumber(false, parts.joints[i])) +
                                  second(parts.second, merge.sharedNumber(true, parts.joints[i])));
    return most;
}

Level merged(const Level& children, bool horizontal, CrossingRule rule, MergeCost& cost)
{
    const Merge merge(children.cell, horizontal, rule);
    Level level{merge.parent(),
                horizontal ? cv::Size(children.grid.width / 2, children.grid.height)
                           : cv::Size(children.grid.width, children.grid.height / 2),
                {}};
    const int points = borderCount(level.cell);
    for (int i = 0; i < level.grid.area(); ++i)
        level.tables.push_back(cv::Mat1i(points, points, 0));
    for (int s = 0; s < points; ++s)
        for (int e = s + 1; e < points; ++e)
        {
            if (areOnOneSide(level.cell, s, e))
                continue;
            MergeCost ofOne;
            const Parts parts = merge.partsOf(s, e, ofOne);
            const int cells = level.grid.area();
            cost.chords += cells;
            cost.crossings += parts.jointCount > 0 ? cells : 0;
            cost.sums += (double)parts.jointCount * cells;
            cost.ties += ofOne.ties * cells;
            cost.tiesUp += ofOne.tiesUp * cells;
            for (int row = 0; row < level.grid.height; ++row)
                for (int column = 0; column < level.grid.width; ++column)
                {
                    const int votes =
                        horizontal ? mergedVotes(merge, parts, children.table(row, 2 * column),
                                                 children.table(row, 2 * column + 1))
                                   : mergedVotes(merge, parts, children.table(2 * row, column),
                                                 children.table(2 * row + 1, column));
                    cv::Mat1i& table = level.tables[row * level.grid.width + column];
                    table(s, e) = table(e, s) = votes;
                }
        }
    return level;
}

} // namespace

cv::Point borderPoint(cv::Size cell, int number)
{
    const int w = cell.width, h = cell.height;
    switch (sideOf(cell, number))
    {
    case 0: return {2 * number + 1, 0};
    case 1: return {2 * w, 2 * (number - w) + 1};
    case 2: return {2 * (2 * w + h - number) - 1, 2 * h};
    default: return {0, 2 * (2 * w + 2 * h - number) - 1};
    }
}

bool areOnOneSide(cv::Size cell, int s, int e)
{
    return sideOf(cell, s) == sideOf(cell, e);
}

cv::Mat1i naiveCascade(const cv::Mat1w& voters, int cellSize, CrossingRule rule, MergeCost& cost)
{
    CV_Assert(voters.cols == voters.rows && voters.cols % cellSize == 0);
    Level level = firstLevel(voters, cellSize);
    const auto start = std::chrono::steady_clock::now();
    for (bool horizontal = true; level.tables.size() > 1; horizontal = !horizontal)
        level = merged(level, horizontal, rule, cost);
    cost.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return level.tables[0];
}

cv::Mat1i naiveExactVotes(const cv::Mat1w& voters)
{
    return cellVotes(voters);
}

} // namespace cascade
