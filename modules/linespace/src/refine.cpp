// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "refine.hpp"

#include "edge_profile.hpp"

#include <limits>

namespace cv {
namespace linespace {

namespace {

// Pixels; what a thick or slightly bent edge leaves beside its line.
const double EXPLAINED_DISTANCE = 2 + TIE;
const double MOST_MOVED = 0.999; // pixels at the ends inside the image: less than one when rounded
const double TOO_FAR = 2;        // pixels at the ends; a fit that far away is of something else
const int MAX_FITS = 10;         // of edge pixels, each to those near the line before

/** Moments of the supporting pixels; integers, so that they do not depend on the order of
summation. A line has three of them in each of its columns at most, so in an image of n pixels a
side no sum is larger than 3 n^3, and nothing that fitMoments makes of them larger than 6 n^3: less
than 2^63 up to n = 2^20. (A table of votes of that size has more than 2^40 entries.) */
struct Moments
{
    int64 n, x, y, xx, xy, yy;

    void add(const Point& pixel, int sign)
    {
        const int64 px = pixel.x, py = pixel.y;
        n += sign;
        x += sign * px;
        y += sign * py;
        xx += sign * px * px;
        xy += sign * px * py;
        yy += sign * py * py;
    }
    bool operator==(const Moments& other) const
    {
        return n == other.n && x == other.x && y == other.y && xx == other.xx && xy == other.xy &&
               yy == other.yy;
    }
};

/** Edge pixels around a line, and the moments of those that support it, or another line near it.
Few change from a line to the next. */
class Supporters
{
public:
    //! Those within a distance of the line, in the order of its columns.
    Supporters(double reach, const Support& support, const Columns& columns) : count_(0)
    {
        std::vector<double>&along = columns.xMajor ? x_ : y_, &across = columns.xMajor ? y_ : x_;
        columns.forEachWithin(reach, support,
                              [&](int i, int k, int mask)
                              {
                                  if (count_ + Support::WINDOW > x_.size())
                                  {
                                      x_.resize(2 * count_ + 512);
                                      y_.resize(x_.size());
                                  }
                                  for (; mask != 0; mask &= mask - 1, ++count_)
                                  {
                                      along[count_] = i;
                                      across[count_] = k + (int)trailingZeros32(mask);
                                  }
                              });
        const size_t groups = (count_ + GROUP - 1) / GROUP;
        x_.resize(groups * GROUP);
        y_.resize(groups * GROUP);
        // What fills the last group is near no line.
        std::fill(x_.begin() + count_, x_.end(), std::numeric_limits<double>::quiet_NaN());
        near_.resize(groups);
        const Moments none = {0, 0, 0, 0, 0, 0};
        sum_ = none;
    }
    size_t count() const { return count_; }
    Point pixel(size_t j) const { return Point((int)x_[j], (int)y_[j]); }

    //! The moments of those that support a line.
    const Moments& momentsOf(const Line& line)
    {
        forEachGroup(line,
                     [this](size_t group, int near)
                     {
                         int changed = near ^ near_[group];
                         near_[group] = (uchar)near;
                         for (; changed != 0; changed &= changed - 1)
                         {
                             const int b = (int)trailingZeros32(changed);
                             sum_.add(pixel(group * GROUP + b), near >> b & 1 ? 1 : -1);
                         }
                     });
        return sum_;
    }
    //! Calls visit(pixel) for those that support a line.
    template<class Visit>
    void forEachOf(const Line& line, Visit visit) const
    {
        forEachGroup(line,
                     [&](size_t group, int near)
                     {
                         for (; near != 0; near &= near - 1)
                             visit(pixel(group * GROUP + trailingZeros32(near)));
                     });
    }

private:
    enum
    {
        GROUP = 8
    };
    //! Calls visit(group, near), where bit b tells whether the group's pixel b supports the line.
    template<class Visit>
    void forEachGroup(const Line& line, Visit visit) const
    {
        const double cosine = std::cos(line.theta), sine = std::sin(line.theta);
        for (size_t group = 0; group < near_.size(); ++group)
        {
            const double *const x = &x_[group * GROUP], *const y = &y_[group * GROUP];
            int near = 0;
#if LINESPACE_SIMD128_64F
            const v_float64x2 cosines = v_setall_f64(cosine), sines = v_setall_f64(sine),
                              rho = v_setall_f64(line.rho), most = v_setall_f64(SUPPORT_DISTANCE);
            for (int b = 0; b < GROUP; b += 2)
            {
                const v_float64x2 across =
                    v_add(v_mul(v_load(x + b), cosines), v_mul(v_load(y + b), sines));
                near |= v_signmask(v_le(v_abs(v_sub(across, rho)), most)) << b;
            }
#else
            for (int b = 0; b < GROUP; ++b)
                near |= (std::abs(x[b] * cosine + y[b] * sine - line.rho) <= SUPPORT_DISTANCE) << b;
#endif
            visit(group, near);
        }
    }

