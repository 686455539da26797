// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "sections.hpp"

#include "common/stopwatch.hpp"
#include "support/edge_maps.hpp"

#include "opencv2/imgproc.hpp"
#include "opencv2/linespace.hpp"

#include <iomanip>

namespace measure {

namespace {

namespace ls = cv::linespace;

using Work = std::function<void()>;

//! A row: the first work must take at most so much of the second one's time.
struct Requirement
{
    std::string what;
    double most;
    Work ours, other;
    int runs;
};

bool writeRow(std::ostream& out, const std::string& image, const Requirement& requirement)
{
    const std::vector<double> times =
        medians({requirement.ours, requirement.other}, requirement.runs);
    const double share = times[0] / times[1];
    const bool holds = share <= requirement.most;
    out << "| " << requirement.what << " | " << image << " | " << std::fixed << std::setprecision(1)
        << times[0] << " | " << times[1] << " | " << std::setprecision(3) << share << " | "
        << requirement.most << " | " << (holds ? "yes" : "**no**") << " |\n";
    return holds;
}

Work detection(const cv::Mat1b& edges, int threshold, int backend)
{
    const auto detector =
        ls::LineSpaceDetector::create(threshold, 100, ls::METHOD_CASCADED, 8, backend);
    return [=]
    {
        std::vector<cv::Vec3f> lines;
        detector->detect(edges, lines);
    };
}

Work openCV(const cv::Mat1b& edges, double theta, int threshold)
{
    return [=]
    {
        std::vector<cv::Vec2f> lines;
        cv::HoughLines(edges, lines, 1, theta, threshold);
    };
}

Work dropIn(const cv::Mat1b& edges, double theta, int threshold)
{
    return [=]
    {
        std::vector<cv::Vec2f> lines;
        ls::HoughLines(edges, lines, 1, theta, threshold);
    };
}

std::vector<Requirement> requirementsOn(const cv::Mat1b& edges, int runs)
{
    const int n = edges.cols, threshold = n / 5;
    const double degree = CV_PI / 180;
    const Work detect = detection(edges, threshold, ls::BACKEND_CPU);
    const Work significant = detection(edges, 0, ls::BACKEND_CPU);
    const Work reference = detection(edges, threshold, ls::BACKEND_REFERENCE);
    const Work fair = openCV(edges, 0.5 / n, threshold);
    std::vector<Requirement> list = {
        {"detect beside cv::HoughLines(1, 1/(2n))", 0.25, detect, fair, 3},
        {"detect, threshold 0, beside cv::HoughLines(1, 1/(2n))", 0.25, significant, fair, 3},
        {"detect beside the reference's", 0.2, detect, reference, 3}};
    for (const int least : {n / 5, n / 10})
    {
        const std::string at = ", threshold " + std::to_string(least);
        list.push_back({"HoughLines(1, 1 degree)" + at, 2, dropIn(edges, degree, least),
                        openCV(edges, degree, least), runs});
        list.push_back({"HoughLines(1, 0.1 degree)" + at, 1, dropIn(edges, 0.1 * degree, least),
                        openCV(edges, 0.1 * degree, least), std::min(runs, 3)});
    }
    return list;
}

} // namespace

bool writeRequirements(std::ostream& out, const Settings& settings)
{
    const cv::Size size(512, 512);
    out << "## What is required\n\nOne thread, " << size.width << " x " << size.height
        << ", milliseconds (medians of runs in turn) and their ratio. `HoughLines` is the drop-in "
           "beside "
           "cv::HoughLines with the same arguments.\n\n"
           "| | image | ours | other | ratio | at most | holds |\n"
           "| --- | --- | ---: | ---: | ---: | ---: | --- |\n";
    bool holds = true;
    cv::setNumThreads(1);
    for (const char* name : {"building.jpg", "board.jpg", "home.jpg", "sudoku.png"})
    {
        const cv::Mat1b edges = support::cannyEdges(
            support::scaled(support::readPhotograph(settings.data, name), size));
        for (const Requirement& requirement : requirementsOn(edges, settings.runs))
            holds = writeRow(out, name, requirement) && holds;
    }
    cv::setNumThreads(-1);
    out << "\n";
    return holds;
}

} // namespace measure
