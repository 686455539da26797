// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Calls that other processes make and time; see child_process.hpp.

#ifndef LINESPACE_BENCHMARK_HELPERS_HPP
#define LINESPACE_BENCHMARK_HELPERS_HPP

#include "calls.hpp"
#include "child_process.hpp"
#include "instruction_set.hpp"
#include "settings.hpp"

namespace benchmark {

/** cv2.HoughLines of a newer OpenCV, by newer_opencv.py; null, with the reason on standard error,
where there is none. */
std::shared_ptr<ChildProcess> newerOpenCv(const Settings& settings);
Call newerHoughLines(const std::shared_ptr<ChildProcess>& python, const Settings& settings,
                     const Input& input, const std::string& step, int threshold);

//! `detect` by this program on one of instructionSets(); throws if another one really runs.
std::shared_ptr<ChildProcess> onInstructionSet(const Settings& settings, const InstructionSet& set);
Call helperDetection(const std::shared_ptr<ChildProcess>& helper, const Settings& settings,
                     const InstructionSet& set, const Input& input, Kind kind);

/** The other side: answers on standard output the questions on standard input, until it ends.
    isa                                  name of the instruction set
    detect FILE THRESHOLD KIND THREADS   milliseconds, lines, valid, then name and milliseconds of each
                                         stage; KIND is a number, that of DETECT or UNPRUNED
Fields are separated by tabs. */
void serve();

} // namespace benchmark

#endif // LINESPACE_BENCHMARK_HELPERS_HPP
