// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "crossing_rules.hpp"

#include "line_error.hpp"
#include "naive_cascade.hpp"
#include "pipeline.hpp"
#include "recall.hpp"

#include "support/edge_maps.hpp"

#include "opencv2/linespace.hpp"

#include <algorithm>
#include <iomanip>
#include <stdexcept>

namespace cascade {

namespace ls = cv::linespace;

namespace {

struct NamedRule
{
    CrossingRule rule;
    const char* name;
};

const NamedRule rules[] = {{CrossingRule::NEAREST, "nearest, ties to the larger (the module's)"},
                           {CrossingRule::NEAREST_UNBIASED, "nearest, ties without bias"},
                           {CrossingRule::BOTH_NEIGHBOURS, "both neighbours, larger sum"}};

//! The results of one rule and cell size over all images.
struct RuleResult
{
    MergeCost cost;
    std::vector<float> ratios; //!< of the cascade's votes to the exact ones
    int exactLines = 0, found = 0;
};

//! What is the same for all rules of an image.
struct ExactSide
{
    cv::Mat1i votes;
    std::vector<cv::Vec4f> ends; //!< of its strongest lines

    explicit ExactSide(const Input& input)
    {
        ls::LineSpaceDetector::create(0, 0, ls::METHOD_EXACT)->compute(input.edges, votes);
        ls::lineEndPoints(strongestLines(votes, votes, input.edges.size(), {input.threshold(), 1}),
                          input.edges.size(), ends);
    }
};

void addImage(const Input& input, const ExactSide& exact, int cellSize, const NamedRule& rule,
              RuleResult& result, std::ostream& csv)
{
    const cv::Mat1i votes = naiveCascade(input.edges, cellSize, rule.rule, result.cost);
    const std::size_t before = result.ratios.size();
    double sum = 0;
    for (int s = 0; s < votes.rows; ++s)
        for (int e = s + 1; e < votes.cols; ++e)
            if (exact.votes(s, e) >= RULE_SIZE / 4)
            {
                result.ratios.push_back((float)votes(s, e) / exact.votes(s, e));
                sum += result.ratios.back();
            }
    const std::size_t chords = result.ratios.size() - before;

    const auto lines =
        strongestLines(votes, exact.votes, input.edges.size(), {input.threshold(), 0.75});
    int found = 0;
    for (const cv::Vec4f& ends : exact.ends)
        found += leastError(ends, lines, lines.size()) <= SAME_LINE;
    result.exactLines += (int)exact.ends.size();
    result.found += found;
    csv << input.source.group << "," << input.source.name << ",\"" << rule.name << "\"," << cellSize
        << "," << chords << "," << (chords ? sum / chords : 0) << "," << exact.ends.size() << ","
        << found << "\n";
}

void writeRow(std::ostream& out, const NamedRule& rule, int cellSize, RuleResult& result)
{
    std::sort(result.ratios.begin(), result.ratios.end());
    const auto quantile = [&](double share)
    {
        return result.ratios[(std::size_t)(share * (result.ratios.size() - 1))];
    };
    double sum = 0;
    for (const float ratio : result.ratios)
        sum += ratio;
    const MergeCost& cost = result.cost;
    // A sum loads two parts, a copy one.
    const double loads = (2 * cost.sums + cost.chords - cost.crossings) / cost.chords;
    out << "| " << rule.name << " | " << cellSize << std::setprecision(3) << " | "
        << sum / result.ratios.size() << " | " << quantile(0.05) << " | " << quantile(0.95) << " | "
        << std::setprecision(2) << 100. * result.found / std::max(1, result.exactLines) << " | "
        << cost.sums / cost.crossings << " | " << loads << " | " << 1e9 * cost.seconds / cost.chords
        << " | " << std::setprecision(3) << (cost.ties > 0 ? cost.ties / cost.crossings : 0)
        << " | " << (cost.ties > 0 ? cost.tiesUp / cost.ties : 0) << " |\n";
}

} // namespace

void requireShippedRule()
{
    const cv::Mat1b edges = support::randomEdges(cv::Size(RULE_SIZE, RULE_SIZE), 0.2, 1);
    for (const int cellSize : cellSizes())
    {
        cv::Mat1i expected;
        ls::LineSpaceDetector::create(0, 0, ls::METHOD_CASCADED, cellSize)
            ->compute(edges, expected);
        MergeCost cost;
        const cv::Mat1i actual = naiveCascade(edges, cellSize, CrossingRule::NEAREST, cost);
        if (actual.size() != expected.size() || cv::norm(actual, expected, cv::NORM_INF) != 0)
            throw std::runtime_error("the naive cascade is not LineSpaceDetector::compute for "
                                     "cells of " +
                                     std::to_string(cellSize) + " pixels");
    }
}

void writeCrossingRules(std::ostream& out, std::ostream& csv, const std::vector<Input>& inputs)
{
    const int count = (int)std::size(rules), sizes = (int)cellSizes().size();
    std::vector<RuleResult> results(count * sizes);
    csv << "group,image,rule,k,chords,mean_ratio,exact_lines,found\n";
    for (const Input& input : inputs)
    {
        const ExactSide exact(input);
        for (int i = 0; i < count * sizes; ++i)
            addImage(input, exact, cellSizes()[i % sizes], rules[i / sizes], results[i], csv);
    }
    out << std::fixed
        << "| rule | k | mean ratio | 5 % | 95 % | recall, % | sums per crossing | loads per "
           "chord | naive merge, ns per chord | ties per crossing | of them to the larger |\n"
           "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n";
    for (int i = 0; i < count * sizes; ++i)
        if (!results[i].ratios.empty())
            writeRow(out, rules[i / sizes], cellSizes()[i % sizes], results[i]);
    out << "\n";
}

} // namespace cascade
