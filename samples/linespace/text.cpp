// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "text.hpp"

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <new>

#include "finder.hpp"

namespace program {

std::string format(const char* pattern, ...)
{
    std::va_list values, again;
    va_start(values, pattern);
    va_copy(again, values);
    const int length = std::vsnprintf(nullptr, 0, pattern, values);
    std::string text(static_cast<std::size_t>(std::max(length, 0)) + 1, '\0');
    std::vsnprintf(&text[0], text.size(), pattern, again);
    va_end(again);
    va_end(values);
    text.pop_back();
    return text;
}

std::string reasonOf(const std::exception& error)
{
    if (dynamic_cast<const std::bad_alloc*>(&error))
        return "out of memory";
    const auto* fromOpenCV = dynamic_cast<const cv::Exception*>(&error);
    std::string text = fromOpenCV ? fromOpenCV->err : error.what();
    std::replace(text.begin(), text.end(), '\n', ' ');
    text.erase(text.find_last_not_of(' ') + 1);
    return text;
}

std::string summary(const Found& found)
{
    return format("%s: %d x %d, %d edge pixels, %zu line%s in %.1f ms (%s)", found.input.c_str(),
                  found.size.width, found.size.height, found.edgePixels, found.lines.size(),
                  found.lines.size() == 1 ? "" : "s", found.milliseconds, found.backend.c_str());
}

std::string table(const Found& found, std::size_t maxRows)
{
    const std::size_t rows = std::min(maxRows, found.lines.size());
    if (rows == 0)
        return "";
    std::string text = "   #   votes  rho [px]  theta [deg]   from                to\n";
    for (std::size_t i = 0; i < rows; ++i)
    {
        const cv::Vec3f& line = found.lines[i];
        const cv::Vec4f& ends = found.endPoints[i];
        const std::string from = format("(%.1f, %.1f)", ends[0], ends[1]);
        const std::string to = format("(%.1f, %.1f)", ends[2], ends[3]);
        text += format("%4zu  %6.0f  %8.2f  %11.3f   %-18s  %s\n", i + 1, line[2], line[0],
                       line[1] * 180 / CV_PI, from.c_str(), to.c_str());
    }
    if (rows < found.lines.size())
        text += format("      and %zu more\n", found.lines.size() - rows);
    return text;
}

} // namespace program
