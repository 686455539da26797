// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "stopwatch.hpp"

#include <algorithm>
#include <chrono>

namespace measure {

double millisecondsOf(const std::function<void()>& work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

std::vector<double> medians(const std::vector<std::function<void()>>& functions, int runs)
{
    std::vector<std::vector<double>> times(functions.size());
    for (const auto& function : functions)
        function(); // warm
    for (int run = 0; run < runs; ++run)
        for (std::size_t i = 0; i < functions.size(); ++i)
            times[i].push_back(millisecondsOf(functions[i]));
    std::vector<double> result;
    for (auto& list : times)
    {
        std::sort(list.begin(), list.end());
        result.push_back(list[list.size() / 2]);
    }
    return result;
}

} // namespace measure
