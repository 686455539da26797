// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Why the cascade does not report a line of the exact method: the first change of the detector's
// parameters that brings it back tells.

#ifndef LINESPACE_CASCADE_LOSSES_HPP
#define LINESPACE_CASCADE_LOSSES_HPP

#include "inputs.hpp"

#include <ostream>
#include <vector>

namespace cascade {

//! In this order, the first that brings the line back; each keeps what those before it changed.
enum Cause
{
    RANK_LONGER,  //!< it is among 5 % more lines: nearly equal votes at the end of the list
    RANK_LONGEST, //!< it is among LONGEST lines
    POOL,         //!< with all candidates in the pool, none left out
    RATIO,        //!< with a candidate ratio of 0.5
    NO_MAXIMUM,   //!< with every chord a candidate (radius 0), above the default ratio
    BOTH,         //!< with every chord above half of the threshold a candidate
    NEVER,        //!< by none of them
    CAUSE_COUNT
};

//! A line of the exact method that the cascade does not report with the defaults, unrefined.
struct Loss
{
    Source source;
    bool oriented;
    cv::Vec3f line;    //!< of the exact method: rho, theta, votes
    int rank;          //!< in the exact method's list, 1 is the strongest
    int threshold;     //!< votes
    int weakest;       //!< votes of the weakest line that the cascade reports
    double neighbour;  //!< line error in pixels of the nearest line that the cascade reports
    bool padded;       //!< the cascade's frame is larger than the image: its chords are others
    int cascadeVotes;  //!< of the nearest chord of the frame; -1 for an oriented map
    int cascadeAround; //!< the most of the 3 x 3 chords around it; -1 for an oriented map
    Cause cause;
};

std::vector<Loss> lossesOf(const Input& input);

void writeLosses(std::ostream& out, const std::vector<Loss>& losses);
void writeLossesCsv(std::ostream& out, const std::vector<Loss>& losses);

} // namespace cascade

#endif // LINESPACE_CASCADE_LOSSES_HPP
