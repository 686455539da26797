// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Keeps what libraries print on the standard error output out of the program's own messages:
// libpng, libjpeg, FFmpeg and OpenCV all write there about a damaged file, which shall be one line.

#ifndef LINESPACE_SAMPLES_SILENCE_HPP
#define LINESPACE_SAMPLES_SILENCE_HPP

namespace program {

//! While it lives, nothing reaches the standard error output. For one thread at a time.
class SilentStderr
{
public:
    SilentStderr();
    ~SilentStderr();
    SilentStderr(const SilentStderr&) = delete;
    SilentStderr& operator=(const SilentStderr&) = delete;

private:
    int saved_;
};

} // namespace program

#endif // LINESPACE_SAMPLES_SILENCE_HPP
