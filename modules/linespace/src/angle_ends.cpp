// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "angle_ends.hpp"

#include <cmath>

namespace cv {
namespace linespace {

namespace {

//! The first partner on the other side of the line through s with a normal of that angle than those
//! before, or `end`.
int firstBeyond(const Cell& frame, int s, double theta, int begin, int end)
{
    const Point p = frame.borderPoint(s);
    const double cosine = std::cos(theta), sine = std::sin(theta);
    const auto isOnFarSide = [&](int e)
    {
        const Point q = frame.borderPoint(e);
        return cosine * (q.x - p.x) + sine * (q.y - p.y) > 0;
    };
    const bool atBegin = isOnFarSide(begin);
    while (begin < end)
    {
        const int middle = begin + (end - begin) / 2;
        if (isOnFarSide(middle) == atBegin)
            begin = middle + 1;
        else
            end = middle;
    }
    return begin;
}

//! Of one s.
Vec4i rangesOf(const Cell& frame, const AngleInterval& angles, int s)
{
    enum
    {
        // Partners at either end of the interval that are looked at one by one: rounding may decide
        // about them in another way than about their place.
        SLACK = 2
    };
    const int begin = frame.firstPartner(frame.sideOf(s)), end = frame.borderCount();
    int ends[2] = {firstBeyond(frame, s, angles.min, begin, end),
                   firstBeyond(frame, s, angles.max, begin, end)};
    if (ends[0] > ends[1])
        std::swap(ends[0], ends[1]);
    Vec4i ranges(begin, begin, begin, begin);
    int last = -2; // that was opened
    const auto append = [&](int from, int to)
    {
        if (from >= to || !isInInterval(frame, angles, Chord{s, from + (to - from) / 2}))
            return;
        if (last < 0 || ranges[last + 1] < from)
        {
            last += 2;
            CV_DbgAssert(last <= 2);
            ranges[last] = from;
        }
        ranges[last + 1] = to;
    };
    int from = begin;
    for (int k = 0; k < 2; ++k)
    {
        const int near = std::max(from, ends[k] - SLACK);
        append(from, near);
        from = std::max(from, std::min(ends[k] + SLACK, end));
        for (int e = near; e < from; ++e)
            append(e, e + 1);
    }
    append(from, end);
    return ranges;
}

} // namespace

bool isInInterval(const Cell& frame, const AngleInterval& angles, Chord chord)
{
    if (angles.isFull())
        return true;
    Line line = lineOf(frame, chord);
    return angles.represent(line);
}

const std::vector<Vec4i>& AngleEnds::of(const Cell& frame, const AngleInterval& angles)
{
    if (frame.width == frame_.width && frame.height == frame_.height && angles.min == angles_.min &&
        angles.max == angles_.max)
        return ranges_;
    ranges_.resize(frame.firstPoint(SIDE_LEFT));
    parallel_for_(Range(0, (int)ranges_.size()),
                  [&](const Range& rows)
                  {
                      for (int s = rows.start; s < rows.end; ++s)
                          ranges_[s] = rangesOf(frame, angles, s);
                  });
    frame_ = frame;
    angles_ = angles;
    return ranges_;
}

} // namespace linespace
} // namespace cv
