// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// cv::HoughLines on the same edge map, and the picture of both.

#ifndef LINESPACE_SAMPLES_COMPARE_HPP
#define LINESPACE_SAMPLES_COMPARE_HPP

#include <string>

#include "finder.hpp"

namespace program {

struct Comparison
{
    cv::Mat picture;
    std::string text; //!< one line: both times
};

//! As many of the strongest lines of cv::HoughLines as the Line Space reports. Both times are the
//! median of up to five runs of the search alone after a first one.
Comparison compare(const Options& options, const Picture& picture, const Found& ours,
                   LineFinder& finder);

} // namespace program

#endif // LINESPACE_SAMPLES_COMPARE_HPP
