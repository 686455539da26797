// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Which lines of the grid the drop-in counts: all, or those that the votes of chords next to them
// support (doc/algorithm.md, section 8). Where a line meets the frame is known in integers before a
// table is read, so that every back end reads the same chords.

#ifndef OPENCV_LINESPACE_GRID_SUPPORT_HPP
#define OPENCV_LINESPACE_GRID_SUPPORT_HPP

#include "houghgrid.hpp"

namespace cv {
namespace linespace {

//! Whether it costs less to count all lines of the grid, or the Line Space does not help.
bool countsAllLines(const Plan& plan, const HoughGrid& grid, bool weighted, size_t edgePixels);

//! The votes of chords that a line must have to be counted.
int neededSupport(int threshold);

/** Lines of one angle that meet the same two sides of the frame, as samples at most a pixel apart
across their bands: sample f is number f mod n of line first + f / n, for n samples per line and
the first line of HoughGrid::distanceRange. Where it meets the first of the sides is (from + (f -
begin) fromStep) / 2^32, rounded down, as a number of a border point, which is the next one of the
side where it is beyond; likewise the second side. */
struct SampleRun
{
    int64 begin, end;
    int64 from, fromStep, to, toStep;
    int fromFirst, fromLast, toFirst, toLast; //!< border points of the sides
};

enum
{
    MOST_RUNS = 3,       //!< of an angle: the four corners of the frame are between them
    SAMPLE_FRACTION = 32 //!< bits
};

int samplesPerLine(const HoughGrid& grid);

//! Writes the runs of an angle, the rest of them empty.
void findSampleRuns(const Cell& frame, const HoughGrid& grid, int angle, SampleRun runs[MOST_RUNS]);

/** The lines of an angle that are supported: for each sample the most votes among the chords of the
border points that it meets and their neighbours on the same sides, added up for the samples of a
line, are at least `needed`. */
void supportedDistances(const VoteTable& table, const Cell& frame, const HoughGrid& grid, int angle,
                        int needed, std::vector<int>& distances);

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_GRID_SUPPORT_HPP
