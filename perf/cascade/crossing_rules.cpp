// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "crossing_rules.hpp"

#include "recall.hpp"

#include <algorithm>
#include <iomanip>

namespace cascade {

namespace {

const char* nameOf(CrossingRule rule)
{
    switch (rule)
    {
    case CrossingRule::NEAREST: return "nearest, ties to the larger (the module's)";
    case CrossingRule::NEAREST_UNBIASED: return "nearest, ties without bias";
    default: return "both neighbours, larger sum";
    }
}

} // namespace

CrossingRules::CrossingRules()
{
    for (const CrossingRule rule :
         {CrossingRule::NEAREST, CrossingRule::NEAREST_UNBIASED, CrossingRule::BOTH_NEIGHBOURS})
        for (const int cellSize : cellSizes())
            settings_.push_back({rule, cellSize, {}, {}, {}});
}

void CrossingRules::add(const SquareMap& map)
{
    for (Setting& setting : settings_)
    {
        const cv::Mat1i votes =
            naiveCascade(map.voters, setting.cellSize, setting.rule, setting.cost);
        const std::size_t before = setting.ratios.size();
        double sum = 0;
        for (int s = 0; s < votes.rows; ++s)
            for (int e = s + 1; e < votes.cols; ++e)
                if (map.exact(s, e) >= SQUARE_SIZE / 4)
                {
                    setting.ratios.push_back((float)votes(s, e) / map.exact(s, e));
                    sum += setting.ratios.back();
                }
        const std::size_t chords = setting.ratios.size() - before;
        PipelineParameters parameters = map.parameters();
        const int foundSimply =
            map.countFound(strongestLines(votes, map.exact, map.size(), parameters));
        parameters.candidates = Candidates::PARALLEL_MAXIMA;
        parameters.ascent = Ascent::TO_MAXIMUM;
        const int foundByAscent =
            map.countFound(strongestLines(votes, map.exact, map.size(), parameters));
        setting.images.push_back({map.source, chords, chords ? sum / chords : 0,
                                  (int)map.ends.size(), foundSimply, foundByAscent});
    }
}

void CrossingRules::write(std::ostream& out) const
{
    out << std::fixed
        << "| rule | k | mean ratio | 5 % | 95 % | recall, ring maxima | recall, ascent | sums per "
           "crossing | loads per chord | naive merge, ns per chord | ties per crossing | of them "
           "to "
           "the larger |\n"
           "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n";
    for (const Setting& setting : settings_)
        if (!setting.ratios.empty())
            writeRow(out, setting);
    out << "\n";
}

void CrossingRules::writeRow(std::ostream& out, const Setting& setting)
{
    std::vector<float> ratios = setting.ratios;
    std::sort(ratios.begin(), ratios.end());
    const auto quantile = [&](double share)
    {
        return ratios[(std::size_t)(share * (ratios.size() - 1))];
    };
    double sum = 0;
    for (const float ratio : ratios)
        sum += ratio;
    int exactLines = 0, foundSimply = 0, foundByAscent = 0;
    for (const PerImage& image : setting.images)
    {
        exactLines += image.exactLines;
        foundSimply += image.foundSimply;
        foundByAscent += image.foundByAscent;
    }
    const double percent = 100. / std::max(1, exactLines);
    const MergeCost& cost = setting.cost;
    // A sum loads two parts, a copy one.
    const double loads = (2 * cost.sums + cost.chords - cost.crossings) / cost.chords;
    out << "| " << nameOf(setting.rule) << " | " << setting.cellSize << std::setprecision(3)
        << " | " << sum / ratios.size() << " | " << quantile(0.05) << " | " << quantile(0.95)
        << " | " << std::setprecision(2) << percent * foundSimply << " | "
        << percent * foundByAscent << " | " << cost.sums / cost.crossings << " | " << loads << " | "
        << std::setprecision(1) << 1e9 * cost.seconds / cost.chords << " | " << std::setprecision(3)
        << cost.ties / cost.crossings << " | ";
    if (setting.rule == CrossingRule::BOTH_NEIGHBOURS)
        out << "- |\n";
    else
        out << cost.tiesUp / cost.ties << " |\n";
}

void CrossingRules::writeCsv(std::ostream& out) const
{
    out << "group,image,rule,k,chords,mean_ratio,exact_lines,found_ring_maxima,found_ascent\n";
    for (const Setting& setting : settings_)
        for (const PerImage& image : setting.images)
            out << image.source.group << "," << image.source.name << ",\"" << nameOf(setting.rule)
                << "\"," << setting.cellSize << "," << image.chords << "," << image.meanRatio << ","
                << image.exactLines << "," << image.foundSimply << "," << image.foundByAscent
                << "\n";
}

} // namespace cascade
