// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "compare.hpp"

#include <algorithm>

#include "draw.hpp"
#include "text.hpp"

#include "opencv2/core/utility.hpp"
#include "opencv2/imgproc.hpp"

namespace program {

namespace {

//! search: runs once and returns its milliseconds.
template<typename Search>
double medianMilliseconds(const Search& search)
{
    search();
    std::vector<double> times;
    double sum = 0;
    while (times.size() < 5 && sum < 1000)
    {
        times.push_back(search());
        sum += times.back();
    }
    std::sort(times.begin(), times.end());
    return times[times.size() / 2];
}

// cv::HoughLines has no rule of its own. Half the votes of our weakest line is low enough for it to
// see the same lines, and high enough that it does not spend its time on sorting noise.
int houghThreshold(const Options& options, const Found& ours)
{
    if (options.threshold > 0)
        return options.threshold;
    if (!ours.lines.empty())
        return cvFloor(ours.lines.back()[2] / 2);
    return std::min(ours.size.width, ours.size.height) / 4;
}

} // namespace

Comparison compare(const Options& options, const Picture& picture, const Found& ours,
                   LineFinder& finder)
{
    const double degree = CV_PI / 180;
    const int threshold = houghThreshold(options, ours);
    std::vector<cv::Vec3f> lines;
    const double theirTime = medianMilliseconds(
        [&]
        {
            cv::TickMeter time;
            time.start();
            cv::HoughLines(picture.edges, lines, 1, options.houghStep * degree, threshold, 0, 0,
                           options.minAngle * degree, options.maxAngle * degree);
            time.stop();
            return time.getTimeMilli();
        });
    const double ourTime = medianMilliseconds([&] { return finder.find(picture).milliseconds; });

    const std::size_t wanted = static_cast<std::size_t>(options.maxLines);
    if (wanted > 0 && lines.size() > wanted)
        lines.resize(wanted);

    const std::string theirs = format("cv::HoughLines, 1 px, %g deg: %zu lines, %.1f ms",
                                      options.houghStep, lines.size(), theirTime);
    const std::string own = format("Line Space, %s, %s: %zu lines, %.1f ms", options.method.c_str(),
                                   ours.backend.c_str(), ours.lines.size(), ourTime);
    Comparison result;
    result.picture = sideBySide(drawOver(picture.colors, lines, theirColor), theirs,
                                drawOver(picture.colors, ours.lines, ourColor), own);
    result.text = theirs + "; " + own;
    return result;
}

} // namespace program
