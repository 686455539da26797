// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Candidates on an OpenCL device, from a table that stays there: what peaks.hpp finds on the host.

#ifndef OPENCV_LINESPACE_OCL_MAXIMA_HPP
#define OPENCV_LINESPACE_OCL_MAXIMA_HPP

#include "peaks.hpp"

namespace cv {
namespace linespace {

//! Keeps its buffers between calls.
class DeviceMaxima
{
public:
    DeviceMaxima() : room_(1 << 12) {}

    /** As Executor::findMaxima; finds them in the order (s, e).
    @param count what is to be done with them on the device, with so many at most.
    @return false if it is asked for those that the requirement of several directions or an interval
    of angles leaves. */
    bool find(const EdgeMap& edges, const Plan& plan, const VoteTable& table, const Wanted& wanted,
              int radius, const std::function<void(const UMat&, int)>& count,
              std::vector<Candidate>& found);

private:
    UMat histogram_, numbers_, leastVotes_;
    UMat masks_;  //!< which chords of a run of the table are maxima
    UMat counts_; //!< of maxima of tiles of the table
    UMat maxima_;
    int room_; //!< for so many, where all are asked for
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_OCL_MAXIMA_HPP
