// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "end_index.hpp"

#include <cmath>

namespace cv {
namespace linespace {

namespace {

int64 squaredDistance(Point a, Point b)
{
    const int64 x = a.x - b.x, y = a.y - b.y;
    return x * x + y * y;
}

} // namespace

EndIndex::EndIndex(const Cell& frame, double distance) : frame_(frame)
{
    const int points = frame.borderCount();
    // Two points of the border are no nearer than half their way along it, around a corner.
    const double way = std::min(2 * distance + 2, (double)points);
    width_ = std::max(8, cvCeil(way));
    bins_ = points / width_ + 1;
    reach_ = (int64)std::floor(std::min(4 * distance * distance, 1e18));
    heads_.assign(bins_, -1);
}

void EndIndex::insert(Chord chord)
{
    const Point ends[2] = {frame_.borderPoint(chord.s), frame_.borderPoint(chord.e)};
    const int bins[2] = {binOf(chord.s), binOf(chord.e)};
    for (int i = 0; i < 2; ++i)
    {
        const Entry entry = {ends[i], ends[1 - i], heads_[bins[i]]};
        heads_[bins[i]] = (int)entries_.size();
        entries_.push_back(entry);
    }
}

bool EndIndex::hasNear(Chord chord) const
{
    const Point own = frame_.borderPoint(chord.s), other = frame_.borderPoint(chord.e);
    const int bin = binOf(chord.s);
    // The last bin is narrower than the others: the one before it can be near the first one.
    const int last = std::min(bins_, bin < 2 || bin + 2 >= bins_ ? 5 : 3);
    const int first = bin - last / 2;
    for (int k = 0; k < last; ++k)
        for (int i = heads_[(first + k + bins_) % bins_]; i >= 0; i = entries_[i].next)
            if (squaredDistance(entries_[i].own, own) <= reach_ &&
                squaredDistance(entries_[i].other, other) <= reach_)
                return true;
    return false;
}

} // namespace linespace
} // namespace cv
