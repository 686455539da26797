// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// See brute_force.hpp. Everything is evaluated from coordinates, nothing from index arithmetic, so
// that a mistake in the library's numbering of the border has no counterpart here.

#include "test_precomp.hpp"

#include "brute_force.hpp"

namespace opencv_test {
namespace brute {

namespace {

int64 floorDivide(int64 numerator, int64 denominator)
{
    if (denominator < 0)
    {
        numerator = -numerator;
        denominator = -denominator;
    }
    int64 quotient = numerator / denominator;
    if (quotient * denominator > numerator)
        --quotient;
    return quotient;
}

//! The cell's own pixels: level 0 counts nothing outside.
void rasterInside(const Rect& cell, const Doubled& p, const Doubled& q,
                  std::vector<BinnedPixel>& pixels)
{
    const std::vector<Step> steps = raster(p, q);
    const int bin = directionBin(q - p);
    for (size_t i = 0; i < steps.size(); ++i)
        if (cell.contains(steps[i].pixel))
        {
            const BinnedPixel pixel = {steps[i].pixel, bin};
            pixels.push_back(pixel);
        }
}

void walk(const Cascade& cascade, int level, const Rect& cell, const Doubled& p, const Doubled& q,
          std::vector<BinnedPixel>& pixels)
{
    if (level == 0)
    {
        rasterInside(cell, p, q, pixels);
        return;
    }
    const bool columns = cascade.mergesColumns(level);
    Rect first = cell, second = cell;
    int64 seam; // the shared side, doubled
    if (columns)
    {
        first.width = second.width = cell.width / 2;
        second.x += first.width;
        seam = 2 * second.x;
    }
    else
    {
        first.height = second.height = cell.height / 2;
        second.y += first.height;
        seam = 2 * second.y;
    }
    const bool pFirst = (columns ? p.x : p.y) < seam;
    const bool qFirst = (columns ? q.x : q.y) < seam;
    if (pFirst == qFirst)
    {
        walk(cascade, level - 1, pFirst ? first : second, p, q, pixels);
        return;
    }
    const int64 dx = q.x - p.x, dy = q.y - p.y;
    Doubled crossing;
    if (columns)
        crossing = Doubled(seam, 2 * floorDivide(p.y * dx + dy * (seam - p.x), 2 * dx) + 1);
    else
        crossing = Doubled(2 * floorDivide(p.x * dy + dx * (seam - p.y), 2 * dy) + 1, seam);
    walk(cascade, level - 1, pFirst ? first : second, p, crossing, pixels);
    walk(cascade, level - 1, pFirst ? second : first, crossing, q, pixels);
}

bool isNeighbour(int a, int b, int borderPoints, int radius)
{
    const int distance = std::abs(a - b);
    return std::min(distance, borderPoints - distance) <= radius;
}

} // namespace

int borderCount(const Size& cell)
{
    return 2 * (cell.width + cell.height);
}

Doubled borderPoint(const Size& cell, int index)
{
    const int w = cell.width, h = cell.height;
    if (index < w)
        return Doubled(2 * index + 1, 0);
    if (index < w + h)
        return Doubled(2 * w, 2 * (index - w) + 1);
    if (index < 2 * w + h)
        return Doubled(2 * w - (2 * (index - w - h) + 1), 2 * h);
    return Doubled(0, 2 * h - (2 * (index - 2 * w - h) + 1));
}

int borderIndex(const Size& cell, const Doubled& point)
{
    for (int index = 0; index < borderCount(cell); ++index)
        if (borderPoint(cell, index) == point)
            return index;
    return -1;
}

int borderSide(const Size& cell, int index)
{
    const Doubled point = borderPoint(cell, index);
    if (point.y == 0)
        return 0;
    if (point.x == 2 * cell.width)
        return 1;
    return point.y == 2 * cell.height ? 2 : 3;
}

bool isChord(const Size& cell, int s, int e)
{
    return borderSide(cell, s) != borderSide(cell, e);
}

bool stepsAlongX(const Doubled& p, const Doubled& q, DiagonalRule rule)
{
    const int64 dx = std::abs(q.x - p.x), dy = std::abs(q.y - p.y);
    return dx > dy || (dx == dy && rule == DIAGONAL_STEPS_X);
}

std::vector<Step> raster(const Doubled& p, const Doubled& q, DiagonalRule rule)
{
    const bool alongX = stepsAlongX(p, q, rule);
    const int64 major0 = alongX ? p.x : p.y, minor0 = alongX ? p.y : p.x;
    const int64 dMajor = (alongX ? q.x : q.y) - major0, dMinor = (alongX ? q.y : q.x) - minor0;
    const int64 first = std::min(major0, major0 + dMajor), last = std::max(major0, major0 + dMajor);
    std::vector<Step> steps;
    for (int64 centre = first | 1; centre <= last; centre += 2)
    {
        // Minor coordinate in pixels at the centre, half of
        // minor0 + dMinor (centre - major0) / dMajor.
        const int64 numerator = minor0 * dMajor + dMinor * (centre - major0);
        const int minor = (int)floorDivide(numerator, 2 * dMajor);
        const int major = (int)(centre / 2);
        Step step;
        step.pixel = alongX ? Point(major, minor) : Point(minor, major);
        step.tie = numerator == 2 * dMajor * minor;
        steps.push_back(step);
    }
    return steps;
}

int pixelValue(const Mat& edges, const Point& pixel, bool weighted)
{
    if (!Rect(Point(), edges.size()).contains(pixel))
        return 0;
    const int value = edges.at<uchar>(pixel);
    return weighted ? value : value != 0;
}

int directionBin(const Doubled& direction)
{
    const bool isDown = direction.y > 0 || (direction.y == 0 && direction.x > 0);
    const int64 x = isDown ? direction.x : -direction.x, y = isDown ? direction.y : -direction.y;
    for (int bin = 15; bin > 0; --bin)
    {
        const double end = bin * CV_PI / 16;
        if (cvRound(32768 * std::cos(end)) * y >= cvRound(32768 * std::sin(end)) * x)
            return bin;
    }
    return 0;
}

bool votesForBin(const Point2d& gradient, int bin, double tolerance)
{
    int64 x = cvRound(gradient.x), y = cvRound(gradient.y);
    const bool isShort = gradient.x == saturate_cast<short>(gradient.x) &&
                         gradient.y == saturate_cast<short>(gradient.y);
    if (!isShort)
    {
        Point2d scaled = gradient;
        while (std::max(std::abs(scaled.x), std::abs(scaled.y)) >= 32768)
            scaled *= 0.5;
        while (std::max(std::abs(scaled.x), std::abs(scaled.y)) < 16384)
            scaled *= 2.;
        x = std::min(cvRound(scaled.x), 32767);
        y = std::min(cvRound(scaled.y), 32767);
    }
    const double centre = (bin + 0.5) * CV_PI / 16, sine = std::sin(tolerance * CV_PI / 180);
    const int64 product =
        x * cvRound(16384 * std::cos(centre)) + y * cvRound(16384 * std::sin(centre));
    return tolerance >= 90 ||
           product * product <= cvRound(sine * sine * (1 << 28)) * (x * x + y * y);
}

Mat1w directions(const Mat& dx, const Mat& dy, double tolerance)
{
    Mat realX, realY;
    dx.convertTo(realX, CV_64F);
    dy.convertTo(realY, CV_64F);
    Mat1w bits(dx.size(), (ushort)0);
    for (int y = 0; y < dx.rows; ++y)
        for (int x = 0; x < dx.cols; ++x)
            for (int bin = 0; bin < 16; ++bin)
                if (votesForBin(Point2d(realX.at<double>(y, x), realY.at<double>(y, x)), bin,
                                tolerance))
                    bits(y, x) |= (ushort)(1 << bin);
    return bits;
}

//! The value of a pixel that votes for the bin.
static int pixelVotes(const Mat& edges, const Point& pixel, int bin, bool weighted,
                      const Mat& directions)
{
    const int value = pixelValue(edges, pixel, weighted);
    return directions.empty() || value == 0 || (directions.at<ushort>(pixel) >> bin & 1) ? value
                                                                                         : 0;
}

int chordVotes(const Mat& edges, const Size& frame, int s, int e, bool weighted,
               const Mat& directions)
{
    if (!isChord(frame, s, e))
        return 0;
    const Doubled p = borderPoint(frame, s), q = borderPoint(frame, e);
    const std::vector<Step> steps = raster(p, q);
    const int bin = directionBin(q - p);
    int votes = 0;
    for (size_t i = 0; i < steps.size(); ++i)
        votes += pixelVotes(edges, steps[i].pixel, bin, weighted, directions);
    return votes;
}

Mat1i exactTable(const Mat& edges, const Size& frame, bool weighted, const Mat& directions)
{
    const int points = borderCount(frame);
    Mat1i table(points, points, 0);
    for (int s = 0; s < points; ++s)
        for (int e = s + 1; e < points; ++e)
            table(s, e) = table(e, s) = chordVotes(edges, frame, s, e, weighted, directions);
    return table;
}

Axis axisOf(int pixels, int wantedCell)
{
    Axis best = {0, 0};
    for (int merges = 0; merges < 31; ++merges)
    {
        const int64 parts = (int64)1 << merges;
        const int cell = (int)((pixels + parts - 1) / parts);
        // An axis that is too short for half a wanted cell is one cell.
        const bool isAllowed = cell <= 3 * wantedCell && (2 * cell >= wantedCell || merges == 0);
        if (!isAllowed)
            continue;
        const int64 frame = cell * parts;
        const int64 bestFrame = (int64)best.cell << best.merges;
        // max / min of the two cell sizes, compared without a division
        const int64 up = std::max(cell, wantedCell), down = std::min(cell, wantedCell);
        const int64 bestUp = std::max(best.cell, wantedCell);
        const int64 bestDown = std::min(best.cell, wantedCell);
        const bool isNearer =
            up * bestDown < bestUp * down || (up * bestDown == bestUp * down && cell < best.cell);
        if (best.cell == 0 || frame < bestFrame || (frame == bestFrame && isNearer))
        {
            best.cell = cell;
            best.merges = merges;
        }
    }
    CV_Assert(best.cell > 0);
    return best;
}

bool Cascade::mergesColumns(int level) const
{
    const int both = 2 * std::min(x.merges, y.merges);
    if (level <= both)
        return level % 2 == 1;
    return x.merges > y.merges;
}

int Cascade::columnMerges(int level) const
{
    int count = 0;
    for (int merge = 1; merge <= level; ++merge)
        count += mergesColumns(merge);
    return count;
}

Size Cascade::cellSize(int level) const
{
    const int columns = columnMerges(level);
    return Size(x.cell << columns, y.cell << (level - columns));
}

Size Cascade::gridSize(int level) const
{
    const Size cell = cellSize(level);
    return Size(frame().width / cell.width, frame().height / cell.height);
}

Cascade cascadeOf(const Size& image, int wantedCell)
{
    Cascade cascade;
    cascade.x = axisOf(image.width, wantedCell);
    cascade.y = axisOf(image.height, wantedCell);
    return cascade;
}

void cascadePixels(const Cascade& cascade, int level, const Point& cell, int s, int e,
                   std::vector<BinnedPixel>& pixels)
{
    const Size size = cascade.cellSize(level);
    pixels.clear();
    if (!isChord(size, s, e))
        return;
    const Rect rect(Point(cell.x * size.width, cell.y * size.height), size);
    const Doubled origin(2 * rect.x, 2 * rect.y);
    walk(cascade, level, rect, borderPoint(size, s) + origin, borderPoint(size, e) + origin,
         pixels);
}

Mat1i cascadeTable(const Mat& edges, const Cascade& cascade, int level, bool weighted,
                   const Mat& directions)
{
    const Size grid = cascade.gridSize(level);
    const int points = borderCount(cascade.cellSize(level));
    Mat1i table(grid.height * points, grid.width * points, 0);
    std::vector<BinnedPixel> pixels;
    for (int row = 0; row < grid.height; ++row)
        for (int column = 0; column < grid.width; ++column)
            for (int s = 0; s < points; ++s)
                for (int e = s + 1; e < points; ++e)
                {
                    cascadePixels(cascade, level, Point(column, row), s, e, pixels);
                    int votes = 0;
                    for (size_t i = 0; i < pixels.size(); ++i)
                        votes +=
                            pixelVotes(edges, pixels[i].pixel, pixels[i].bin, weighted, directions);
                    table(row * points + s, column * points + e) = votes;
                    table(row * points + e, column * points + s) = votes;
                }
    return table;
}

bool isStronger(const Candidate& a, const Candidate& b)
{
    if (a.votes != b.votes)
        return a.votes > b.votes;
    return a.s != b.s ? a.s < b.s : a.e < b.e;
}

std::vector<Candidate> chordsAbove(const Mat1i& table, const Size& frame, double minVotes)
{
    std::vector<Candidate> all;
    for (int s = 0; s < table.rows; ++s)
        for (int e = s + 1; e < table.cols; ++e)
            if (table(s, e) > minVotes && isChord(frame, s, e))
            {
                const Candidate candidate = {s, e, table(s, e)};
                all.push_back(candidate);
            }
    return all;
}

std::vector<Candidate> ringMaxima(const Mat1i& table, const std::vector<Candidate>& all, int radius)
{
    const int points = table.rows;
    std::vector<Candidate> kept;
    for (size_t i = 0; i < all.size(); ++i)
    {
        const Candidate& candidate = all[i];
        bool beaten = false;
        for (int ds = -radius; ds <= radius; ++ds)
            for (int de = -radius; de <= radius; ++de)
            {
                const int s = (candidate.s + ds % points + points) % points;
                const int e = (candidate.e + de % points + points) % points;
                // The mirrored entry (e, s) is the same chord.
                const Candidate other = {std::min(s, e), std::max(s, e), table(s, e)};
                beaten |= isStronger(other, candidate);
            }
        if (!beaten)
            kept.push_back(candidate);
    }
    return kept;
}

std::vector<Candidate> blockMaxima(const std::vector<Candidate>& all, int radius)
{
    int side = 1;
    while (side < 2 * radius + 1)
        side *= 2;
    std::map<std::pair<int, int>, Candidate> best;
    for (size_t i = 0; i < all.size(); ++i)
    {
        const std::pair<int, int> block(all[i].s / side, all[i].e / side);
        if (best.find(block) == best.end() || isStronger(all[i], best[block]))
            best[block] = all[i];
    }
    std::vector<Candidate> kept;
    for (std::map<std::pair<int, int>, Candidate>::const_iterator it = best.begin();
         it != best.end(); ++it)
        kept.push_back(it->second);
    return kept;
}

std::vector<Candidate> greedyMaxima(const std::vector<Candidate>& all, int borderPoints, int radius)
{
    std::vector<Candidate> sorted = all, kept;
    std::sort(sorted.begin(), sorted.end(), isStronger);
    for (size_t i = 0; i < sorted.size(); ++i)
    {
        const Candidate& c = sorted[i];
        bool deleted = false;
        for (size_t j = 0; j < kept.size() && !deleted; ++j)
        {
            const Candidate& k = kept[j];
            deleted = (isNeighbour(c.s, k.s, borderPoints, radius) &&
                       isNeighbour(c.e, k.e, borderPoints, radius)) ||
                      (isNeighbour(c.s, k.e, borderPoints, radius) &&
                       isNeighbour(c.e, k.s, borderPoints, radius));
        }
        if (!deleted)
            kept.push_back(c);
    }
    return kept;
}

Vec2d lineOf(const Size& frame, int s, int e, double minTheta)
{
    const Doubled p = borderPoint(frame, s), q = borderPoint(frame, e);
    const double nx = -(double)(q.y - p.y), ny = (double)(q.x - p.x);
    double theta = std::atan2(ny, nx);
    // A pixel's centre is (0.5, 0.5) here and (0, 0) in OpenCV: doubled, that is 1.
    double rho = (nx * (p.x - 1) + ny * (p.y - 1)) / (2 * std::sqrt(nx * nx + ny * ny));
    const double halfTurns = std::floor((theta - minTheta) / CV_PI);
    theta -= halfTurns * CV_PI;
    if (std::fmod(std::abs(halfTurns), 2) == 1)
        rho = -rho;
    return Vec2d(rho, theta);
}

bool chordOf(const Size& frame, const Vec3f& line, int& s, int& e)
{
    Point2d ends[2];
    if (!clipLine(Vec2d(line[0], line[1]), frame, ends))
        return false;
    // The rounding of (rho, theta) moves a shallow end along its side by a part of a pixel: try the
    // points around.
    std::vector<int> near[2];
    for (int index = 0; index < borderCount(frame); ++index)
    {
        const Doubled point = borderPoint(frame, index);
        for (int end = 0; end < 2; ++end)
            if (std::abs(0.5 * (point.x - 1) - ends[end].x) < 1.5 &&
                std::abs(0.5 * (point.y - 1) - ends[end].y) < 1.5)
                near[end].push_back(index);
    }
    double best = DBL_MAX;
    for (size_t i = 0; i < near[0].size(); ++i)
        for (size_t j = 0; j < near[1].size(); ++j)
        {
            const int first = std::min(near[0][i], near[1][j]),
                      second = std::max(near[0][i], near[1][j]);
            if (first == second || !isChord(frame, first, second))
                continue;
            const Vec2d exact = lineOf(frame, first, second, line[1] - 0.5 * CV_PI);
            // In units of what rounding to float can change.
            const double turn = std::abs(exact[1] - line[1]) / std::max(1.0f, std::abs(line[1]));
            const double shift = std::abs(exact[0] - line[0]) / std::max(1e-3f, std::abs(line[0]));
            const double error = std::max(turn, shift) / 2.5e-7;
            if (error < best)
            {
                best = error;
                s = first;
                e = second;
            }
        }
    return best < 1;
}

bool clipLine(const Vec2d& line, const Size& image, Point2d ends[2])
{
    // x = rho cos - t sin, y = rho sin + t cos, clipped to the image's outer border (Liang, Barsky)
    const double c = std::cos(line[1]), s = std::sin(line[1]);
    const double origin[2] = {line[0] * c, line[0] * s}, direction[2] = {-s, c};
    const double upper[2] = {image.width - 0.5, image.height - 0.5};
    double from = -DBL_MAX, to = DBL_MAX;
    for (int axis = 0; axis < 2; ++axis)
    {
        if (direction[axis] == 0)
        {
            if (origin[axis] < -0.5 || origin[axis] > upper[axis])
                return false;
            continue;
        }
        const double t0 = (-0.5 - origin[axis]) / direction[axis],
                     t1 = (upper[axis] - origin[axis]) / direction[axis];
        from = std::max(from, std::min(t0, t1));
        to = std::min(to, std::max(t0, t1));
    }
    ends[0] = Point2d(origin[0] + from * direction[0], origin[1] + from * direction[1]);
    ends[1] = Point2d(origin[0] + to * direction[0], origin[1] + to * direction[1]);
    return from <= to;
}

double endDistance(const Vec2d& line, const Vec2d& other, const Size& image)
{
    Point2d ends[2];
    if (!clipLine(line, image, ends))
        return 0;
    double distance = 0;
    for (int end = 0; end < 2; ++end)
        distance = std::max(distance, std::abs(ends[end].x * std::cos(other[1]) +
                                               ends[end].y * std::sin(other[1]) - other[0]));
    return distance;
}

} // namespace brute
} // namespace opencv_test
