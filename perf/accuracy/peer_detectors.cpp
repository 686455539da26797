// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "detectors.hpp"

#include "segment_lines.hpp"
#include "suppression.hpp"

#include "opencv2/imgproc.hpp"
#include "opencv2/ximgproc.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace accuracy {

namespace {

using Lines = std::vector<DetectedLine>;

int thresholdOf(const Request& request, cv::Size size)
{
    return request.minVotes > 0 ? request.minVotes : minVotesWithoutRule(size);
}

Lines strongest(Lines lines, int maxLines)
{
    if (maxLines > 0 && (int)lines.size() > maxLines)
        lines.resize(maxLines);
    return lines;
}

/** cv::HoughLines. OpenCV before 4.13 reports rho half a step too small where its number of rho
cells is even (issue 25038); that is put right here, so that the method is compared and not a bug.
@param theta radians; 0: 1/(2n), n the image's longer side. */
Lines houghLines(const EdgeInput& input, double rho, double theta, const Request& request)
{
    const cv::Size size = input.edges.size();
    if (theta == 0)
        theta = 0.5 / std::max(size.width, size.height);
    std::vector<cv::Vec3f> found;
    cv::HoughLines(input.edges, found, rho, theta, thresholdOf(request, size));
    Lines lines;
    for (const cv::Vec3f& line : found)
    {
        const double cell = line[0] / rho;
        const bool biased = std::abs(cell - std::round(cell)) > 0.25;
        lines.push_back({line[0] + (biased ? 0.5 * rho : 0), line[1], line[2]});
    }
    return lines;
}

/** @param suppressedOnly leaves the result without suppression out. */
Detector houghDetector(const std::string& resolution, double rho, double theta,
                       bool suppressedOnly = false)
{
    const std::string name = "HoughLines " + resolution;
    return [=](const EdgeInput& input, const Request& request)
    {
        const Lines lines = houghLines(input, rho, theta, request);
        std::vector<Result> results;
        if (!suppressedOnly)
            results.push_back({name, strongest(lines, request.maxLines)});
        if (request.maxLines != 1)
            results.push_back({name + " suppressed",
                               withoutNearDuplicates(lines, input.edges.size(), request.maxLines)});
        return results;
    };
}

/** cv::ximgproc::FastHoughTransform over all directions: the maxima of 5 x 5 cells, strongest
first, turned into lines by cv::ximgproc::HoughPoint2Line, without near-duplicates. */
Lines fastHough(const EdgeInput& input, const Request& request)
{
    const cv::Size size = input.edges.size();
    cv::Mat table, maxima;
    cv::ximgproc::FastHoughTransform(input.edges / 255, table, CV_32S, cv::ximgproc::ARO_315_135,
                                     cv::ximgproc::FHT_ADD, cv::ximgproc::HDO_DESKEW);
    cv::Mat1f votes = table;
    cv::dilate(votes, maxima, cv::Mat::ones(5, 5, CV_8U));
    const int threshold = thresholdOf(request, size);
    std::vector<std::pair<float, cv::Point>> peaks;
    for (int y = 0; y < votes.rows; ++y)
        for (int x = 0; x < votes.cols; ++x)
            if (votes(y, x) > threshold && votes(y, x) == maxima.at<float>(y, x))
                peaks.push_back({votes(y, x), cv::Point(x, y)});
    std::stable_sort(peaks.begin(), peaks.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    Lines lines;
    for (const auto& peak : peaks)
    {
        const cv::Vec4i ends = cv::ximgproc::HoughPoint2Line(peak.second, input.edges);
        const double dx = ends[2] - ends[0], dy = ends[3] - ends[1];
        if (dx == 0 && dy == 0)
            continue;
        const double theta = std::atan2(dx, -dy);
        lines.push_back({ends[0] * std::cos(theta) + ends[1] * std::sin(theta), theta, peak.first});
    }
    return withoutNearDuplicates(lines, size, request.maxLines);
}

Lines linesOf(const std::vector<cv::Vec4f>& segments, cv::Size size, const Request& request)
{
    // Segments are not edge pixels: no threshold but the shortest segment that begins a line.
    return withoutNearDuplicates(fittedLines(segments), size, request.maxLines);
}

/** cv::createLineSegmentDetector. It works on the image scaled by 0.8 and leaves out of account that
pixel centres are half a pixel from the border in both images: its x and y are too small by
0.5 / 0.8 - 0.5. That is put right here too. */
Lines lsd(const EdgeInput& input, const Request& request)
{
    const double scale = 0.8; // its default
    std::vector<cv::Vec4f> segments;
    cv::createLineSegmentDetector(cv::LSD_REFINE_STD, scale)->detect(input.grey, segments);
    for (cv::Vec4f& segment : segments)
        segment += cv::Vec4f::all((float)(0.5 / scale - 0.5));
    return linesOf(segments, input.grey.size(), request);
}

//! Its own edge detector switched off (aperture 0): it takes the edge map, and erases what it uses.
Lines fastLineDetector(const EdgeInput& input, const Request& request)
{
    std::vector<cv::Vec4f> segments;
    cv::ximgproc::createFastLineDetector(10, 1.414213562f, 50, 50, 0)
        ->detect(input.edges.clone(), segments);
    return linesOf(segments, input.edges.size(), request);
}

std::vector<Detector> joined(std::vector<Detector> first, const std::vector<Detector>& second)
{
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

Detector detector(const std::string& name, Lines (*detect)(const EdgeInput&, const Request&))
{
    return [=](const EdgeInput& input, const Request& request)
    {
        return std::vector<Result>{{name, detect(input, request)}};
    };
}

} // namespace

std::vector<Detector> peerDetectors()
{
    return {houghDetector("1 px 1 deg", 1, CV_PI / 180),
            houghDetector("0.5 px 0.25 deg", 0.5, CV_PI / 720),
            houghDetector("1 px 1/(2n)", 1, 0),
            detector("FastHoughTransform", fastHough),
            detector("LSD", lsd),
            detector("FastLineDetector", fastLineDetector)};
}

std::vector<Detector> peerDetectorsByOwnRule()
{
    return {houghDetector("1 px 1 deg", 1, CV_PI / 180, true), detector("LSD", lsd)};
}

std::vector<Detector> allDetectors()
{
    return joined(ourDetectors(), peerDetectors());
}

std::vector<Detector> detectorsByOwnRule()
{
    return joined(ourDetectorsByOwnRule(), peerDetectorsByOwnRule());
}

} // namespace accuracy
