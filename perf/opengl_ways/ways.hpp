// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Ways to do the same thing on a device of OpenGL, to be timed beside each other: what the paper
// proposes and what the library does.

#ifndef LINESPACE_OPENGL_WAYS_WAYS_HPP
#define LINESPACE_OPENGL_WAYS_WAYS_HPP

#include "gl_merge.hpp"
#include "peaks.hpp"

#include <functional>
#include <string>
#include <vector>

namespace ways {

namespace ls = cv::linespace;

//! A square image, counted: the tables of all levels stay on the device.
struct Input
{
    ls::GlDevice& device;
    ls::Executor& executor; //!< the library's, at work in the same context
    cv::Ptr<const ls::Plan> plan;
    ls::EdgeMap edges;
    std::vector<ls::VoteTable> levels;

    Input(ls::GlDevice& device, ls::Executor& executor, const cv::Mat1b& image);
    const ls::VoteTable& last() const { return levels.back(); }
};

struct Way
{
    std::string step, name;
    int most;                      //!< how many maxima or candidates; 0: not of any
    std::function<void()> prepare; //!< before each turn, not timed; may be empty
    std::function<void()> queue;   //!< the device works from here on, or the host
    std::function<bool()> isRight; //!< after it: whether the result is the library's
    bool isOfHost;
    //! Words of 32 bits and additions or comparisons, of what does not depend on the image.
    double loads, stores, adds;
};

std::vector<Way> mergeWays(Input& input);

/** The strongest local maxima among parallel chords, and the strongest chords whose neighbourhoods
are deleted.
@param isSlow whether to add those ways that look at the whole table for each maximum. */
std::vector<Way> maximaWays(Input& input, int most, bool isSlow);

std::vector<Way> sortingWays(Input& input, int most);

//! Candidates as the device has them: a head of three numbers, how many there are and 0, 0, then
//! those.
std::vector<ls::Candidate> readCandidates(ls::GlDevice& device, const ls::GlBuffer& from);

//! The strongest chords of the last level by the host, in the total order; of the local maxima
//! among parallel chords, or greedily with neighbourhoods of a radius.
std::vector<ls::Candidate> strongestMaxima(Input& input, int most);
std::vector<ls::Candidate> greedyMaxima(Input& input, int most, int radius);

} // namespace ways

#endif // LINESPACE_OPENGL_WAYS_WAYS_HPP
