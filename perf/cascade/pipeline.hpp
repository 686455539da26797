// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// From a table of votes to lines in a few plain steps: candidates, pool, exact count, near-duplicates
// (doc/algorithm.md, section 4), with the first and the third as parameters.

#ifndef LINESPACE_CASCADE_PIPELINE_HPP
#define LINESPACE_CASCADE_PIPELINE_HPP

#include <vector>

#include "opencv2/core.hpp"

namespace cascade {

//! Which chords above the threshold are candidates.
enum class Candidates
{
    RING_MAXIMA,     //!< maxima of their ring neighbourhood: SUPPRESS_RING
    PARALLEL_MAXIMA, //!< stronger than their parallel neighbours (s + 1, e - 1) and (s - 1, e + 1)
    EVERY_CHORD
};

//! Where a candidate goes by exact votes.
enum class Ascent
{
    NONE,
    TWO_STEPS, //!< to the strongest of the eight neighbours, twice at most: the module's
    TO_MAXIMUM //!< to the strongest of the ring neighbourhood, until it is a maximum of its own
};

struct PipelineParameters
{
    int threshold;         //!< a line has more exact votes than this
    double candidateRatio; //!< and more than this share of it in the table; 1 for the exact table
    Candidates candidates = Candidates::RING_MAXIMA;
    Ascent ascent = Ascent::NONE;
    std::size_t pool = 8192;
    int radius = 2;      //!< of the ring neighbourhood, border points
    double distance = 3; //!< pixels, of near-duplicates
    std::size_t maxLines = 100;
};

struct PipelineResult
{
    std::vector<cv::Vec3f> lines; //!< (rho, theta, exact votes), strongest first
    std::size_t counted = 0;      //!< chords whose exact votes were asked for
};

/** The strongest lines.
@param votes where the candidates are looked for; B x B, symmetric.
@param exact what they are counted by, of the same size.
@param image size of the image, which is the frame. */
PipelineResult strongestLines(const cv::Mat1i& votes, const cv::Mat1i& exact, cv::Size image,
                              const PipelineParameters& parameters);

} // namespace cascade

#endif // LINESPACE_CASCADE_PIPELINE_HPP
