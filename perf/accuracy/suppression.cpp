// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "suppression.hpp"

#include "accuracy/scene.hpp"

#include <algorithm>
#include <cmath>

namespace accuracy {

std::vector<DetectedLine> withoutNearDuplicates(const std::vector<DetectedLine>& lines,
                                                cv::Size size, int maxLines)
{
    const double limit = 3;
    struct Kept
    {
        double rho, c, s;
    };
    std::vector<Kept> kept;
    std::vector<DetectedLine> result;
    for (const DetectedLine& line : lines)
    {
        if (maxLines > 0 && (int)result.size() == maxLines)
            break;
        cv::Point2d ends[2];
        if (!scenes::chordEnds({line.rho, line.theta}, size, ends))
            continue;
        const auto covers = [&](const Kept& other)
        {
            return std::abs(ends[0].x * other.c + ends[0].y * other.s - other.rho) <= limit &&
                   std::abs(ends[1].x * other.c + ends[1].y * other.s - other.rho) <= limit;
        };
        if (std::any_of(kept.begin(), kept.end(), covers))
            continue;
        kept.push_back({line.rho, std::cos(line.theta), std::sin(line.theta)});
        result.push_back(line);
    }
    return result;
}

} // namespace accuracy
