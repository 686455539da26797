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

std::vector<std::vector<double>> timesInTurn(const std::vector<std::function<void()>>& functions,
                                             int runs)
{
    std::vector<std::vector<double>> times(functions.size());
    for (const auto& function : functions)
        function(); // warm
    for (int run = 0; run < runs; ++run)
        for (std::size_t i = 0; i < functions.size(); ++i)
            times[i].push_back(millisecondsOf(functions[i]));
    return times;
}

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

std::vector<double> medians(const std::vector<std::function<void()>>& functions, int runs)
{
    std::vector<double> result;
    for (const std::vector<double>& times : timesInTurn(functions, runs))
        result.push_back(median(times));
    return result;
}

} // namespace measure
