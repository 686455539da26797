// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "scene.hpp"

#include "random.hpp"

#include <algorithm>
#include <stdexcept>

namespace scenes {

namespace {

const double pi = 3.141592653589793;

//! Independent sequences of one seed: the same lines can have other noise.
enum Stream : std::uint64_t
{
    StreamLines,
    StreamSigns,
    StreamDashes,
    StreamNoise,
    StreamNegative,
    StreamThinning,
    StreamClutter
};

double distance(const Line& line, double x, double y)
{
    return x * std::cos(line.theta) + y * std::sin(line.theta) - line.rho;
}

//! Share of an edge's contrast at a signed distance from it: 0 far below, 1 far above.
double edgeProfile(double signedDistance, double blur)
{
    if (signedDistance == 0)
        return 0.5;
    if (std::abs(signedDistance) >= 8 * blur)
        return signedDistance > 0 ? 1 : 0;
    return 0.5 * std::erfc(-signedDistance / (blur * std::sqrt(2.0)));
}

//! Whether both ends of a are within the distance of b.
bool coincide(const Line& a, const Line& b, cv::Size size, double limit)
{
    cv::Point2d ends[2];
    if (!chordEnds(a, size, ends))
        return false;
    return std::abs(distance(b, ends[0].x, ends[0].y)) < limit &&
           std::abs(distance(b, ends[1].x, ends[1].y)) < limit;
}

void addNoise(cv::Mat1d& levels, double sigma, std::uint64_t seed)
{
    Random random(seed, StreamNoise);
    if (sigma > 0)
        for (double& level : levels)
            level += sigma * random.normal();
}

cv::Mat1b quantised(const cv::Mat1d& levels)
{
    cv::Mat1b image(levels.size());
    std::transform(levels.begin(), levels.end(), image.begin(),
                   [](double level)
                   { return (uchar)std::floor(std::min(255.0, std::max(0.0, level)) + 0.5); });
    return image;
}

bool showable(const cv::Mat1d& levels)
{
    double lowest, highest;
    cv::minMaxLoc(levels, &lowest, &highest);
    return lowest >= 0 && highest <= 255;
}

cv::Mat1d stepLevels(const std::vector<Line>& lines, const SceneOptions& options, Random& signs)
{
    cv::Mat1d levels(options.size, options.background);
    for (const Line& line : lines)
    {
        const double contrast = signs.sign() * options.contrast;
        for (int y = 0; y < levels.rows; ++y)
            for (int x = 0; x < levels.cols; ++x)
                levels(y, x) += contrast * edgeProfile(distance(line, x, y), options.blur);
    }
    return levels;
}

cv::Mat1d barLevels(const std::vector<Line>& lines, const SceneOptions& options, Random& signs,
                    std::uint64_t seed)
{
    const int dashLength = 8;
    const int reach = options.size.width + options.size.height;
    cv::Mat1d levels(options.size, options.background);
    Random dashes(seed, StreamDashes);
    for (const Line& line : lines)
    {
        const double contrast = signs.sign() * options.contrast;
        std::vector<bool> drawn(2 * reach / dashLength + 1);
        for (std::size_t i = 0; i < drawn.size(); ++i)
            drawn[i] = dashes.uniform() < options.keptFraction;
        for (int y = 0; y < levels.rows; ++y)
            for (int x = 0; x < levels.cols; ++x)
            {
                const double along = y * std::cos(line.theta) - x * std::sin(line.theta);
                if (!drawn[(std::size_t)((along + reach) / dashLength)])
                    continue;
                const double d = distance(line, x, y), half = options.barWidth / 2;
                levels(y, x) += contrast * (edgeProfile(d + half, options.blur) -
                                            edgeProfile(d - half, options.blur));
            }
    }
    return levels;
}

/** Renders with signs of the lines' contrasts that keep the levels inside 0 to 255. */
template<class Render>
Scene rendered(const std::vector<Line>& lines, const SceneOptions& options, std::uint64_t seed,
               Render render)
{
    Random signs(seed, StreamSigns);
    for (int attempt = 0; attempt < 1000; ++attempt)
    {
        cv::Mat1d levels = render(signs);
        if (!showable(levels))
            continue;
        addNoise(levels, options.noise, seed);
        return {quantised(levels), lines};
    }
    throw std::runtime_error("scene: the contrasts of the lines do not fit into 0 to 255");
}

cv::Mat1d rampLevels(cv::Size size, Random& random)
{
    const double theta = random.uniform(0, 2 * pi);
    const double dx = std::cos(theta), dy = std::sin(theta);
    const double extent = std::abs(dx) * size.width + std::abs(dy) * size.height;
    cv::Mat1d levels(size);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            levels(y, x) =
                128 + 128 / extent * ((x - 0.5 * size.width) * dx + (y - 0.5 * size.height) * dy);
    return levels;
}

cv::Mat1d discLevels(cv::Size size, Random& random)
{
    const double side = std::min(size.width, size.height);
    cv::Mat1d levels(size, 128.0);
    for (int count = 12 + random.below(13); count > 0; --count)
    {
        const double cx = random.uniform(0, size.width), cy = random.uniform(0, size.height);
        const double radius = random.uniform(side / 32, side / 8);
        const double grey = random.uniform(16, 240);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
            {
                const double inside = edgeProfile(radius - std::hypot(x - cx, y - cy), 0.7);
                levels(y, x) += inside * (grey - levels(y, x));
            }
    }
    return levels;
}

cv::Mat1d saltLevels(cv::Size size, Random& random)
{
    cv::Mat1d levels(size, 128.0);
    for (double& level : levels)
        if (random.uniform() < 0.02)
            level = 255;
    return levels;
}

} // namespace

bool chordEnds(const Line& line, cv::Size size, cv::Point2d ends[2])
{
    // The line's points are foot + t direction; each pair of the rectangle's sides cuts t's range.
    const double c = std::cos(line.theta), s = std::sin(line.theta);
    const double foot[2] = {line.rho * c, line.rho * s}, direction[2] = {-s, c};
    const double highest[2] = {size.width - 0.5, size.height - 0.5};
    double first = -1e18, last = 1e18;
    for (int axis = 0; axis < 2; ++axis)
    {
        if (std::abs(direction[axis]) < 1e-15)
        {
            if (foot[axis] < -0.5 || foot[axis] > highest[axis])
                return false;
            continue;
        }
        const double a = (-0.5 - foot[axis]) / direction[axis];
        const double b = (highest[axis] - foot[axis]) / direction[axis];
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
    }
    if (first > last)
        return false;
    ends[0] = {foot[0] + first * direction[0], foot[1] + first * direction[1]};
    ends[1] = {foot[0] + last * direction[0], foot[1] + last * direction[1]};
    return true;
}

std::vector<Line> randomLines(const SceneOptions& options, std::uint64_t seed)
{
    const cv::Size size = options.size;
    const double least = options.minShare * std::min(size.width, size.height);
    const double reach = std::hypot(size.width, size.height) / 2;
    Random random(seed, StreamLines);
    std::vector<Line> lines;
    for (int attempt = 0; (int)lines.size() < options.lines; ++attempt)
    {
        if (attempt == 1000000)
            throw std::runtime_error("scene: so many lines do not fit so far apart");
        const double theta = random.uniform(0, pi);
        const Line centre{0, theta};
        const double rho = distance(centre, 0.5 * (size.width - 1), 0.5 * (size.height - 1)) +
                           random.uniform(-reach, reach);
        const Line line{rho, theta};
        cv::Point2d ends[2];
        if (!chordEnds(line, size, ends) ||
            std::hypot(ends[0].x - ends[1].x, ends[0].y - ends[1].y) < least)
            continue;
        const auto near = [&](const Line& other)
        {
            return coincide(line, other, size, options.minSeparation) ||
                   coincide(other, line, size, options.minSeparation);
        };
        if (std::none_of(lines.begin(), lines.end(), near))
            lines.push_back(line);
    }
    return lines;
}

Scene stepEdges(const std::vector<Line>& lines, const SceneOptions& options, std::uint64_t seed)
{
    return rendered(lines, options, seed,
                    [&](Random& signs) { return stepLevels(lines, options, signs); });
}

Scene stepEdges(const SceneOptions& options, std::uint64_t seed)
{
    return stepEdges(randomLines(options, seed), options, seed);
}

Scene bars(const SceneOptions& options, std::uint64_t seed)
{
    const std::vector<Line> lines = randomLines(options, seed);
    return rendered(lines, options, seed,
                    [&](Random& signs) { return barLevels(lines, options, signs, seed); });
}

cv::Mat1b negative(Negative kind, cv::Size size, std::uint64_t seed)
{
    Random random(seed, StreamNegative);
    cv::Mat1d levels(size, 128.0);
    double noise = 4;
    switch (kind)
    {
    case Negative::Noise: noise = 20; break;
    case Negative::Ramp: levels = rampLevels(size, random); break;
    case Negative::Discs: levels = discLevels(size, random); break;
    case Negative::Salt:
        levels = saltLevels(size, random);
        noise = 0;
        break;
    }
    addNoise(levels, noise, seed);
    return quantised(levels);
}

void thinOut(cv::Mat1b& edges, double keptFraction, std::uint64_t seed)
{
    Random random(seed, StreamThinning);
    for (uchar& pixel : edges)
        if (pixel && random.uniform() >= keptFraction)
            pixel = 0;
}

void addClutter(cv::Mat1b& edges, double share, std::uint64_t seed)
{
    Random random(seed, StreamClutter);
    for (uchar& pixel : edges)
        if (random.uniform() < share)
            pixel = 255;
}

} // namespace scenes
