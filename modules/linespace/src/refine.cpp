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
const int MAX_ITERATIONS = 10;

//! Moments of the supporting pixels; integers, so that they do not depend on the order of
//! summation.
struct Moments
{
    int64 n, x, y, xx, xy, yy;

    void add(int64 px, int64 py)
    {
        ++n;
        x += px;
        y += py;
        xx += px * px;
        xy += px * py;
        yy += py * py;
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

Moments momentsOf(const std::vector<Point>& supporters, const Line& line)
{
    const double cosine = std::cos(line.theta), sine = std::sin(line.theta);
    Moments sum = {0, 0, 0, 0, 0, 0};
    for (size_t i = 0; i < supporters.size(); ++i)
        if (std::abs(distance(cosine, sine, line.rho, supporters[i])) <= SUPPORT_DISTANCE)
            sum.add(supporters[i].x, supporters[i].y);
    return sum;
}

//! The line with the smallest sum of squared distances; false if it is not determined.
bool fitMoments(const Moments& m, Line& line)
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

//! What the supporting pixels say of a line, and the grid of pixels besides.
bool covarianceOf(Size image, const std::vector<Point>& supporters, const Line& line,
                  Covariance& covariance)
{
    const Columns columns(image, line);
    const double middle = 0.5 * (columns.length - 1);
    std::vector<ColumnScore> scores;
    for (size_t i = 0; i < supporters.size(); ++i)
    {
        const Point pixel = supporters[i];
        const int column = columns.xMajor ? pixel.x : pixel.y;
        const double offset = columns.distance(column, columns.xMajor ? pixel.y : pixel.x);
        const ColumnScore score = {column - middle, offset, 1};
        if (std::abs(offset) <= SUPPORT_DISTANCE)
            scores.push_back(score);
    }
    std::sort(scores.begin(), scores.end(),
              [](const ColumnScore& a, const ColumnScore& b) { return a.t < b.t; });
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

/** Total least squares on edge pixels. */
bool fitEdgePixels(const EdgeMap& edges, ushort bit, const Line& line, FittedLine& fitted)
{
    // Also those of a line that moves by up to TOO_FAR at its ends.
    const std::vector<Point> supporters =
        supportersWithin(SUPPORT_DISTANCE + TOO_FAR, edges, bit, line);
    Line refined = line;
    Moments last = {0, 0, 0, 0, 0, 0};
    for (int i = 0; i < MAX_ITERATIONS; ++i)
    {
        const Moments moments = momentsOf(supporters, refined);
        if (moments == last || !fitMoments(moments, refined))
            break;
        last = moments;
    }
    fitted.line = refined;
    return last.n > 0 && covarianceOf(edges.votes.size(), supporters, refined, fitted.covariance);
}

/** Takes a fit of the line between two ends, if it moves these by TOO_FAR at most: as it is, or if it
moves one by more than MOST_MOVED, as far as that on the way to it. */
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
    if (fitEdgePixels(edges, bit, best.line, fitted))
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
