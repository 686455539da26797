// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// From a table of votes to lines in a few plain steps, the same for every rule of the crossing:
// ring maxima, pool, exact count, near-duplicates (doc/algorithm.md, section 4, without the ascent).

#ifndef LINESPACE_CASCADE_PIPELINE_HPP
#define LINESPACE_CASCADE_PIPELINE_HPP

#include <vector>

#include "opencv2/core.hpp"

namespace cascade {

struct PipelineParameters
{
    int threshold;         //!< a line has more exact votes than this
    double candidateRatio; //!< and more than this share of it in the table; 1 for the exact table
    int radius = 2;        //!< of the ring neighbourhood, border points
    std::size_t pool = 4096;
    double distance = 3; //!< pixels, of near-duplicates
    std::size_t maxLines = 100;
};

/** The strongest lines, (rho, theta, exact votes), strongest first.
@param votes where the candidates are looked for; the tables of naiveCascade() or compute().
@param exact what they are counted by, of the same size.
@param image size of the image, which is the frame. */
std::vector<cv::Vec3f> strongestLines(const cv::Mat1i& votes, const cv::Mat1i& exact,
                                      cv::Size image, const PipelineParameters& parameters);

} // namespace cascade

#endif // LINESPACE_CASCADE_PIPELINE_HPP
