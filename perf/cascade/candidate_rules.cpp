// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "candidate_rules.hpp"

#include <algorithm>
#include <iomanip>

namespace cascade {

namespace {

const std::size_t pools[] = {4096, 8192, 16384};

const char* nameOf(Candidates candidates)
{
    switch (candidates)
    {
    case Candidates::RING_MAXIMA: return "ring maxima";
    case Candidates::PARALLEL_MAXIMA: return "parallel maxima (the module's)";
    default: return "every chord";
    }
}

const char* nameOf(Ascent ascent)
{
    switch (ascent)
    {
    case Ascent::NONE: return "none";
    case Ascent::TWO_STEPS: return "two steps";
    default: return "to a ring maximum";
    }
}

} // namespace

CandidateRules::CandidateRules()
{
    for (const Candidates candidates :
         {Candidates::RING_MAXIMA, Candidates::PARALLEL_MAXIMA, Candidates::EVERY_CHORD})
        for (const Ascent ascent : {Ascent::NONE, Ascent::TWO_STEPS, Ascent::TO_MAXIMUM})
            for (const double ratio : {0.75, 0.6})
            {
                if (ratio != 0.75 && ascent != Ascent::TO_MAXIMUM)
                    continue; // without it, other things than the ratio lose the lines
                for (const std::size_t pool : pools)
                    settings_.push_back({candidates, ratio, ascent, pool, {}});
            }
}

void CandidateRules::add(const SquareMap& plain, const SquareMap& oriented)
{
    addMap(plain, false);
    addMap(oriented, true);
}

void CandidateRules::addMap(const SquareMap& map, bool oriented)
{
    MergeCost cost;
    const cv::Mat1i votes = naiveCascade(map.voters, 8, CrossingRule::NEAREST, cost);
    for (Setting& setting : settings_)
    {
        PipelineParameters parameters = map.parameters();
        parameters.candidates = setting.candidates;
        parameters.candidateRatio = setting.ratio;
        parameters.ascent = setting.ascent;
        parameters.pool = setting.pool;
        const PipelineResult result = strongestLines(votes, map.exact, map.size(), parameters);
        setting.images.push_back(
            {map.source, oriented, (int)map.ends.size(), map.countFound(result), result.counted});
    }
}

void CandidateRules::write(std::ostream& out) const
{
    out << "| candidates | ascent | ratio |";
    for (const char* kind : {"plain", "oriented"})
        for (const std::size_t pool : pools)
            out << " " << kind << ", pool " << pool << " |";
    out << "\n| --- | --- | ---: |";
    for (std::size_t i = 0; i < 2 * std::size(pools); ++i)
        out << " ---: |";
    out << "\n" << std::fixed;
    for (std::size_t i = 0; i < settings_.size(); i += std::size(pools))
    {
        const Setting& first = settings_[i];
        out << "| " << nameOf(first.candidates) << " | " << nameOf(first.ascent) << " | "
            << std::setprecision(2) << first.ratio << " |";
        for (const bool oriented : {false, true})
            for (std::size_t j = 0; j < std::size(pools); ++j)
                writeEntry(out, settings_[i + j], oriented);
        out << "\n";
    }
    out << "\n";
}

void CandidateRules::writeEntry(std::ostream& out, const Setting& setting, bool oriented)
{
    int exactLines = 0, found = 0, images = 0;
    double counted = 0;
    for (const PerImage& image : setting.images)
        if (image.oriented == oriented)
        {
            exactLines += image.exactLines;
            found += image.found;
            counted += image.counted;
            ++images;
        }
    out << " " << std::setprecision(2) << 100. * found / std::max(1, exactLines) << " ("
        << std::setprecision(1) << counted / std::max(1, images) / 1000 << ") |";
}

void CandidateRules::writeCsv(std::ostream& out) const
{
    out << "group,image,oriented,candidates,ratio,ascent,pool,exact_lines,found,counted\n";
    for (const Setting& setting : settings_)
        for (const PerImage& image : setting.images)
            out << image.source.group << "," << image.source.name << "," << image.oriented << ",\""
                << nameOf(setting.candidates) << "\"," << setting.ratio << ",\""
                << nameOf(setting.ascent) << "\"," << setting.pool << "," << image.exactLines << ","
                << image.found << "," << image.counted << "\n";
}

} // namespace cascade
