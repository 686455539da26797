// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "peak_memory.hpp"

#include <stdexcept>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace measure {

namespace {

long peakKibibytes()
{
    rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

} // namespace

long riseOfPeakMemory(const std::function<void()>& work)
{
    int channel[2];
    if (pipe(channel) != 0)
        throw std::runtime_error("cannot make a pipe");
    const pid_t child = fork();
    if (child == 0)
    {
        const long before = peakKibibytes();
        work();
        const long rise = peakKibibytes() - before;
        const bool written = write(channel[1], &rise, sizeof(rise)) == sizeof(rise);
        _exit(written ? 0 : 1);
    }
    close(channel[1]); // so that a child that dies ends the wait for its answer
    long rise = 0;
    const bool read = child > 0 && ::read(channel[0], &rise, sizeof(rise)) == sizeof(rise);
    close(channel[0]);
    if (child > 0)
        waitpid(child, nullptr, 0);
    if (!read)
        throw std::runtime_error("the child process that measures memory failed");
    return rise;
}

} // namespace measure
