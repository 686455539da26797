// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "input.hpp"

#include "support/edge_maps.hpp"

namespace benchmark {

namespace {

int thresholdOf(cv::Size size)
{
    return std::max(1, std::min(size.width, size.height) / 5);
}

} // namespace

Input photograph(const std::string& folder, const std::string& name, cv::Size size)
{
    const cv::Mat1b grey = support::scaled(support::readPhotograph(folder, name), size);
    return {name, grey, support::cannyEdges(grey), thresholdOf(size)};
}

Input photographOfDensity(const std::string& folder, const std::string& name, cv::Size size,
                          double density)
{
    Input input = photograph(folder, name, size);
    // The higher the thresholds, the fewer edge pixels.
    double low = 0, high = 1000;
    for (int i = 0; i < 20; ++i)
    {
        const double middle = (low + high) / 2;
        input.edges = support::cannyEdges(input.grey, {middle, 3 * middle});
        (densityOf(input) > density ? low : high) = middle;
    }
    return input;
}

Input randomMap(cv::Size size, double density)
{
    return {"random", cv::Mat1b(), support::randomEdges(size, density, 1), thresholdOf(size)};
}

double densityOf(const Input& input)
{
    return (double)cv::countNonZero(input.edges) / (double)input.edges.total();
}

} // namespace benchmark
