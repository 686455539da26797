// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "progress.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string_view>

#include <sys/ioctl.h>
#include <unistd.h>

namespace program {

namespace {

template<typename... Values>
std::string format(const char* pattern, Values... values)
{
    char text[64];
    std::snprintf(text, sizeof text, pattern, values...);
    return text;
}

std::string duration(double seconds)
{
    const long long all = static_cast<long long>(std::min(seconds, 359999.0) + 0.5);
    const int h = static_cast<int>(all / 3600), m = static_cast<int>(all / 60 % 60),
              s = static_cast<int>(all % 60);
    return h > 0 ? format("%d:%02d:%02d", h, m, s) : format("%d:%02d", m, s);
}

std::string bar(double share, int width)
{
    const int filled = static_cast<int>(share * width);
    std::string text(static_cast<std::size_t>(filled), '=');
    if (filled < width)
        text += '>';
    text.resize(static_cast<std::size_t>(width), ' ');
    return "[" + text + "]";
}

// The end of a path tells more than its start. A cut must not fall into a UTF-8 character.
std::string lastPart(const std::string& text, std::size_t length)
{
    if (text.size() <= length)
        return text;
    if (length < 4)
        return "";
    std::size_t from = text.size() - length + 3;
    while (from < text.size() && (text[from] & 0xC0) == 0x80)
        ++from;
    return "..." + text.substr(from);
}

int terminalWidth()
{
    winsize size = {};
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
        return size.ws_col;
    return 80;
}

bool isCapableTerminal()
{
    const char* type = std::getenv("TERM");
    return isatty(STDERR_FILENO) && type && std::string_view(type) != "dumb";
}

} // namespace

std::string progressText(int done, int total, double seconds, int width, const std::string& label)
{
    const double rate = seconds > 0 ? done / seconds : 0;
    std::string counts = total > 0 ? format("%d/%d", done, total) : format("%d", done);
    if (done > 0 && rate > 0)
        counts += format("  %.*f/s", rate < 10 ? 1 : 0, rate);
    if (done > 0 && rate > 0 && total > 0)
        counts += "  " + duration((total - done) / rate) + " left";

    std::string text;
    if (total > 0)
    {
        const double share = std::min(1.0, static_cast<double>(done) / total);
        text = format("%3d%% ", static_cast<int>(100 * share));
        const int barWidth = std::min(30, width - 60);
        if (barWidth >= 5)
            text += bar(share, barWidth) + " ";
    }
    text += counts + "  ";
    const int room = width - 1 - static_cast<int>(text.size());
    text += lastPart(label, static_cast<std::size_t>(std::max(0, room)));
    text.resize(std::min(text.size(), static_cast<std::size_t>(std::max(0, width - 1))));
    return text;
}

Progress::Progress(int total, bool enabled)
    : total_(total), shown_(enabled && isCapableTerminal()), start_(Clock::now()),
      nextUpdate_(start_)
{
}

Progress::~Progress()
{
    erase();
}

void Progress::update(int done, const std::string& label)
{
    const Clock::time_point now = Clock::now();
    if (!shown_ || (now < nextUpdate_ && done != total_))
        return;
    nextUpdate_ = now + std::chrono::milliseconds(100);
    const double seconds = std::chrono::duration<double>(now - start_).count();
    std::cerr << "\r\x1b[K" << progressText(done, total_, seconds, terminalWidth(), label)
              << std::flush;
}

void Progress::erase()
{
    if (shown_)
        std::cerr << "\r\x1b[K" << std::flush;
    nextUpdate_ = start_;
}

void Progress::print(const std::string& line)
{
    erase();
    std::cout << line << std::endl;
}

void Progress::printError(const std::string& line)
{
    erase();
    std::cerr << line << std::endl;
}

} // namespace program
