// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// What the stages of the cascade have to do, from the plan of an image size: bytes and adds, to be
// set beside the machine's limits. The votes of all levels, as with setPruning(false).

#ifndef LINESPACE_BENCHMARK_STAGE_WORK_HPP
#define LINESPACE_BENCHMARK_STAGE_WORK_HPP

#include <string>
#include <vector>

#include "opencv2/core.hpp"

namespace benchmark {

struct StageWork
{
    std::string stage; //!< its name, as of LineSpaceDetector::getStageTimes
    /** Bytes that cannot be avoided: what the stage before left is read once, what the next one
    needs is written once. */
    double bytesRead, bytesWritten;
    //! Bytes that instructions load and store: a merge reads what it has read already.
    double bytesLoaded, bytesStored;
    double adds;      //!< of votes
    int bytesPerVote; //!< of an add
};

//! In the order of the stages; those whose work depends on the image are missing.
std::vector<StageWork> stageWork(cv::Size image, int cellSize);

/** What BACKEND_OPENGL does in words of 32 bits, of which a chord has at least one. What other ways of a
merge would load is counted as well; words that are loaded again count again. */
struct WordWork
{
    std::string stage;
    double loads, stores, adds;
    //! Of tiles of 8 x 8 chords that share their parts in the memory of their work group; 0: no merge.
    double sharedLoads;
    //! Of this merge and the one below at once, a step of 2 x 2 cells, whose table in between is not
    //! stored; 0: no merge, or none below.
    double fusedLoads;
};

//! METHOD_EXACT first, then the stages of the cascade.
std::vector<WordWork> wordWork(cv::Size image, int cellSize);

} // namespace benchmark

#endif // LINESPACE_BENCHMARK_STAGE_WORK_HPP
