// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// What the way from votes to lines costs: candidates, exact votes, selection, refinement.

#include "sections.hpp"

#include "common/stopwatch.hpp"
#include "support/edge_maps.hpp"

#include "opencv2/imgproc.hpp"
#include "opencv2/linespace.hpp"
#include "opencv2/ximgproc.hpp"

#include <iomanip>
#include <limits>

namespace measure {

namespace {

namespace ls = cv::linespace;

struct Input
{
    cv::Mat1b edges;
    cv::Mat dx, dy;
};

Input inputOf(const Settings& settings, const char* name, cv::Size size)
{
    const cv::Mat1b grey = support::scaled(support::readPhotograph(settings.data, name), size);
    Input input{support::cannyEdges(grey), cv::Mat(), cv::Mat()};
    cv::Sobel(grey, input.dx, CV_16S, 1, 0);
    cv::Sobel(grey, input.dy, CV_16S, 0, 1);
    return input;
}

//! detect() for at most `most` lines with more votes than the threshold.
std::function<void()> detection(const Input& input, int threshold, int most, int selection,
                                bool oriented)
{
    const auto detector = ls::LineSpaceDetector::create(threshold, most);
    detector->setSelection(selection);
    return [=]
    {
        std::vector<cv::Vec3f> lines;
        if (oriented)
            detector->detect(input.edges, input.dx, input.dy, lines);
        else
            detector->detect(input.edges, lines);
    };
}

//! Of what is measured in one turn, as the machine's speed may change from turn to turn.
double medianDifference(std::vector<double> minuend, const std::vector<double>& subtrahend)
{
    for (std::size_t i = 0; i < minuend.size(); ++i)
        minuend[i] -= subtrahend[i];
    return median(minuend);
}

} // namespace

void writeSelection(std::ostream& out, const Settings& settings)
{
    const cv::Size size(512, 512);
    const int threshold = size.width / 10, nothing = std::numeric_limits<int>::max();
    const int runs = 5 * settings.runs; // small differences of large times
    out << "## From votes to lines\n\n"
        << size.width << " x " << size.height << ", milliseconds, medians of " << runs
        << " runs in turn. *Search*: what `detect` for the strongest line above " << threshold
        << " votes takes longer than the votes alone (a threshold that nothing can exceed): the "
           "pool of candidates climbs to the maxima of the exact votes. *100 lines*: what `detect` "
           "for the 100 strongest takes longer than for one: selection and refinement. Both are "
           "medians of differences within a turn. FHT is "
           "cv::ximgproc::FastHoughTransform, the transform alone, which uses one thread.\n\n"
           "| image | threads | votes, selection | detect | search | 100 lines | FHT | 100 lines / "
           "FHT | search and 100 lines / FHT | detect / FHT |\n"
           "| --- | ---: | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n"
        << std::fixed;
    for (const int threads : {1, 2})
    {
        cv::setNumThreads(threads);
        for (const char* name : {"building.jpg", "board.jpg", "home.jpg", "sudoku.png"})
        {
            const Input input = inputOf(settings, name, size);
            const auto transform = [&]
            {
                cv::Mat hough;
                cv::ximgproc::FastHoughTransform(input.edges, hough, CV_32S);
            };
            for (const bool oriented : {false, true})
                for (const int selection : {ls::SELECT_PEAKS, ls::SELECT_EXPLAIN})
                {
                    const auto times =
                        timesInTurn({detection(input, threshold, 100, selection, oriented),
                                     detection(input, threshold, 1, selection, oriented),
                                     detection(input, nothing, 1, selection, oriented), transform},
                                    runs);
                    const double lines = medianDifference(times[0], times[1]),
                                 search = medianDifference(times[1], times[2]),
                                 detect = median(times[0]), hough = median(times[3]);
                    out << "| " << name << " | " << threads << " | "
                        << (oriented ? "oriented" : "plain")
                        << (selection == ls::SELECT_PEAKS ? ", peaks | " : ", explain | ")
                        << std::setprecision(1) << detect << " | " << search << " | " << lines
                        << " | " << hough << " | " << std::setprecision(2) << lines / hough << " | "
                        << (search + lines) / hough << " | " << detect / hough << " |\n";
                }
        }
    }
    cv::setNumThreads(-1);
    out << "\n";
}

} // namespace measure
