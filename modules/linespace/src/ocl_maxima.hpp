// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Candidates on an OpenCL device, from a table that stays there: what peaks.hpp finds on the host.

#ifndef OPENCV_LINESPACE_OCL_MAXIMA_HPP
#define OPENCV_LINESPACE_OCL_MAXIMA_HPP

#include "peaks.hpp"

namespace cv {
namespace linespace {

/** The frame's table where only blocks of it are counted, those that may have chords with more
votes than a cut: as DevicePruning. */
struct PrunedVotes
{
    int block; //!< border points at either end of a block of chords
    //! Queues the count of chords above a cut, in one block of so many.
    std::function<void(int, int)> count;
    std::function<UMat()> needed;   //!< by blocks, whether they were counted
    std::function<void(int)> learn; //!< is told how many were needed
};

//! Keeps its buffers between calls.
class DeviceMaxima
{
public:
    DeviceMaxima() : room_(1 << 12), usual_(-1) {}

    /** As Executor::findMaxima; finds them in the order (s, e).
    @param pruned null: all of the table is counted.
    @param count what is to be done with them on the device, with so many at most. */
    void find(const EdgeMap& edges, const Plan& plan, const VoteTable& table, const Wanted& wanted,
              int suppression, int radius, const PrunedVotes* pruned,
              const std::function<void(const UMat&, int)>& count, std::vector<Candidate>& found);

private:
    UMat histogram_, numbers_, leastVotes_, ends_;
    std::vector<int> leastVotesList_; //!< what leastVotes_ holds
    std::vector<Vec4i> endsList_;     //!< and ends_
    UMat masks_;                      //!< which chords of a run of the table are maxima
    UMat counts_;                     //!< of maxima of tiles of the table
    UMat maxima_;
    int room_; //!< for so many, where all are asked for
    //! What cut the last image should have begun with, -1: there was none. The next one of a video
    //! hardly differs; what is found does not depend on it.
    int usual_;
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_OCL_MAXIMA_HPP
