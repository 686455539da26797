// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "square_map.hpp"

#include "directions.hpp"
#include "line_error.hpp"
#include "recall.hpp"

#include "support/edge_maps.hpp"

#include "opencv2/linespace.hpp"

#include <stdexcept>

namespace cascade {

namespace ls = cv::linespace;

namespace {

void requireEqual(const cv::Mat1i& actual, const cv::Mat1i& expected, const std::string& what)
{
    if (actual.size() != expected.size() || cv::norm(actual, expected, cv::NORM_INF) != 0)
        throw std::runtime_error("the naive code's votes are not the module's: " + what);
}

Input randomInput(double density)
{
    const cv::Size size(SQUARE_SIZE, SQUARE_SIZE);
    Input input{{"random", "random", ""},
                support::randomEdges(size, density, 1),
                cv::Mat1s(size),
                cv::Mat1s(size),
                SQUARE_SIZE / 5};
    cv::RNG random(1);
    random.fill(input.dx, cv::RNG::UNIFORM, -1000, 1000);
    random.fill(input.dy, cv::RNG::UNIFORM, -1000, 1000);
    return input;
}

void requireOrientedLines(const Input& input)
{
    Detection detection;
    detection.oriented = true;
    detection.cellSize = 0;
    const auto expected = linesOf(input, detection);
    const SquareMap map(input, true);
    PipelineParameters exactly = map.parameters();
    exactly.candidateRatio = 1;
    const auto actual = strongestLines(map.exact, map.exact, map.size(), exactly).lines;
    bool isEqual = !expected.empty() && actual.size() == expected.size();
    // The angles are computed in another way, in floating point.
    for (std::size_t i = 0; isEqual && i < actual.size(); ++i)
        isEqual = actual[i][2] == expected[i][2] &&
                  std::abs(actual[i][0] - expected[i][0]) < 1e-3 &&
                  std::abs(actual[i][1] - expected[i][1]) < 1e-5;
    if (!isEqual)
        throw std::runtime_error("the naive code's oriented lines are not the module's");
}

} // namespace

SquareMap::SquareMap(const Input& input, bool oriented)
    : source(input.source), threshold(input.threshold),
      voters(oriented ? votersOf(input.edges, input.dx, input.dy) : votersOf(input.edges)),
      exact(naiveExactVotes(voters))
{
    PipelineParameters exactly = parameters();
    exactly.candidateRatio = 1;
    // Like the exact method's, its candidates are maxima of the whole table.
    exactly.pool = exact.total();
    ls::lineEndPoints(strongestLines(exact, exact, size(), exactly).lines, size(), ends);
}

int SquareMap::countFound(const PipelineResult& result) const
{
    return cascade::countFound(ends, result.lines, result.lines.size());
}

void requireModulesVotes()
{
    const Input sparse = randomInput(0.2);
    const cv::Mat1w voters = votersOf(sparse.edges);
    cv::Mat1i expected;
    ls::LineSpaceDetector::create(0, 0, ls::METHOD_EXACT)->compute(sparse.edges, expected);
    requireEqual(naiveExactVotes(voters), expected, "the exact method's");
    for (const int cellSize : cellSizes())
    {
        ls::LineSpaceDetector::create(0, 0, ls::METHOD_CASCADED, cellSize)
            ->compute(sparse.edges, expected);
        MergeCost cost;
        requireEqual(naiveCascade(voters, cellSize, CrossingRule::NEAREST, cost), expected,
                     "cells of " + std::to_string(cellSize) + " pixels");
    }
    requireOrientedLines(randomInput(0.8)); // dense: a quarter of the pixels vote for a direction
}

} // namespace cascade
