// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "segment_lines.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace accuracy {

namespace {

double length(const cv::Vec4f& segment)
{
    return std::hypot((double)segment[2] - segment[0], (double)segment[3] - segment[1]);
}

//! Total least squares on the points of all segments, each point of equal weight.
DetectedLine fitted(const std::vector<cv::Vec4f>& segments)
{
    double weight = 0, x = 0, y = 0;
    for (const cv::Vec4f& s : segments)
    {
        weight += length(s);
        x += length(s) * 0.5 * ((double)s[0] + s[2]);
        y += length(s) * 0.5 * ((double)s[1] + s[3]);
    }
    x /= weight;
    y /= weight;
    double xx = 0, xy = 0, yy = 0;
    for (const cv::Vec4f& s : segments)
    {
        // Second moments of a segment: those of its middle plus a twelfth of its extent's square.
        const double mx = 0.5 * ((double)s[0] + s[2]) - x, my = 0.5 * ((double)s[1] + s[3]) - y;
        const double ex = (double)s[2] - s[0], ey = (double)s[3] - s[1];
        xx += length(s) * (mx * mx + ex * ex / 12);
        xy += length(s) * (mx * my + ex * ey / 12);
        yy += length(s) * (my * my + ey * ey / 12);
    }
    const double theta = 0.5 * std::atan2(2 * xy, xx - yy) + CV_PI / 2;
    return {x * std::cos(theta) + y * std::sin(theta), theta, weight};
}

bool liesOn(const cv::Vec4f& s, const DetectedLine& line, double limit)
{
    const double c = std::cos(line.theta), n = std::sin(line.theta);
    return std::abs(s[0] * c + s[1] * n - line.rho) <= limit &&
           std::abs(s[2] * c + s[3] * n - line.rho) <= limit;
}

} // namespace

std::vector<DetectedLine> fittedLines(const std::vector<cv::Vec4f>& segments)
{
    const double leastLength = 20, limit = 2;
    std::vector<cv::Vec4f> rest = segments;
    std::stable_sort(rest.begin(), rest.end(),
                     [](const cv::Vec4f& a, const cv::Vec4f& b) { return length(a) > length(b); });
    std::vector<DetectedLine> lines;
    while (!rest.empty() && length(rest.front()) >= leastLength)
    {
        DetectedLine line = fitted({rest.front()});
        const auto member = [&](const cv::Vec4f& segment)
        {
            return liesOn(segment, line, limit);
        };
        for (int pass = 0; pass < 2; ++pass)
        {
            std::vector<cv::Vec4f> members;
            std::copy_if(rest.begin(), rest.end(), std::back_inserter(members), member);
            if (!members.empty())
                line = fitted(members);
        }
        lines.push_back(line);
        const cv::Vec4f first = rest.front();
        rest.erase(std::remove_if(rest.begin(), rest.end(),
                                  [&](const cv::Vec4f& segment)
                                  { return segment == first || member(segment); }),
                   rest.end());
    }
    std::stable_sort(lines.begin(), lines.end(),
                     [](const DetectedLine& a, const DetectedLine& b)
                     { return a.votes > b.votes; });
    return lines;
}

} // namespace accuracy
