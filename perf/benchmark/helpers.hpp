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

//! This is a Python with a newer OpenCV; it runs newer_opencv.py.
struct NewerOpenCv
{
    std::string version;
    std::shared_ptr<ChildProcess> python;
};

/** Each of settings.newerPythons is started. One that does not work, or has the version of another
one, is left out with the reason on standard error. */
std::vector<NewerOpenCv> newerOpenCvs(const Settings& settings);

/** The calls are cv::HoughLines(1, theta) and cv2.HoughLines of every newer OpenCV, whose version
is in the name: "HoughLines 5.0 1 deg". */
std::vector<Call> everyHoughLines(const Settings& settings, const std::vector<NewerOpenCv>& newer,
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
