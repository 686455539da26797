// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "compare.hpp"

#include <algorithm>
#include <functional>

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

using Hough = std::function<std::vector<cv::Vec3f>(int threshold)>;

// A threshold that the user gave is the same for both. cv::HoughLines has no rule of its own: half the
// votes of our weakest line is low enough for it to see the same lines, and high enough that it
// does not spend its time on sorting noise. Where that gives fewer lines than are to be shown, half
// as many votes have to do, and so on.
int houghThreshold(const Options& options, const Found& ours, const Hough& hough)
{
    if (options.threshold > 0)
        return options.threshold;
    int threshold = ours.lines.empty() ? std::min(ours.size.width, ours.size.height) / 4
                                       : cvFloor(ours.lines.back()[2] / 2);
    while (threshold > 0 && hough(threshold).size() < static_cast<std::size_t>(options.maxLines))
        threshold /= 2;
    return threshold;
}

} // namespace

Comparison compare(const Options& options, const Picture& picture, const Found& ours,
                   LineFinder& finder)
{
    const double degree = CV_PI / 180;
    const Hough hough = [&](int threshold)
    {
        std::vector<cv::Vec3f> lines;
        cv::HoughLines(picture.edges, lines, 1, options.houghStep * degree, threshold, 0, 0,
                       options.minAngle * degree, options.maxAngle * degree);
        return lines;
    };
    const int threshold = houghThreshold(options, ours, hough);
    std::vector<cv::Vec3f> lines;
    const double theirTime = medianMilliseconds(
        [&]
        {
            cv::TickMeter time;
            time.start();
            lines = hough(threshold);
            time.stop();
            return time.getTimeMilli();
        });
    const double ourTime = medianMilliseconds([&] { return finder.find(picture).milliseconds; });

    const std::size_t wanted = static_cast<std::size_t>(options.maxLines);
    if (wanted > 0 && lines.size() > wanted)
        lines.resize(wanted);

    const std::string theirs =
        format("cv::HoughLines, 1 px, %g deg, above %d votes: %zu lines, %.1f ms",
               options.houghStep, threshold, lines.size(), theirTime);
    const std::string own = format("Line Space, %s, %s: %zu lines, %.1f ms", options.method.c_str(),
                                   ours.backend.c_str(), ours.lines.size(), ourTime);
    Comparison result;
    result.picture = sideBySide(drawOver(picture.colors, lines, theirColor), theirs,
                                drawOver(picture.colors, ours.lines, ourColor), own);
    result.text = theirs + "; " + own;
    return result;
}

} // namespace program
