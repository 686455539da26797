// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "silence.hpp"

#include <cstdio>

#include <fcntl.h>
#include <unistd.h>

namespace program {

SilentStderr::SilentStderr() : saved_(-1)
{
    std::fflush(stderr);
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (nowhere < 0)
        return; // noisy is better than not at all
    saved_ = fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    if (saved_ >= 0)
        dup2(nowhere, STDERR_FILENO);
    close(nowhere);
}

SilentStderr::~SilentStderr()
{
    if (saved_ < 0)
        return;
    std::fflush(stderr);
    dup2(saved_, STDERR_FILENO);
    close(saved_);
}

} // namespace program