    size_t count_;
    std::vector<double> x_, y_; // in groups
    std::vector<uchar> near_;   // those whose moments are summed up; a bit each
    Moments sum_;
};

//! The line with the smallest sum of squared distances; false if it is not determined.
bool fitMoments(const Moments& m, Line& line)
{
    if (m.n < 2)
        return false;
    // Taken about the pixel nearest to the mean, in integers, where nothing cancels; what is left
    // to subtract is small.
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

//! What the supporting pixels say of a line, and the grid of pixels besides; false if nothing.
bool covarianceOf(Size image, const Supporters& supporters, const Line& line,
                  Covariance& covariance)
{
    const Columns columns(image, line);
    const double middle = 0.5 * (columns.length - 1);
    const ColumnScore nothing = {0, 0};
    std::vector<ColumnScore> scores(columns.length, nothing);
    int first = columns.length, last = 0;
    supporters.forEachOf(line,
                         [&](Point pixel)
                         {
                             const int i = columns.xMajor ? pixel.x : pixel.y,
                                       k = columns.xMajor ? pixel.y : pixel.x;
                             first = std::min(first, i);
                             last = std::max(last, i);
                             scores[i].score += columns.distance(i, k);
                             ++scores[i].sensitivity;
                         });
    OffsetCovariance result;
    if (!offsetCovariance(-middle, scores, result))
        return false;
    // Where the line keeps to one row of pixels, their residuals are all alike and say nothing: an
    // edge anywhere within the row looks the same. Each row passed is one more such observation,
    // evenly spread over the length between the first and the last column, about their middle.
    const double length = last - first + 1, centre = 0.5 * (first + last) - middle;
    const double rows = 1 + length * std::abs(columns.major / columns.minor);
    const double position = columns.minor * columns.minor / 12 / rows,
                 slope = 12 * position / (length * length);
    result.aa += position + centre * centre * slope;
    result.ab -= centre * slope;
    result.bb += slope;
    covariance = polarCovariance(columns, middle, line, result);
    return true;
}

/** Total least squares on edge pixels; keeps the line's covariance where they say nothing of it. */
bool fitEdgePixels(const Support& support, Size image, const FittedLine& line, FittedLine& fitted)
{
    CV_DbgAssert(std::max(image.width, image.height) <= 1 << 20); // see Moments
    // Also those of a line that moves by up to TOO_FAR at its ends.
    Supporters supporters(SUPPORT_DISTANCE + TOO_FAR, support, Columns(image, line.line));
    fitted = line;
    Moments last = {0, 0, 0, 0, 0, 0};
    for (int i = 0; i < MAX_FITS; ++i)
    {
        const Moments moments = supporters.momentsOf(fitted.line);
        if (moments == last || !fitMoments(moments, fitted.line))
            break;
        last = moments;
    }
    if (last.n == 0)
        return false;
    covarianceOf(image, supporters, fitted.line, fitted.covariance);
    return true;
}

/** Takes a fit of the line between two ends, if it moves these by TOO_FAR at most: as it is, or if
it moves one by more than MOST_MOVED, as far as that on the way to it. The covariance is that of the
fit in either case: how well its pixels determine a line does not change with half a pixel. */
void takeWithinReach(const Ends& ends, const FittedLine& fitted, FittedLine& best)
{
    const double cosine = std::cos(fitted.line.theta), sine = std::sin(fitted.line.theta);
    const double first = fitted.line.rho - cosine * ends.first.x - sine * ends.first.y,
                 second = fitted.line.rho - cosine * ends.second.x - sine * ends.second.y;
    const double farther = std::max(std::abs(first), std::abs(second));
    if (!(farther <= TOO_FAR))
        return;
    best = fitted;
    if (farther <= MOST_MOVED)
        return;
    const double share = MOST_MOVED / farther;
    const Point2d p = ends.first + share * first * Point2d(cosine, sine),
                  q = ends.second + share * second * Point2d(cosine, sine);
    // Next to the fitted angle.
    const double turn =
        std::atan2((q - p).dot(Point2d(cosine, sine)), (q - p).dot(Point2d(-sine, cosine)));
    best.line.theta += std::abs(turn) > CV_PI / 2 ? std::copysign(CV_PI, turn) - turn : -turn;
    best.line.rho = p.x * std::cos(best.line.theta) + p.y * std::sin(best.line.theta);
}

} // namespace

FittedLine chordLine(const Cell& frame, Chord chord)
{
    FittedLine result;
    result.line = lineOf(frame, chord);
    // Either end is anywhere within half a border edge, with the variance 1/12 along its side; the
    // line's offset there changes by the normal's component along that side.
    const Columns columns(Size(frame.width, frame.height), result.line);
    const double middle = 0.5 * (columns.length - 1);
    const int ends[2] = {chord.s, chord.e};
    double t[2], variance[2];
    for (int i = 0; i < 2; ++i)
    {
        const Point doubled = frame.borderPoint(ends[i]); // pixel (0, 0) has its centre at (1, 1)
        t[i] = 0.5 * ((columns.xMajor ? doubled.x : doubled.y) - 1) - middle;
        const int side = frame.sideOf(ends[i]);
        const bool alongX = side == SIDE_TOP || side == SIDE_BOTTOM;
        const double component = alongX == columns.xMajor ? columns.major : columns.minor;
        variance[i] = component * component / 12;
    }
    // The line through two independent points.
    const double square = (t[1] - t[0]) * (t[1] - t[0]);
    const OffsetCovariance covariance = {
        (t[1] * t[1] * variance[0] + t[0] * t[0] * variance[1]) / square,
        -(t[1] * variance[0] + t[0] * variance[1]) / square, (variance[0] + variance[1]) / square};
    result.covariance = polarCovariance(columns, middle, result.line, covariance);
    return result;
}

namespace {

//! Whether the chord's line passes the image; where.
bool isVisible(Size image, const FittedLine& chord, Ends& ends)
{
    return clipLine(std::cos(chord.line.theta), std::sin(chord.line.theta), chord.line.rho, image,
                    ends);
}

} // namespace

FittedLine refineLine(const EdgeMap& edges, const EdgePlanes& planes, int bin,
                      const FittedLine& chord)
{
    Ends ends;
    const Size image = edges.votes.size();
    if (!isVisible(image, chord, ends))
        return chord;
    FittedLine best = chord, fitted;
    if (fitEdgePixels(Support(planes, bin, Columns(image, chord.line).xMajor), image, best, fitted))
        takeWithinReach(ends, fitted, best);
    if (!edges.dx.empty() && fitGradients(edges, planes, bin, best, fitted))
        takeWithinReach(ends, fitted, best);
    return best;
}

FittedLine refineLine(Size image, const EdgeBits& bits, const FittedLine& chord)
{
    Ends ends;
    if (!isVisible(image, chord, ends))
        return chord;
    FittedLine best = chord, fitted;
    if (fitEdgePixels(Support(bits, Columns(image, chord.line).xMajor), image, best, fitted))
        takeWithinReach(ends, fitted, best);
    return best;
}

std::vector<Point> explainedPixels(const EdgePlanes& planes, Size image, int bin, const Line& line)
{
    const Columns columns(image, line);
    const Supporters explained(EXPLAINED_DISTANCE, Support(planes, bin, columns.xMajor), columns);
    std::vector<Point> result(explained.count());
    for (size_t j = 0; j < result.size(); ++j)
        result[j] = explained.pixel(j);
    return result;
}

} // namespace linespace
} // namespace cv
