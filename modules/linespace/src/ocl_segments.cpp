// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include <cvconfig.h>

#ifdef HAVE_OPENCL

#include "ocl_segments.hpp"

namespace cv {
namespace linespace {

DeviceCrossings deviceCrossings(const CrossingRun& run, int stride, int count)
{
    const double sign = run.denominator(0) < 0 ? -1 : 1;
    const int last = stride * (count - 1);
    asInt(run.numerator(last));
    asInt(run.denominator(last));
    const DeviceCrossings result = {asInt(sign * run.numerator(0)),
                                    asInt(sign * (run.numerator(stride) - run.numerator(0))),
                                    asInt(sign * run.denominator(0)),
                                    asInt(sign * (run.denominator(stride) - run.denominator(0)))};
    return result;
}

RunOfChords runOfChords(const Segment& segment)
{
    const RunOfChords result = {segment.firstEnd,
                                segment.count,
                                segment.isCrossing,
                                segment.childS,
                                asInt((double)segment.chordS),
                                (int)segment.strideS,
                                asInt((double)segment.chordE),
                                (int)segment.strideE,
                                (int)segment.stepE};
    return result;
}

std::vector<BorderRow> rowsOf(const Cell& cell)
{
    std::vector<BorderRow> rows;
    for (int s = 0; s < cell.firstPoint(SIDE_LEFT); ++s)
    {
        const int side = cell.sideOf(s);
        const BorderRow row = {asInt((double)cell.rowStart(s)), cell.rowLength(side), 0,
                               cell.firstPartner(side)};
        rows.push_back(row);
    }
    return rows;
}

} // namespace linespace
} // namespace cv

#endif // HAVE_OPENCL
