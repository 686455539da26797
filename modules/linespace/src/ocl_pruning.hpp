// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The last levels on an OpenCL device without the chords that cannot have more votes than a cut
// (doc/algorithm.md, section 4, point 6), by opencl/pruning.cl: the device's counterpart of
// bundles.hpp.

#ifndef OPENCV_LINESPACE_OCL_PRUNING_HPP
#define OPENCV_LINESPACE_OCL_PRUNING_HPP

#include "stages.hpp"

namespace cv {
namespace linespace {

//! Keeps its buffers between calls.
class DevicePruning
{
public:
    enum
    {
        BLOCK = 8,      //!< border points at either end of a block of chords
        MOST_LEVELS = 3 //!< that have no whole tables
    };

    //! A level above the base level on the device.
    struct Votes
    {
        UMat segments, rows; //!< as kernel mergeCells takes them
        UMat table;          //!< written, but only blocks that are needed
        int depth;
    };

    DevicePruning() : base_(-1), top_(0), pause_(0), rest_(0) {}

    /** The level from whose whole table it goes on; -1 if it cannot: small frames, cells whose
    sides are no multiples of BLOCK, votes of more than 16 bits. */
    static int baseLevel(const Plan& plan, bool weighted);

    //! Whether to try; not if most blocks were needed for the images before.
    bool isWorthATry();

    /** Bounds of all blocks from the base level's table to the last one.
    @param table must stay as it is until the last count(). */
    void bound(const Plan& plan, int base, const VoteTable& table);

    /** Counts the chords of the last level that may have more votes than the cut.
    @param table that of bound().
    @param above the levels from base + 1 on.
    @param sample in one block of so many. */
    void count(const VoteTable& table, const std::vector<Votes>& above, int cut, int sample);

    //! Of the blocks of the last level, in the order of a table of cells of a BLOCK-th of the size:
    //! not 0 if it was counted.
    const UMat& needed() const { return levels_[top_].needed; }

    //! How many there were.
    void learn(int neededCount);

private:
    struct BlockLevel
    {
        Cell coarse;
        int cells;
        int longestRow, rowCount;
        UMat segments, rows; //!< of its merge
        UMat bounds, required, needed;

        BlockLevel() : cells(0), longestRow(0), rowCount(0) {}
    };
    void list(const Plan& plan, int base);

    BlockLevel levels_[MOST_LEVELS + 1]; //!< from the base level on
    int base_;                           //!< that they were listed for; -1: none
    int top_;                            //!< the last one
    int pause_, rest_; //!< images that are not tried after one that was in vain; of these, to come
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_OCL_PRUNING_HPP
