// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "line_error.hpp"

#include <cmath>
#include <limits>

namespace cascade {

double lineError(const cv::Vec4f& ends, const cv::Vec3f& line)
{
    const double cosine = std::cos(line[1]), sine = std::sin(line[1]);
    return std::max(std::abs(ends[0] * cosine + ends[1] * sine - line[0]),
                    std::abs(ends[2] * cosine + ends[3] * sine - line[0]));
}

double leastError(const cv::Vec4f& ends, const std::vector<cv::Vec3f>& lines, std::size_t count)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < std::min(count, lines.size()); ++i)
        least = std::min(least, lineError(ends, lines[i]));
    return least;
}

int countFound(const std::vector<cv::Vec4f>& ends, const std::vector<cv::Vec3f>& lines,
               std::size_t count)
{
    int found = 0;
    for (const cv::Vec4f& line : ends)
        found += leastError(line, lines, count) <= SAME_LINE;
    return found;
}

} // namespace cascade
