// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "opencv_lines.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "comparison.hpp"
#include "opencv2/imgproc.hpp"

namespace conformance {

namespace {

template<class Image, class = void>
struct HasEdgeValues : std::false_type
{
};

template<class Image>
struct HasEdgeValues<
    Image, std::void_t<decltype(cv::HoughLines(std::declval<Image>(), std::declval<Lines&>(), 1.0,
                                               1.0, 1, 0.0, 0.0, 0.0, 1.0, true))>> : std::true_type
{
};

// A template, so that the call which an older OpenCV does not have is not compiled there.
template<class Image>
void houghLines(const Image& edges, const Arguments& a, int threshold, Lines& lines)
{
    if constexpr (HasEdgeValues<Image>::value)
        cv::HoughLines(edges, lines, a.rho, a.theta, threshold, 0, 0, a.minTheta, a.maxTheta,
                       a.weighted);
    else if (a.weighted)
        CV_Error(cv::Error::StsNotImplemented, "this cv::HoughLines has no use_edgeval");
    else
        cv::HoughLines(edges, lines, a.rho, a.theta, threshold, 0, 0, a.minTheta, a.maxTheta);
}

// Pixels vote for the nearest whole multiple of rho. Where a version reports halves instead,
// because it has an even number of cells around 0, the line it counted lies half a step further up.
void removeBias(Lines& lines, double rho)
{
    for (cv::Vec3f& line : lines)
    {
        const double cell = line[0] / rho;
        if (std::abs(cell - std::round(cell)) > 0.25)
            line[0] = static_cast<float>(line[0] + 0.5 * rho);
    }
}

} // namespace

bool opencvHasEdgeValues()
{
    return HasEdgeValues<cv::Mat>::value;
}

Lines opencvLines(const cv::Mat1b& edges, const Arguments& arguments, int threshold)
{
    Lines lines;
    houghLines<cv::Mat>(edges, arguments, threshold, lines);
    removeBias(lines, arguments.rho);
    return lines;
}

Lines withRealVotes(const Lines& lines, const cv::Mat1b& edges, const Arguments& arguments)
{
    const std::vector<int> counted = countVotesOnGrid(lines, edges, arguments);
    Lines real = lines;
    for (std::size_t i = 0; i < real.size(); ++i)
        real[i][2] = std::min(real[i][2], static_cast<float>(counted[i]));
    return real;
}

} // namespace conformance
