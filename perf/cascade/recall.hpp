// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// How many of the exact method's strongest lines the cascade reports, through the public interface.

#ifndef LINESPACE_CASCADE_RECALL_HPP
#define LINESPACE_CASCADE_RECALL_HPP

#include "inputs.hpp"

#include <climits>
#include <ostream>
#include <string>
#include <vector>

namespace cascade {

constexpr int STRONGEST = 100; //!< lines of the exact method that are looked for
constexpr int LONGER = 105;    //!< 5 % more lines
constexpr int LONGEST = 256;   //!< the longest list that no pool from 4096 on is enlarged for

//! Parameters of a detection; the others are the detector's defaults.
struct Detection
{
    bool oriented = false;
    int refine = 0;
    int maxLines = STRONGEST;
    int cellSize = 8;    //!< 0: the exact method
    int poolSize = 8192; //!< INT_MAX: all candidates
    double candidateRatio = 0.75;
    int suppressionRadius = 2;
};

std::vector<cv::Vec3f> linesOf(const Input& input, const Detection& detection);

const std::vector<int>& cellSizes();
const std::vector<int>& poolSizes();

//! "all" for INT_MAX.
std::string poolName(int poolSize);

//! What became of the exact method's lines of one image with one setting.
struct Recall
{
    Source source;
    Detection detection;
    int exactLines;   //!< 0 to STRONGEST
    int found;        //!< with as many lines of the cascade
    int foundLonger;  //!< with LONGER lines; -1 where that would enlarge the pool
    int foundLongest; //!< with LONGEST lines; -1 where that would enlarge the pool
};

/** How many of the exact method's lines the exact method itself finds on the image padded to the
frame of the cascade (cells of 8 pixels): the chords of a larger frame are others, so this is the
most that votes for them can give. Unrefined. */
struct FrameRecall
{
    bool oriented, padded;
    int exactLines;
    int foundByCascade; //!< with the defaults
    int foundOnFrame;   //!< by METHOD_EXACT on the padded image
};
std::vector<FrameRecall> frameRecallsOf(const Input& input);
void writeFrameTable(std::ostream& out, const std::vector<FrameRecall>& recalls);

//! All settings of one image.
std::vector<Recall> recallsOf(const Input& input);

//! The tables over cell size and pool for a group of images ("" for all but the synthetic ones).
void writeRecallTables(std::ostream& out, const std::vector<Recall>& recalls);

void writeRecallCsv(std::ostream& out, const std::vector<Recall>& recalls);

} // namespace cascade

#endif // LINESPACE_CASCADE_RECALL_HPP
