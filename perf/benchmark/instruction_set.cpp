// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "instruction_set.hpp"

#include "opencv2/core.hpp"

namespace benchmark {

namespace {

struct Dispatched
{
    const char* name;
    const char* disabledBy; //!< OPENCV_CPU_DISABLE's name for it
    int feature;
};

// Those of linespace_dispatch.cmake, best first; where there are none, the baseline alone is built.
const Dispatched dispatched[] = {{"AVX512_SKX", "AVX512-SKX", CV_CPU_AVX512_SKX},
                                 {"AVX2", "AVX2", CV_CPU_AVX2}};

} // namespace

std::vector<InstructionSet> instructionSets()
{
    std::vector<InstructionSet> sets;
    std::string disable;
    for (const Dispatched& set : dispatched)
        if (cv::checkHardwareSupport(set.feature))
        {
            sets.push_back({set.name, disable});
            disable += (disable.empty() ? "" : ",") + std::string(set.disabledBy);
        }
    sets.push_back({"baseline", disable});
    return sets;
}

std::string instructionSet()
{
    return instructionSets().front().name;
}

} // namespace benchmark
