// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "houghgrid.hpp"

#include <climits>
#include <cmath>
#include <cstring>

namespace cv {
namespace linespace {

namespace {

/** Where a pixel stands at an angle, in units of rho. Every vote of the drop-in is decided by this
one expression; the file is compiled without contraction to fused multiply-adds, which would round
differently here and there. */
inline float position(float x, float y, float cosine, float sine)
{
    return x * cosine + y * sine;
}

/** Nearest integer, ties to even, for |value| < 2^22: adding 1.5 * 2^23 leaves it in the low bits.
Unlike a call, it can be vectorised. */
inline int nearestSmall(float value)
{
    const float shifted = value + 12582912.f;
    int bits;
    std::memcpy(&bits, &shifted, sizeof(bits));
    return bits - 0x4B400000;
}

const int MOST_SMALL = (1 << 22) - 2;
const double MOST_DISTANCE = 1 << 30;  // cv::HoughLines overflows there
const double MOST_LINES = 4294967296.; // cv::HoughLines would need 16 GiB for as many

} // namespace

bool HoughGrid::isSmall() const
{
    return mostDistance <= MOST_SMALL;
}

int HoughGrid::nearest(float value) const
{
    return isSmall() ? nearestSmall(value) : cvRound(value);
}

bool HoughGrid::isAxisParallel(int angle) const
{
    return std::min(std::abs(cosines[angle]), std::abs(sines[angle])) *
               std::max(image.width, image.height) <
           1e-4f;
}

HoughGrid::HoughGrid(Size imageSize, double rhoStep, double thetaStep, double minTheta,
                     double maxTheta)
    : rho(rhoStep), angles(0), mostDistance(0), wraps(false), image(imageSize)
{
    if (!(rho > 0))
        CV_Error_(Error::StsOutOfRange, ("rho = %.15g: must be more than 0 pixels", rho));
    if (!(thetaStep > 0))
        CV_Error_(Error::StsOutOfRange, ("theta = %.15g: must be more than 0 radians", thetaStep));
    if (!(std::abs(minTheta) < HUGE_VAL) || !(std::abs(maxTheta) < HUGE_VAL) || minTheta > maxTheta)
        CV_Error_(Error::StsOutOfRange,
                  ("min_theta = %.15g, max_theta = %.15g: must be finite, and min_theta not larger "
                   "than max_theta",
                   minTheta, maxTheta));
    interval.min = minTheta;
    interval.max = maxTheta;
    // As many angles as fit between the ends, both included, but none twice: half a turn is the
    // same line.
    const double turn = std::max(1., std::floor(CV_PI / thetaStep + 0.5));
    const double count = std::min(turn, std::floor((maxTheta - minTheta) / thetaStep + 1e-6) + 1);
    const double reach = std::ceil(std::sqrt((double)image.width * image.width +
                                             (double)image.height * image.height) /
                                   rho) +
                         1;
    if (reach > MOST_DISTANCE)
        CV_Error_(Error::StsNoMem,
                  ("rho = %g: this image has %.0f distances of this size, must be at most %.0f",
                   rho, reach, MOST_DISTANCE));
    if (count * (2 * reach + 3) > MOST_LINES)
        CV_Error_(Error::StsNoMem, ("rho = %g, theta = %g: the image has %.0f lines at this "
                                    "resolution, must be at most 2^32",
                                    rho, thetaStep, count * (2 * reach + 3)));
    angles = (int)count;
    mostDistance = (int)reach;
    wraps = angles > 1 && CV_PI - (angles - 1) * thetaStep <= thetaStep * (1 + 1e-6);
    for (int j = 0; j < angles; ++j)
    {
        const double theta =
            j == 0 ? minTheta : minTheta + j * thetaStep; // thetaStep may be infinite
        thetas.push_back(theta);
        cosines.push_back((float)(std::cos(theta) / rho));
        sines.push_back((float)(std::sin(theta) / rho));
    }
}

Vec2f HoughGrid::line(int angle, int distance) const
{
    // The last angle may be beyond the end by the tolerance of the count.
    const double theta = std::max(interval.min, std::min(interval.max, thetas[angle]));
    const Line line = {distance == 0 ? 0 : distance * rho, theta};
    return interval.round(line);
}

void HoughGrid::distanceRange(int angle, int& first, int& last) const
{
    // The extremes are at corners, and rounding is monotone.
    const float x = (float)(image.width - 1), y = (float)(image.height - 1);
    const float c = cosines[angle], s = sines[angle];
    first = nearest(position(c < 0 ? x : 0, s < 0 ? y : 0, c, s));
    last = nearest(position(c < 0 ? 0 : x, s < 0 ? 0 : y, c, s));
}

EdgePixels::EdgePixels(const EdgeMap& edgeMap) : edges(&edgeMap)
{
    const Mat& votes = edgeMap.votes;
    const size_t n = countNonZero(votes);
    x.reserve(n);
    y.reserve(n);
    if (edgeMap.weighted)
        weights.reserve(n);
    for (int row = 0; row < votes.rows; ++row)
    {
        const uchar* pixel = votes.ptr<uchar>(row);
        for (int column = 0; column < votes.cols; ++column)
            if (pixel[column])
            {
                x.push_back((float)column);
                y.push_back((float)row);
                if (edgeMap.weighted)
                    weights.push_back(pixel[column]);
            }
    }
}

int mostWalkedLines(const HoughGrid& grid, size_t pixels)
{
    // A line costs a test of each pixel across its band and one on either side of it, for each of
    // its steps; such a test takes about as long as a pixel of the histogram.
    return (int)std::min<double>(
        INT_MAX, pixels / (std::max(grid.image.width, grid.image.height) * (grid.rho + 2)));
}

BandCounter::BandCounter(const EdgePixels& pixels, const HoughGrid& grid)
    : pixels_(pixels), grid_(grid)
{
}

void BandCounter::count(int angle, const std::vector<int>& distances, std::vector<int>& votes)
{
    votes.resize(distances.size());
    if (distances.empty())
        return;
    if (distances.size() <= (size_t)mostWalkedLines(grid_, pixels_.count()))
    {
        for (size_t k = 0; k < distances.size(); ++k)
            votes[k] = countLine(angle, distances[k]);
        return;
    }
    countAll(angle);
    for (size_t k = 0; k < distances.size(); ++k)
        votes[k] = histogram_[distances[k] + grid_.mostDistance];
}

void BandCounter::countAll(int angle)
{
    enum
    {
        RUN = 256
    };
    int indices[RUN];
    const float c = grid_.cosines[angle], s = grid_.sines[angle];
    histogram_.assign(2 * grid_.mostDistance + 1, 0);
    int* origin = histogram_.data() + grid_.mostDistance;
    const size_t n = pixels_.count();
    for (size_t begin = 0; begin < n; begin += RUN)
    {
        const int run = (int)std::min<size_t>(RUN, n - begin);
        const float *x = pixels_.x.data() + begin, *y = pixels_.y.data() + begin;
        if (grid_.isAxisParallel(angle))
        {
            for (int k = 0; k < run; ++k)
            {
                const float at = position(x[k], y[k], c, s);
                const int weight = pixels_.weights.empty() ? 1 : pixels_.weights[begin + k];
                const int low = cvCeil(at - 0.5f), high = cvFloor(at + 0.5f);
                origin[low] += weight;
                if (high != low)
                    origin[high] += weight;
            }
            continue;
        }
        if (grid_.isSmall())
            for (int k = 0; k < run; ++k)
                indices[k] = nearestSmall(position(x[k], y[k], c, s));
        else
            for (int k = 0; k < run; ++k)
                indices[k] = cvRound(position(x[k], y[k], c, s));
        if (pixels_.weights.empty())
            for (int k = 0; k < run; ++k)
                ++origin[indices[k]];
        else
            for (int k = 0; k < run; ++k)
                origin[indices[k]] += pixels_.weights[begin + k];
    }
}

int BandCounter::countLine(int angle, int distance) const
{
    const Mat& map = pixels_.edges->votes;
    const float c = grid_.cosines[angle], s = grid_.sines[angle];
    const bool xMajor = std::abs(s) >= std::abs(c), axisParallel = grid_.isAxisParallel(angle);
    const float major = xMajor ? c : s, minor = xMajor ? s : c;
    const int length = xMajor ? map.cols : map.rows, limit = xMajor ? map.rows : map.cols;
    // Somewhat wider than the band: the expression above decides.
    const float half =
        (0.5f + 1e-3f * (1 + std::abs((float)distance) * 1e-3f)) / std::abs(minor) + 1e-3f;
    const size_t majorStep = xMajor ? 1 : map.step, minorStep = xMajor ? map.step : 1;
    int sum = 0;
    for (int i = 0; i < length; ++i)
    {
        const float centre = (distance - i * major) / minor;
        if (!(centre > -half - 1 && centre < limit + half))
            continue;
        const int first = std::max(0, cvCeil(centre - half)),
                  last = std::min(limit - 1, cvFloor(centre + half));
        const uchar* pixel = map.data + i * majorStep + first * minorStep;
        for (int k = first; k <= last; ++k, pixel += minorStep)
        {
            if (!*pixel)
                continue;
            const float at =
                xMajor ? position((float)i, (float)k, c, s) : position((float)k, (float)i, c, s);
            const bool votes = axisParallel
                                   ? cvCeil(at - 0.5f) == distance || cvFloor(at + 0.5f) == distance
                                   : grid_.nearest(at) == distance;
            if (votes)
                sum += *pixel;
        }
    }
    return sum;
}

void allDistances(const HoughGrid& grid, int angle, std::vector<int>& distances)
{
    int first, last;
    grid.distanceRange(angle, first, last);
    distances.clear();
    for (int i = first; i <= last; ++i)
        distances.push_back(i);
}

} // namespace linespace
} // namespace cv
