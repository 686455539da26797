// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The grid of cases: which edge maps, resolutions, angle ranges and thresholds.

#ifndef LINESPACE_CONFORMANCE_CASES_HPP
#define LINESPACE_CONFORMANCE_CASES_HPP

#include <string>
#include <vector>

#include "lines.hpp"

namespace conformance {

//! Folders of images; an empty one is not there.
struct Folders
{
    std::string samples; //!< samples/data of OpenCV's sources
    std::string extra;   //!< with opencv_extra's stitching/a1.png
};

//! An edge map and what to search on it.
struct Search
{
    std::string image; //!< name and size
    std::string group; //!< what the search is for
    cv::Mat1b edges;
    std::vector<Arguments> arguments;
    //! Either these, or those at which cv::HoughLines gives about so many lines.
    std::vector<int> thresholds, lineCounts;
};

struct Grid
{
    std::vector<Search> searches;
    std::vector<std::string> skipped; //!< one line each: what, and why
    bool isComplete = true;           //!< whether all of OpenCV's sample images are there
};

//! `all`: more of everything, for hours of patience.
Grid makeGrid(const Folders& folders, bool all);

//! The thresholds of a search, given all lines of cv::HoughLines above leastThreshold().
std::vector<int> thresholdsOf(const Search& search, const Lines& lines);
int leastThreshold(const Search& search, const Arguments& arguments);

} // namespace conformance

#endif // LINESPACE_CONFORMANCE_CASES_HPP
