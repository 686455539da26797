// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#ifndef LINESPACE_BENCHMARK_SETTINGS_HPP
#define LINESPACE_BENCHMARK_SETTINGS_HPP

#include <string>
#include <vector>

#include "opencv2/core.hpp"

namespace benchmark {

struct Settings
{
    std::string data;                      //!< folder of OpenCV's sample images
    std::string output;                    //!< folder to write to
    std::vector<std::string> newerPythons; //!< each has another newer cv2
    std::string program;                   //!< this program's path, for child processes
    int turns;                             //!< most calls of a method on one input
    double budget;                         //!< milliseconds for the calls of a method on one input
    int threads; //!< of what is timed, where not the threads are the matter
    bool quick;  //!< small images: shows that everything works, tells nothing of speed

    //! The values that the quick run keeps: the first `count`.
    template<class Value>
    std::vector<Value> some(std::vector<Value> values, std::size_t count) const
    {
        if (quick && values.size() > count)
            values.erase(values.begin() + count, values.end());
        return values;
    }
};

inline std::vector<std::string> photographNames(const Settings& settings)
{
    return settings.some<std::string>({"building.jpg", "board.jpg", "home.jpg", "sudoku.png"}, 2);
}

//! What is compared on photographs; the quick run has another, so that none takes it for these.
inline std::vector<cv::Size> photographSizes(const Settings& settings)
{
    if (settings.quick)
        return {{128, 96}};
    return {{512, 512}, {1024, 1024}, {1920, 1080}};
}

} // namespace benchmark

#endif // LINESPACE_BENCHMARK_SETTINGS_HPP
