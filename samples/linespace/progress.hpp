// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// A bar on the terminal with rate and time left. Of the C++ progress bars packaged for both Debian
// 12 and 13, Boost's progress_display and biosoup's ProgressBar, neither shows a rate or the time
// left nor fits the width of the terminal; hence these few lines.

#ifndef LINESPACE_SAMPLES_PROGRESS_HPP
#define LINESPACE_SAMPLES_PROGRESS_HPP

#include <chrono>
#include <string>

namespace program {

/** The bar as text.
@param total 0 if unknown: then neither a bar nor the time left is shown.
@param width of the terminal; the text is shorter than this, so that no terminal wraps it.
@param label shortened at its start where it does not fit. */
std::string progressText(int done, int total, double seconds, int width, const std::string& label);

//! Shows a bar on the standard error output and keeps other output clear of it.
class Progress
{
public:
    //! enabled: whether a bar is wanted; it is shown only where the standard error output is a
    //! terminal.
    Progress(int total, bool enabled);
    ~Progress(); //!< removes the bar

    bool isShown() const { return shown_; }
    void update(int done, const std::string& label);

    //! Prints a line on the standard output or error output; the bar comes back with the next
    //! update.
    void print(const std::string& line);
    void printError(const std::string& line);

private:
    void erase();

    using Clock = std::chrono::steady_clock;
    int total_;
    bool shown_;
    Clock::time_point start_;
    Clock::time_point nextUpdate_;
};

} // namespace program

#endif // LINESPACE_SAMPLES_PROGRESS_HPP
