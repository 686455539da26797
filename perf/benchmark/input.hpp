// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// What every method is given.

#ifndef LINESPACE_BENCHMARK_INPUT_HPP
#define LINESPACE_BENCHMARK_INPUT_HPP

#include <string>

#include "opencv2/core.hpp"

namespace benchmark {

struct Input
{
    std::string name;
    cv::Mat1b grey;  //!< empty where there is none, as of random edge maps
    cv::Mat1b edges; //!< of cv::Canny on grey
    int threshold;   //!< votes that a line must exceed
};

//! Canny 50/150 of a photograph at the size; the threshold is a fifth of the shorter side.
Input photograph(const std::string& folder, const std::string& name, cv::Size size);

/** Canny edges of a photograph with the share of edge pixels as near to `density` as the thresholds
of Canny can bring it; those are in a ratio of 1 to 3. */
Input photographOfDensity(const std::string& folder, const std::string& name, cv::Size size,
                          double density);

//! Independent edge pixels.
Input randomMap(cv::Size size, double density);

double densityOf(const Input& input);

} // namespace benchmark

#endif // LINESPACE_BENCHMARK_INPUT_HPP
