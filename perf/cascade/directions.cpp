// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "directions.hpp"

#include <array>
#include <cmath>

namespace cascade {

namespace {

constexpr int BINS = 16;

using Directions = std::array<std::array<int64, 2>, BINS>;

//! (cos, sin) of first + b pi / 16 in fixed point.
Directions directionsFrom(double first, double scale)
{
    Directions directions;
    for (int b = 0; b < BINS; ++b)
        for (const int i : {0, 1})
        {
            const double angle = first + b * CV_PI / BINS;
            directions[b][i] = std::lround(scale * (i == 0 ? std::cos(angle) : std::sin(angle)));
        }
    return directions;
}

int bitsOf(int64 dx, int64 dy)
{
    static const Directions centres = directionsFrom(CV_PI / (2 * BINS), 1 << 14);
    static const int64 sineSquared =
        std::llround((1 << 28) * std::pow(std::sin(22.5 * CV_PI / 180), 2));
    int bits = 0;
    for (int b = 0; b < BINS; ++b)
    {
        const int64 across = dx * centres[b][0] + dy * centres[b][1];
        if (across * across <= sineSquared * (dx * dx + dy * dy))
            bits |= 1 << b;
    }
    return bits;
}

} // namespace

int directionBin(cv::Point direction)
{
    static const Directions starts = directionsFrom(0, 1 << 15);
    if (direction.y < 0 || (direction.y == 0 && direction.x < 0))
        direction = -direction;
    int bin = 0;
    for (int b = 1; b < BINS; ++b)
        if (starts[b][0] * direction.y >= starts[b][1] * direction.x)
            bin = b;
    return bin;
}

cv::Mat1w votersOf(const cv::Mat1b& edges, const cv::Mat1s& dx, const cv::Mat1s& dy)
{
    cv::Mat1w voters(edges.size(), 0);
    for (int y = 0; y < edges.rows; ++y)
        for (int x = 0; x < edges.cols; ++x)
            if (edges(y, x) != 0)
                voters(y, x) = (ushort)(dx.empty() ? 0xffff : bitsOf(dx(y, x), dy(y, x)));
    return voters;
}

} // namespace cascade
