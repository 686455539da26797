// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "refine.hpp"

#include <cmath>

namespace cv {
namespace linespace {

namespace {

const double SUPPORT_DISTANCE =
    1; // pixels; half a pixel of the chord's raster, half of the true line's
const double EXPLAINED_DISTANCE =
    2; // pixels; what a thick or slightly bent edge leaves beside its line
const int MAX_ITERATIONS = 10;

//! Moments of the supporting pixels; integers, so that they do not depend on the order of
//! summation.
struct Moments
{
    int64 n, x, y, xx, xy, yy;

    bool operator==(const Moments& other) const
    {
        return n == other.n && x == other.x && y == other.y && xx == other.xx && xy == other.xy &&
               yy == other.yy;
    }
};

//! Calls visit(x, y) for every pixel of an image whose centre is within a distance of a line.
template<class Visit>
void forEachPixelNear(Size image, const Line& line, double distance, Visit visit)
{
    const double cosine = std::cos(line.theta), sine = std::sin(line.theta);
    const bool xMajor = std::abs(sine) >= std::abs(cosine);
    const double major = xMajor ? cosine : sine, minor = xMajor ? sine : cosine;
    const int length = xMajor ? image.width : image.height,
              limit = xMajor ? image.height : image.width;
    const double reach = distance / std::abs(minor);
    for (int i = 0; i < length; ++i)
    {
        const double centre = (line.rho - i * major) / minor;
        if (!(centre > -reach - 1 && centre < limit + reach))
            continue;
        const int first = std::max(0, cvCeil(centre - reach)),
                  last = std::min(limit - 1, cvFloor(centre + reach));
        for (int k = first; k <= last; ++k)
            visit(xMajor ? i : k, xMajor ? k : i);
    }
}

//! Which edge pixels can support the line of a chord.
class Support
{
public:
    Support(const EdgeMap& edges, ushort bit) : edges_(edges), bit_(bit) {}
    bool has(int x, int y) const
    {
        return edges_.votes.ptr<uchar>(y)[x] != 0 &&
               (!edges_.isOriented() || (edges_.directions.ptr<ushort>(y)[x] & bit_));
    }

private:
    const EdgeMap& edges_;
    ushort bit_;
};

Moments momentsOf(const Support& support, Size image, const Line& line)
{
    Moments sum = {0, 0, 0, 0, 0, 0};
    forEachPixelNear(image, line, SUPPORT_DISTANCE,
                     [&](int64 x, int64 y)
                     {
                         if (!support.has((int)x, (int)y))
                             return;
                         ++sum.n;
                         sum.x += x;
                         sum.y += y;
                         sum.xx += x * x;
                         sum.xy += x * y;
                         sum.yy += y * y;
                     });
    return sum;
}

//! The line with the smallest sum of squared distances; false if it is not determined.
bool fitLine(const Moments& m, Line& line)
{
    if (m.n < 2)
        return false;
    // Taken about the pixel nearest to the mean, in integers, where nothing cancels; what is left to
    // subtract is small.
    const int64 x0 = (2 * m.x + m.n) / (2 * m.n), y0 = (2 * m.y + m.n) / (2 * m.n);
    const double n = (double)m.n, dx = (m.x - m.n * x0) / n, dy = (m.y - m.n * y0) / n;
    const double x = x0 + dx, y = y0 + dy;
    const double xx = (m.xx - 2 * x0 * m.x + m.n * x0 * x0) / n - dx * dx,
                 xy = (m.xy - x0 * m.y - y0 * m.x + m.n * x0 * y0) / n - dx * dy,
                 yy = (m.yy - 2 * y0 * m.y + m.n * y0 * y0) / n - dy * dy;
    if (xx == yy && xy == 0)
        return false;
    const double along = 0.5 * std::atan2(2 * xy, xx - yy); // direction of the largest variance
    line.theta = along + CV_PI / 2;                         // in [0, pi]
    line.rho = x * std::cos(line.theta) + y * std::sin(line.theta);
    return true;
}

} // namespace

Line refineLine(const EdgeMap& edges, ushort bit, const Line& line)
{
    Ends ends;
    if (!clipLine(std::cos(line.theta), std::sin(line.theta), line.rho, edges.votes.size(), ends))
        return line;
    Line refined = line;
    const Support support(edges, bit);
    Moments last = {0, 0, 0, 0, 0, 0};
    for (int i = 0; i < MAX_ITERATIONS; ++i)
    {
        const Moments moments = momentsOf(support, edges.votes.size(), refined);
        if (moments == last || !fitLine(moments, refined))
            break;
        last = moments;
    }
    const double cosine = std::cos(refined.theta), sine = std::sin(refined.theta);
    const bool moved = std::abs(cosine * ends.first.x + sine * ends.first.y - refined.rho) > 1 ||
                       std::abs(cosine * ends.second.x + sine * ends.second.y - refined.rho) > 1;
    return moved ? line : refined;
}

void removeSupport(EdgeMap& edges, ushort bit, const Line& line)
{
    const Support support(edges, bit);
    forEachPixelNear(edges.votes.size(), line, EXPLAINED_DISTANCE,
                     [&](int x, int y)
                     {
                         if (support.has(x, y))
                             edges.votes.ptr<uchar>(y)[x] = 0;
                     });
}

} // namespace linespace
} // namespace cv
