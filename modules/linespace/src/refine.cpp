// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "refine.hpp"

#include "edge_profile.hpp"

namespace cv {
namespace linespace {

namespace {

const double EXPLAINED_DISTANCE =
    2; // pixels; what a thick or slightly bent edge leaves beside its line
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

//! The edge pixels that carry the bit within a distance of a line, in the order of its columns.
std::vector<Point> supportersWithin(double reach, const EdgeMap& edges, ushort bit,
                                    const Line& line)
{
    const Columns columns(edges.votes.size(), line);
    const Support support(edges, bit, columns);
    std::vector<Point> result;
    columns.forEachWithin(reach,
                          [&](int i, int k)
                          {
                              if (support.has(i, k))
                                  result.push_back(columns.pixel(i, k));
                          });
    return result;
}

double distance(double cosine, double sine, double rho, const Point& pixel)
{
    return pixel.x * cosine + pixel.y * sine - rho;
}

//! The moments of those of some pixels that support a line. Few change from a line to the next.
class SupportMoments
{
public:
    explicit SupportMoments(const std::vector<Point>& pixels)
        : pixels_(pixels), supports_(pixels.size(), 0)
    {
        const Moments none = {0, 0, 0, 0, 0, 0};
        sum_ = none;
    }
    const Moments& of(const Line& line)
    {
        const double cosine = std::cos(line.theta), sine = std::sin(line.theta);
        for (size_t j = 0; j < pixels_.size(); ++j)
        {
            const bool supports =
                std::abs(distance(cosine, sine, line.rho, pixels_[j])) <= SUPPORT_DISTANCE;
            if (supports == (bool)supports_[j])
                continue;
            sum_.add(pixels_[j], supports ? 1 : -1);
            supports_[j] = supports;
        }
        return sum_;
    }

private:
    const std::vector<Point>& pixels_;
    std::vector<uchar> supports_;
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
bool covarianceOf(Size image, const std::vector<Point>& supporters, const Line& line,
                  Covariance& covariance)
{
    const Columns columns(image, line);
    const double middle = 0.5 * (columns.length - 1);
    const ColumnScore nothing = {0, 0, 0};
    std::vector<ColumnScore> scores(columns.length, nothing);
    for (size_t j = 0; j < supporters.size(); ++j)
    {
        const int i = columns.xMajor ? supporters[j].x : supporters[j].y,
                  k = columns.xMajor ? supporters[j].y : supporters[j].x;
        const double offset = columns.distance(i, k);
        if (std::abs(offset) > SUPPORT_DISTANCE)
            continue;
        scores[i].t = i - middle;
        scores[i].score += offset;
        ++scores[i].sensitivity;
    }
    scores.erase(std::remove_if(scores.begin(), scores.end(),
                                [](const ColumnScore& score) { return score.sensitivity == 0; }),
                 scores.end());
    OffsetCovariance result;
    if (!offsetCovariance(scores, result))
        return false;
    // Where the line keeps to one row of pixels, their residuals are all alike and say nothing: an
    // edge anywhere within the row looks the same. Each row passed is one more such observation,
    // evenly spread over the length between the first and the last column, about their middle.
    const double length = scores.back().t - scores.front().t + 1,
                 centre = 0.5 * (scores.front().t + scores.back().t);
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
bool fitEdgePixels(const EdgeMap& edges, ushort bit, const FittedLine& line, FittedLine& fitted)
{
    CV_DbgAssert(std::max(edges.votes.cols, edges.votes.rows) <= 1 << 20); // see Moments
    // Also those of a line that moves by up to TOO_FAR at its ends.
    const std::vector<Point> supporters =
        supportersWithin(SUPPORT_DISTANCE + TOO_FAR, edges, bit, line.line);
    fitted = line;
    SupportMoments support(supporters);
    Moments last = {0, 0, 0, 0, 0, 0};
    for (int i = 0; i < MAX_FITS; ++i)
    {
        const Moments moments = support.of(fitted.line);
        if (moments == last || !fitMoments(moments, fitted.line))
            break;
        last = moments;
    }
    if (last.n == 0)
        return false;
    covarianceOf(edges.votes.size(), supporters, fitted.line, fitted.covariance);
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

FittedLine refineLine(const EdgeMap& edges, ushort bit, const FittedLine& chord)
{
    Ends ends;
    if (!clipLine(std::cos(chord.line.theta), std::sin(chord.line.theta), chord.line.rho,
                  edges.votes.size(), ends))
        return chord;
    FittedLine best = chord, fitted;
    if (fitEdgePixels(edges, bit, best, fitted))
        takeWithinReach(ends, fitted, best);
    if (!edges.dx.empty() && fitGradients(edges, bit, best, fitted))
        takeWithinReach(ends, fitted, best);
    return best;
}

std::vector<Point> explainedPixels(const EdgeMap& edges, ushort bit, const Line& line)
{
    return supportersWithin(EXPLAINED_DISTANCE, edges, bit, line);
}

} // namespace linespace
} // namespace cv
