// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "comparison.hpp"

#include <atomic>
#include <cmath>

#include "cell_index.hpp"
#include "opencv2/core/utility.hpp"

namespace conformance {

namespace {

const double shareOfVotes = 0.98;

struct Pixels
{
    std::vector<double> x, y;
    std::vector<int> values;
};

Pixels edgePixels(const cv::Mat1b& edges, bool weighted)
{
    Pixels pixels;
    for (int y = 0; y < edges.rows; ++y)
        for (int x = 0; x < edges.cols; ++x)
            if (edges(y, x))
            {
                pixels.x.push_back(x);
                pixels.y.push_back(y);
                pixels.values.push_back(weighted ? edges(y, x) : 1);
            }
    return pixels;
}

//! The votes of the pixels at most this far from a line.
int votesWithin(const Pixels& pixels, const cv::Vec3f& line, double distance)
{
    const double c = std::cos(static_cast<double>(line[1]));
    const double s = std::sin(static_cast<double>(line[1])), rho = line[0];
    int votes = 0;
    for (std::size_t i = 0; i < pixels.x.size(); ++i)
        votes += std::abs(pixels.x[i] * c + pixels.y[i] * s - rho) <= distance ? pixels.values[i] : 0;
    return votes;
}

} // namespace

int countFound(const Lines& wanted, const Lines& lines, const Arguments& arguments)
{
    const CellIndex index(lines, arguments.rho, arguments.theta);
    int count = 0;
    for (const cv::Vec3f& line : wanted)
        for (int i : index.near(line))
            if (lines[i][2] >= shareOfVotes * line[2])
            {
                ++count;
                break;
            }
    return count;
}

int countCrowded(const Lines& lines, const Arguments& arguments)
{
    const CellIndex index(lines, arguments.rho, arguments.theta);
    int count = 0;
    for (const cv::Vec3f& line : lines)
        count += index.near(line).size() > 1;
    return count;
}

int countWrongVotes(const Lines& lines, const cv::Mat1b& edges, const Arguments& arguments,
                    double angleError)
{
    const Pixels pixels = edgePixels(edges, arguments.weighted);
    const double boundary = (edges.cols + edges.rows) * angleError;
    std::atomic<int> count(0);
    cv::parallel_for_(cv::Range(0, static_cast<int>(lines.size())), [&](const cv::Range& range) {
        for (int i = range.start; i < range.end; ++i)
        {
            const int fewest = votesWithin(pixels, lines[i], 0.5 * arguments.rho - boundary);
            const int most = votesWithin(pixels, lines[i], 0.5 * arguments.rho + boundary);
            if (lines[i][2] < fewest || lines[i][2] > most)
                ++count;
        }
    });
    return count;
}

double roundingOf(const Arguments& arguments)
{
    const double largest = std::max(std::abs(arguments.minTheta), std::abs(arguments.maxTheta));
    return 1.2e-7 * std::max(1.0, largest);
}

} // namespace conformance
