// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "machine.hpp"

#include <cstdio>
#include <fstream>
#include <thread>

#include "opencv2/core/utility.hpp"

namespace support {

namespace {

//! The value of the first line "key<separator>value" of a file; empty if there is none.
std::string valueFrom(const char* file, const std::string& key, char separator)
{
    std::ifstream lines(file);
    for (std::string line; std::getline(lines, line);)
        if (line.compare(0, key.size(), key) == 0)
        {
            std::string value = line.substr(line.find(separator) + 1);
            value.erase(0, value.find_first_not_of(" \t\""));
            value.erase(value.find_last_not_of(" \t\"") + 1);
            return value;
        }
    return "";
}

std::string firstLineOf(const std::string& command)
{
    std::FILE* const pipe = popen(command.c_str(), "r");
    if (!pipe)
        return "";
    char line[256] = "";
    if (!std::fgets(line, sizeof(line), pipe))
        line[0] = '\0';
    pclose(pipe);
    const std::string text = line;
    return text.substr(0, text.find('\n'));
}

} // namespace

std::string machine()
{
    const std::string processor = valueFrom("/proc/cpuinfo", "model name", ':');
    const std::string system = valueFrom("/etc/os-release", "PRETTY_NAME", '=');
    const unsigned cores = std::thread::hardware_concurrency();
    return std::to_string(cores) + (cores == 1 ? " core" : " cores") +
           (processor.empty() ? "" : ", " + processor) + (system.empty() ? "" : ", " + system) +
           ", OpenCV " + cv::getVersionString();
}

std::string commit()
{
    const std::string git = "git -C '" LINESPACE_SOURCE_DIR "' ";
    const std::string hash = firstLineOf(git + "rev-parse --short HEAD 2>/dev/null");
    if (hash.empty())
        return "unknown commit";
    // Tables are written into doc/ and perf/results/, so that changes there say nothing about the
    // program.
    const std::string changed =
        firstLineOf(git + "status --porcelain -- modules perf test ':!perf/results' 2>/dev/null");
    return "commit " + hash + (changed.empty() ? "" : " with changes");
}

std::string commandLine(int argc, const char* const* argv)
{
    const std::string program = argv[0];
    std::string line = program.substr(program.rfind('/') + 1);
    for (int i = 1; i < argc; ++i)
        line += std::string(" ") + argv[i];
    return line;
}

} // namespace support
