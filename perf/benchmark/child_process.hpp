// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// A helper that answers questions, one line each: another Python, or this program on another
// instruction set. It keeps running, so that its calls can be timed in turn with those of this process.

#ifndef LINESPACE_BENCHMARK_CHILD_PROCESS_HPP
#define LINESPACE_BENCHMARK_CHILD_PROCESS_HPP

#include <cstdio>
#include <string>
#include <vector>

#include <sys/types.h>

namespace benchmark {

class ChildProcess
{
public:
    /** @param command the program and its arguments.
    @param environment NAME=VALUE, in addition to this process's. */
    ChildProcess(const std::vector<std::string>& command,
                 const std::vector<std::string>& environment);
    //! Ends the helper by closing its input.
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    //! Sends a line and waits for the answer; throws std::runtime_error if there is none.
    std::string ask(const std::string& question);

private:
    std::string name_;
    pid_t child_;
    std::FILE *to_, *from_;
};

} // namespace benchmark

#endif // LINESPACE_BENCHMARK_CHILD_PROCESS_HPP
