// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "line_geometry.hpp"

#include <cmath>
#include <limits>

namespace cv {
namespace linespace {

Line lineOf(const Cell& frame, Chord chord)
{
    const Point p = frame.borderPoint(chord.s), q = frame.borderPoint(chord.e);
    // The normal, turned into the upper half plane: y > 0, or y = 0 and x > 0.
    int x = q.y - p.y, y = p.x - q.x;
    if (y < 0 || (y == 0 && x < 0))
    {
        x = -x;
        y = -y;
    }
    const double length = std::sqrt((double)x * x + (double)y * y);
    Line line;
    line.theta = std::atan2((double)y, (double)x);
    // Doubled coordinates, and the centre of pixel (0, 0) at (1, 1) there.
    line.rho = ((double)x * (p.x - 1) + (double)y * (p.y - 1)) / (2 * length);
    return line;
}

bool clipLine(double cosine, double sine, double rho, Size image, Ends& ends)
{
    // Liang-Barsky from the foot of the normal along the direction (-sine, cosine).
    const Point2d foot(rho * cosine, rho * sine);
    const double low[2] = {-0.5, -0.5}, high[2] = {image.width - 0.5, image.height - 0.5};
    const double start[2] = {foot.x, foot.y}, direction[2] = {-sine, cosine};
    double t0 = -std::numeric_limits<double>::infinity(), t1 = -t0;
    for (int axis = 0; axis < 2; ++axis)
    {
        if (direction[axis] == 0)
        {
            if (!(start[axis] >= low[axis] && start[axis] <= high[axis]))
                return false;
            continue;
        }
        double a = (low[axis] - start[axis]) / direction[axis],
               b = (high[axis] - start[axis]) / direction[axis];
        if (a > b)
            std::swap(a, b);
        t0 = std::max(t0, a);
        t1 = std::min(t1, b);
    }
    if (!(t0 <= t1)) // also false for what is not a number
        return false;
    Point2d* points[2] = {&ends.first, &ends.second};
    const double t[2] = {t0, t1};
    for (int i = 0; i < 2; ++i)
    {
        points[i]->x = std::min(std::max(start[0] + t[i] * direction[0], low[0]), high[0]);
        points[i]->y = std::min(std::max(start[1] + t[i] * direction[1], low[1]), high[1]);
    }
    if (ends.second.x < ends.first.x ||
        (ends.second.x == ends.first.x && ends.second.y < ends.first.y))
        std::swap(ends.first, ends.second);
    return true;
}

bool AngleInterval::represent(Line& line) const
{
    const double halfTurns = std::ceil((min - line.theta) / CV_PI);
    double theta = line.theta + halfTurns * CV_PI;
    bool odd = std::fmod(halfTurns, 2.) != 0;
    // Rounding may lead a little beyond either end of the half turn from min.
    if (theta < min)
        theta = min;
    if (theta >= min + CV_PI)
    {
        theta = min;
        odd = !odd;
    }
    if (!isFull() && theta > max)
        return false;
    line.theta = theta;
    if (odd)
        line.rho = -line.rho;
    return true;
}

Vec2f AngleInterval::round(const Line& line) const
{
    const float up = std::numeric_limits<float>::infinity();
    float theta = (float)line.theta;
    if (theta < min)
        theta = std::nextafter(theta, up);
    else if (!contains(theta))
        theta = std::nextafter(theta, -up);
    return Vec2f((float)line.rho, theta);
}

LineIndex::LineIndex(Size image, double distance)
    : centre_(0.5 * image.width - 0.5, 0.5 * image.height - 0.5), distance_(distance),
      radius_(
          0.5 * std::sqrt((double)image.width * image.width + (double)image.height * image.height) +
          1)
{
    distanceStep_ = std::max(4., radius_ / 128);
    distanceBins_ = (int)(2 * radius_ / distanceStep_) + 1;
    bins_.resize(ANGLE_BINS * distanceBins_, -1);
}

int LineIndex::distanceBin(double distance) const
{
    const double bin = (distance + radius_) / distanceStep_;
    return bin < 0 ? 0 : bin >= distanceBins_ ? distanceBins_ - 1 : (int)bin;
}

void LineIndex::insert(const Line& line)
{
    // Angles are kept in [0, pi); the distance is that from the centre of the image.
    Line upright = line;
    const AngleInterval half = {0, CV_PI};
    half.represent(upright);
    Entry entry = {std::cos(upright.theta), std::sin(upright.theta), upright.rho, -1};
    const int angle = std::min((int)(upright.theta * (ANGLE_BINS / CV_PI)), ANGLE_BINS - 1);
    const double distance = entry.rho - (entry.cosine * centre_.x + entry.sine * centre_.y);
    int& last = bins_[bin(angle, distanceBin(distance))];
    entry.next = last;
    last = (int)entries_.size();
    entries_.push_back(entry);
}

bool LineIndex::hasNear(const Line& line, const Ends& ends) const
{
    if (distance_ <= 0)
        return false;
    // A line within the distance of both ends makes at most this angle with the line between them,
    // and passes the middle between them at most at the distance.
    const Point2d along = ends.second - ends.first,
                  middle = (ends.first + ends.second) * 0.5 - centre_;
    const double length = std::sqrt(along.dot(along));
    const double spread = length > 2 * distance_ ? std::asin(2 * distance_ / length) : CV_PI;
    const double binWidth = CV_PI / ANGLE_BINS;
    const int reach = std::min((int)(spread / binWidth) + 2, ANGLE_BINS / 2);
    const int centreBin = (int)std::floor(line.theta / binWidth);
    for (int offset = -reach; offset < reach + (reach < ANGLE_BINS / 2); ++offset)
    {
        const int angle = ((centreBin + offset) % ANGLE_BINS + ANGLE_BINS) % ANGLE_BINS;
        // The distance at the centre of the image, at any angle of the bin, differs from that of
        // the middle by the slack at most.
        const double theta = (angle + 0.5) * binWidth;
        const double at = middle.x * std::cos(theta) + middle.y * std::sin(theta);
        const double slack = distance_ + std::sqrt(middle.dot(middle)) * binWidth + 1e-6;
        for (int d = distanceBin(at - slack), last = distanceBin(at + slack); d <= last; ++d)
            for (int i = bins_[bin(angle, d)]; i >= 0; i = entries_[i].next)
            {
                const Entry& other = entries_[i];
                if (std::abs(other.cosine * ends.first.x + other.sine * ends.first.y - other.rho) <=
                        distance_ &&
                    std::abs(other.cosine * ends.second.x + other.sine * ends.second.y -
                             other.rho) <= distance_)
                    return true;
            }
    }
    return false;
}

} // namespace linespace
} // namespace cv
