// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The cascade of doc/algorithm.md, section 3, as plain code with the rule of the crossing as a
// parameter. For square images whose cells divide them; it is made to be read, not to be fast.

#ifndef LINESPACE_CASCADE_NAIVE_CASCADE_HPP
#define LINESPACE_CASCADE_NAIVE_CASCADE_HPP

#include "opencv2/core.hpp"

namespace cascade {

/** Which border points of the shared side a chord that crosses it is joined at. The points are half
a pixel, one and a half, ... from the side's start, so a crossing at a whole coordinate is as far
from two of them: a tie. */
enum class CrossingRule
{
    NEAREST,          //!< the nearest, of two the larger: the rule of the module
    NEAREST_UNBIASED, //!< the nearest; of two the larger for every other chord, see unbiasedTie()
    BOTH_NEIGHBOURS   //!< the points on both sides of the crossing; the larger sum counts
};

//! What the merges of a cascade did, all levels together.
struct MergeCost
{
    double chords = 0;    //!< entries of the tables made by merges
    double crossings = 0; //!< of these, the chords that cross the shared side; others are copied
    double sums = 0;      //!< sums of two parts: an add and two loads each
    double ties = 0;      //!< crossings at a whole coordinate
    double tiesUp = 0;    //!< of these, joined at the larger point only
    double seconds = 0;   //!< of the merges, level 0 not included
};

/** The table of votes LS(s, e) of the frame, B x B with B = 4 n, symmetric.
@param voters n x n pixels: bit b says that the pixel votes for the chords of bin b, see
directions.hpp.
@param cellSize side of the cells of level 0 in pixels; n / cellSize is a power of two. */
cv::Mat1i naiveCascade(const cv::Mat1w& voters, int cellSize, CrossingRule rule, MergeCost& cost);

//! The same by the raster of every chord of the frame.
cv::Mat1i naiveExactVotes(const cv::Mat1w& voters);

//! Position of a border point in doubled coordinates of a cell (section 2.1).
cv::Point borderPoint(cv::Size cell, int number);
bool areOnOneSide(cv::Size cell, int s, int e);

} // namespace cascade

#endif // LINESPACE_CASCADE_NAIVE_CASCADE_HPP
