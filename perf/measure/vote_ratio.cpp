// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "sections.hpp"

#include "support/edge_maps.hpp"

#include "opencv2/linespace.hpp"

#include <algorithm>
#include <iomanip>
#include <vector>

namespace measure {

namespace {

namespace ls = cv::linespace;

//! Ratios of cascaded to exact votes of the chords with at least so many exact votes, in ascending
//! order.
std::vector<double> ratios(const cv::Mat1b& edges, int cellSize, int leastVotes)
{
    cv::Mat1i exact, cascaded;
    ls::LineSpaceDetector::create(0, 0, ls::METHOD_EXACT)->compute(edges, exact);
    ls::LineSpaceDetector::create(0, 0, ls::METHOD_CASCADED, cellSize)->compute(edges, cascaded);
    std::vector<double> result;
    for (int s = 0; s < exact.rows; ++s)
        for (int e = s + 1; e < exact.cols; ++e)
            if (exact(s, e) >= leastVotes)
                result.push_back((double)cascaded(s, e) / exact(s, e));
    std::sort(result.begin(), result.end());
    return result;
}

} // namespace

void writeVoteRatio(std::ostream& out, const Settings& settings)
{
    const int n = 256;
    out << "## Cascaded against exact votes\n\n"
        << n << " x " << n
        << " pixels, where the frame is the image for all cell sizes k. Photographs: Canny 50/150, "
           "chords with "
           "at least n/4 exact votes. Random: 20 % edge pixels, chords with at least n/5.\n\n"
           "| image | k | chords | mean | 5 % | median | 95 % |\n| --- | ---: | ---: | ---: | ---: "
           "| ---: | ---: |\n";
    for (const char* name : {"building.jpg", "home.jpg", "sudoku.png", "random"})
    {
        const bool random = std::string(name) == "random";
        const cv::Mat1b edges =
            random ? support::randomEdges(cv::Size(n, n), 0.2, 1)
                   : support::cannyEdges(support::scaled(
                         support::readPhotograph(settings.data, name), cv::Size(n, n)));
        for (const int k : {4, 8, 16, 32})
        {
            const std::vector<double> all = ratios(edges, k, random ? n / 5 : n / 4);
            if (all.empty())
                continue;
            double sum = 0;
            for (const double value : all)
                sum += value;
            const auto quantile = [&](double share)
            {
                return all[(std::size_t)(share * (all.size() - 1))];
            };
            out << "| " << name << " | " << k << " | " << all.size() << std::fixed
                << std::setprecision(3) << " | " << sum / all.size() << " | " << quantile(0.05)
                << " | " << quantile(0.5) << " | " << quantile(0.95) << " |\n";
        }
    }
    out << "\n";
}

} // namespace measure
