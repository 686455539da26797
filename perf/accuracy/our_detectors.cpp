// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "detectors.hpp"

#include "opencv2/linespace.hpp"

#include <algorithm>

namespace accuracy {

namespace {

namespace ls = cv::linespace;

struct Configuration
{
    bool oriented;
    int selection, method, refine;
};

std::vector<DetectedLine> detect(const Configuration& configuration, const EdgeInput& input,
                                 const Request& request)
{
    const auto detector =
        ls::LineSpaceDetector::create(request.minVotes, request.maxLines, configuration.method);
    detector->setSelection(configuration.selection);
    detector->setRefine(configuration.refine);
    std::vector<cv::Vec3f> lines;
    if (configuration.oriented)
        detector->detect(input.edges, input.dx, input.dy, lines);
    else
        detector->detect(input.edges, lines);
    std::vector<DetectedLine> result;
    for (const cv::Vec3f& line : lines)
        result.push_back({line[0], line[1], line[2]});
    return result;
}

Detector detector(const std::string& name, const Configuration& configuration)
{
    return [=](const EdgeInput& input, const Request& request)
    {
        return std::vector<Result>{{name, detect(configuration, input, request)}};
    };
}

} // namespace

int lowThreshold(cv::Size size)
{
    return std::max(1, cvRound(0.05 * std::min(size.width, size.height)));
}

int minVotesWithoutRule(cv::Size size)
{
    return std::max(1, cvRound(0.3 * std::min(size.width, size.height)));
}

std::vector<Detector> ourDetectors()
{
    std::vector<Detector> detectors = ourDetectorsByOwnRule();
    detectors.insert(detectors.begin(),
                     detector("Line Space plain", {false, ls::SELECT_PEAKS, ls::METHOD_CASCADED,
                                                   ls::REFINE_LEAST_SQUARES}));
    return detectors;
}

std::vector<Detector> ourDetectorsByOwnRule()
{
    return {detector("Line Space explain",
                     {false, ls::SELECT_EXPLAIN, ls::METHOD_CASCADED, ls::REFINE_LEAST_SQUARES}),
            detector("Line Space oriented",
                     {true, ls::SELECT_EXPLAIN, ls::METHOD_CASCADED, ls::REFINE_LEAST_SQUARES})};
}

Detector unrefinedDetector()
{
    return detector("Line Space oriented unrefined",
                    {true, ls::SELECT_EXPLAIN, ls::METHOD_CASCADED, ls::REFINE_NONE});
}

Detector exactDetector()
{
    return detector("Line Space oriented exact",
                    {true, ls::SELECT_EXPLAIN, ls::METHOD_EXACT, ls::REFINE_LEAST_SQUARES});
}

} // namespace accuracy
