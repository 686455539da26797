// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "sections.hpp"

#include "common/stopwatch.hpp"
#include "support/edge_maps.hpp"

#include "opencv2/imgproc.hpp"
#include "opencv2/linespace.hpp"

#include <algorithm>
#include <iomanip>
#include <map>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace measure {

namespace {

namespace ls = cv::linespace;

void requireReferenceLines(const cv::Mat1b& edges, int threshold)
{
    std::vector<cv::Vec3f> expected, actual;
    ls::LineSpaceDetector::create(threshold, 100, ls::METHOD_CASCADED, 8, ls::BACKEND_REFERENCE)
        ->detect(edges, expected);
    ls::LineSpaceDetector::create(threshold, 100, ls::METHOD_CASCADED, 8, ls::BACKEND_CPU)
        ->detect(edges, actual);
    if (expected != actual)
        throw std::runtime_error("the lines of the CPU path are not the reference's");
}

std::string ratio(double slower, double faster)
{
    std::ostringstream text;
    text << std::fixed << std::setprecision(slower / faster < 10 ? 1 : 0) << slower / faster << "x";
    return text.str();
}

const char* const photographs[] = {"building.jpg", "board.jpg", "home.jpg", "sudoku.png"};

} // namespace

void writeTimes(std::ostream& out, const Settings& settings)
{
    out << std::fixed << std::setprecision(1);
    out << "## Times beside cv::HoughLines\n\n"
           "Milliseconds, medians of "
        << settings.runs
        << " runs, one after the other in turn, warm; Canny 50/150 of the photograph at the size "
           "given; threshold a fifth of "
           "the shorter side. cv::HoughLines of this version uses one thread whatever is asked "
           "for; its times at two "
           "threads are repeated measurements, but for 1/(2n), which is timed once (ours once with "
           "each number of threads). `detect` reports the 100 strongest lines, refined; "
           "`significant` is "
           "threshold 0 with SELECT_EXPLAIN. 1/(2n) is the paper's fair angle step.\n\n";
    std::map<std::string, double> finestTimes; // of cv::HoughLines, by image and size
    for (const int threads : {1, 2})
    {
        cv::setNumThreads(threads);
        out << "### " << threads << (threads == 1 ? " thread\n\n" : " threads\n\n")
            << "| image | size | edge pixels | detect | significant | cv 1° | ours 1° | cv 0.1° | "
               "ours 0.1° | cv 1/(2n) | "
               "ours 1/(2n) | cv 1° / detect | cv 1/(2n) / detect | cv / ours 1° | cv / ours 0.1° "
               "| "
               "cv / ours 1/(2n) |\n| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | "
               "---: | ---: | ---: | ---: | ---: | ---: | ---: |\n";
        for (const cv::Size size : {cv::Size(512, 512), cv::Size(1024, 1024), cv::Size(1920, 1080)})
            for (const char* name : photographs)
            {
                if (size.width > settings.largest)
                    continue;
                const cv::Mat1b edges = support::cannyEdges(
                    support::scaled(support::readPhotograph(settings.data, name), size));
                const int threshold = std::min(size.width, size.height) / 5;
                if (threads == 1 && size.width == 512)
                    requireReferenceLines(edges, threshold);
                const auto fixed = ls::LineSpaceDetector::create(threshold, 100);
                const auto significant = ls::LineSpaceDetector::create(0, 100);
                significant->setSelection(ls::SELECT_EXPLAIN);
                std::vector<cv::Vec3f> found;
                std::vector<cv::Vec2f> lines;
                const double fine = 0.5 / std::max(size.width, size.height);
                const std::vector<double> quick =
                    medians({[&] { fixed->detect(edges, found); },
                             [&] { significant->detect(edges, found); },
                             [&] { cv::HoughLines(edges, lines, 1, CV_PI / 180, threshold); },
                             [&]
                             {
                                 ls::HoughLines(edges, lines, 1, CV_PI / 180, threshold);
                             }},
                            settings.runs);
                const std::vector<double> slow =
                    medians({[&] { cv::HoughLines(edges, lines, 1, CV_PI / 1800, threshold); },
                             [&]
                             {
                                 ls::HoughLines(edges, lines, 1, CV_PI / 1800, threshold);
                             }},
                            size.width > 512 ? 1 : std::min(settings.runs, 3));
                double& finest = finestTimes[name + std::to_string(size.width)];
                if (finest == 0)
                    finest =
                        millisecondsOf([&] { cv::HoughLines(edges, lines, 1, fine, threshold); });
                const double oursFinest =
                    millisecondsOf([&] { ls::HoughLines(edges, lines, 1, fine, threshold); });
                out << "| " << name << " | " << size.width << " x " << size.height << " | "
                    << cv::countNonZero(edges) << " | " << quick[0] << " | " << quick[1] << " | "
                    << quick[2] << " | " << quick[3] << " | " << slow[0] << " | " << slow[1]
                    << " | " << finest << " | " << oursFinest << " | " << ratio(quick[2], quick[0])
                    << " | " << ratio(finest, quick[0]) << " | " << ratio(quick[2], quick[3])
                    << " | " << ratio(slow[0], slow[1]) << " | " << ratio(finest, oursFinest)
                    << " |\n";
            }
        out << "\n";
    }

    out << "### The reference\n\nOne thread, 512 x 512, the same `detect`, milliseconds (one "
           "run).\n\n"
           "| image | reference | CPU path | ratio |\n| --- | ---: | ---: | ---: |\n";
    cv::setNumThreads(1);
    for (const char* name : photographs)
    {
        const cv::Mat1b edges = support::cannyEdges(
            support::scaled(support::readPhotograph(settings.data, name), cv::Size(512, 512)));
        const auto reference =
            ls::LineSpaceDetector::create(102, 100, ls::METHOD_CASCADED, 8, ls::BACKEND_REFERENCE);
        const auto cpu =
            ls::LineSpaceDetector::create(102, 100, ls::METHOD_CASCADED, 8, ls::BACKEND_CPU);
        std::vector<cv::Vec3f> lines;
        const double slow = millisecondsOf([&] { reference->detect(edges, lines); });
        const double fast = medians({[&]
                                     {
                                         cpu->detect(edges, lines);
                                     }},
                                    settings.runs)[0];
        out << "| " << name << " | " << slow << " | " << fast << " | " << ratio(slow, fast)
            << " |\n";
    }
    out << "\n";
    cv::setNumThreads(-1);
}

} // namespace measure
