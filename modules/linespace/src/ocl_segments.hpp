// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The rows and runs of chords of the plan as the kernels of opencl/segments.cl read them. Only for
// files that are compiled with HAVE_OPENCL.

#ifndef OPENCV_LINESPACE_OCL_SEGMENTS_HPP
#define OPENCV_LINESPACE_OCL_SEGMENTS_HPP

#include "ocl_launch.hpp"

namespace cv {
namespace linespace {

//! As Crossings in segments.cl.
struct DeviceCrossings
{
    int numerator, numeratorStep, denominator, denominatorStep;
};

//! Quotients at(0), at(stride), ... at(stride (count - 1)).
DeviceCrossings deviceCrossings(const CrossingRun& run, int stride, int count);

//! What the structs of runs begin with, before their crossings.
struct RunOfChords
{
    int firstEnd, count, isCrossing, childS, chordS, strideS, chordE, strideE, stepE;
};

RunOfChords runOfChords(const Segment& segment);

//! The rows of a cell's table, so far without segments.
std::vector<BorderRow> rowsOf(const Cell& cell);

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_OCL_SEGMENTS_HPP
