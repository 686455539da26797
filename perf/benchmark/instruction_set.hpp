// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The instruction sets that the library chooses from at run time.

#ifndef LINESPACE_BENCHMARK_INSTRUCTION_SET_HPP
#define LINESPACE_BENCHMARK_INSTRUCTION_SET_HPP

#include <string>
#include <vector>

namespace benchmark {

//! What this process uses: one of instructionSets().
std::string instructionSet();

struct InstructionSet
{
    std::string name;
    std::string disable; //!< OPENCV_CPU_DISABLE that makes a process use it
};

//! Those of this process, best first: what it uses and all below; the last one is "baseline".
std::vector<InstructionSet> instructionSets();

} // namespace benchmark

#endif // LINESPACE_BENCHMARK_INSTRUCTION_SET_HPP
