// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Chooses the instruction set of the neighbouring chords' inner loop (chord_lanes.simd.hpp).

#include "chord_lanes.simd.hpp"
#include "chord_lanes.simd_declarations.hpp"

namespace cv {
namespace linespace {

bool hasChordLanes()
{
    CV_CPU_DISPATCH(hasLanes, (), CV_CPU_DISPATCH_MODES_ALL);
}

void countChordLanes(const ChordLanes& lanes, const LaneMap& map, int* votes)
{
    CV_CPU_DISPATCH(countLanes, (lanes, map, votes), CV_CPU_DISPATCH_MODES_ALL);
}

} // namespace linespace
} // namespace cv
