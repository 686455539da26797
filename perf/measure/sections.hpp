// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The sections of doc/measurements.md; each writes markdown.

#ifndef LINESPACE_MEASURE_SECTIONS_HPP
#define LINESPACE_MEASURE_SECTIONS_HPP

#include <ostream>
#include <string>

namespace measure {

struct Settings
{
    std::string data; //!< folder of OpenCV's sample images
    int largest;      //!< longest side of the images that are timed
    int runs;         //!< of each timed call; an odd number
};

/** Times of the detector and of HoughLines beside cv::HoughLines. Throws std::runtime_error if the
lines that are timed are not the reference's. */
void writeTimes(std::ostream& out, const Settings& settings);

//! Peak memory of detect() at 1920 x 1080, of a process of its own.
void writeMemory(std::ostream& out, const Settings& settings);

//! What must hold between the times of ours and of others, one row each; returns whether all of it
//! does.
bool writeRequirements(std::ostream& out, const Settings& settings);

//! What the lines cost beyond the votes, beside cv::ximgproc::FastHoughTransform.
void writeSelection(std::ostream& out, const Settings& settings);

//! Cascaded against exact votes for several cell sizes.
void writeVoteRatio(std::ostream& out, const Settings& settings);

} // namespace measure

#endif // LINESPACE_MEASURE_SECTIONS_HPP
