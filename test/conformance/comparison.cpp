// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "comparison.hpp"

#include <algorithm>
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

//! The votes of the pixels that are less than `inside` and less than `outside` away from a line.
VoteRange votesOf(const Pixels& pixels, double rho, double theta, double inside, double outside)
{
    const double c = std::cos(theta), s = std::sin(theta);
    VoteRange votes = {0, 0};
    for (std::size_t i = 0; i < pixels.x.size(); ++i)
    {
        const double distance = std::abs(pixels.x[i] * c + pixels.y[i] * s - rho);
        votes.fewest += distance < inside ? pixels.values[i] : 0;
        votes.most += distance < outside ? pixels.values[i] : 0;
    }
    return votes;
}

template<class Body>
void forEachInParallel(std::size_t count, Body body)
{
    cv::parallel_for_(cv::Range(0, static_cast<int>(count)),
                      [&](const cv::Range& range)
                      {
                          for (int i = range.start; i < range.end; ++i)
                              body(i);
                      });
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

std::vector<VoteRange> countVotes(const Lines& lines, const cv::Mat1b& edges,
                                  const Arguments& arguments)
{
    const Pixels pixels = edgePixels(edges, arguments.weighted);
    const double largestAngle =
        std::max({1.0, std::abs(arguments.minTheta), std::abs(arguments.maxTheta)});
    const double boundary = 1.2e-7 * largestAngle * (edges.cols + edges.rows);
    const double inside = 0.5 * arguments.rho - boundary, outside = 0.5 * arguments.rho + boundary;
    std::vector<VoteRange> votes(lines.size());
    forEachInParallel(lines.size(), [&](int i)
                      { votes[i] = votesOf(pixels, lines[i][0], lines[i][1], inside, outside); });
    return votes;
}

std::vector<int> countVotesOnGrid(const Lines& lines, const cv::Mat1b& edges,
                                  const Arguments& arguments)
{
    const Pixels pixels = edgePixels(edges, arguments.weighted);
    // Far more than double precision loses, far less than any pixel's distance from the boundary.
    const double outside = 0.5 * arguments.rho + 1e-9;
    std::vector<int> votes(lines.size());
    forEachInParallel(lines.size(),
                      [&](int i)
                      {
                          const double rho =
                              std::round(lines[i][0] / arguments.rho) * arguments.rho;
                          const double step =
                              std::round((lines[i][1] - arguments.minTheta) / arguments.theta);
                          const double theta = arguments.minTheta + step * arguments.theta;
                          votes[i] = votesOf(pixels, rho, theta, outside, outside).most;
                      });
    return votes;
}

int countWrongVotes(const Lines& lines, const std::vector<VoteRange>& counted)
{
    int count = 0;
    for (std::size_t i = 0; i < lines.size(); ++i)
        count += lines[i][2] < counted[i].fewest || lines[i][2] > counted[i].most;
    return count;
}

} // namespace conformance
