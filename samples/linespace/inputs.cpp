// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "inputs.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <initializer_list>

#include <glob.h>

namespace fs = std::filesystem;

namespace program {

namespace {

bool hasExtension(const std::string& path, std::initializer_list<const char*> extensions)
{
    std::string extension = fs::path(path).extension().string();
    for (char& c : extension)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

std::vector<std::string> imagesInFolder(const std::string& folder)
{
    std::vector<std::string> paths;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (entry.is_regular_file() && isImageName(entry.path().string()))
            paths.push_back(entry.path().string());
    std::sort(paths.begin(), paths.end());
    return paths;
}

// The shell's own rules: cv::glob knows no wildcards in folders and no [a-z].
std::vector<std::string> filesOfPattern(const std::string& pattern)
{
    glob_t found = {};
    std::vector<std::string> paths;
    if (glob(pattern.c_str(), GLOB_TILDE, nullptr, &found) == 0)
        for (std::size_t i = 0; i < found.gl_pathc; ++i)
            if (fs::is_regular_file(found.gl_pathv[i]))
                paths.push_back(found.gl_pathv[i]);
    globfree(&found);
    return paths;
}

void append(std::vector<Input>& inputs, const std::vector<std::string>& paths,
            const std::string& argument, const char* whenEmpty)
{
    for (const std::string& path : paths)
        inputs.push_back({path, ""});
    if (paths.empty())
        inputs.push_back({argument, whenEmpty});
}

void expand(const std::string& argument, std::vector<Input>& inputs)
{
    if (fs::is_directory(argument))
        append(inputs, imagesInFolder(argument), argument, "no image in this folder");
    else if (fs::exists(argument))
        inputs.push_back({argument, ""});
    else if (argument.find_first_of("*?[") != std::string::npos)
        append(inputs, filesOfPattern(argument), argument, "no file matches this pattern");
    else
        inputs.push_back({argument, "no such file or folder"});
}

} // namespace

bool isImageName(const std::string& path)
{
    return hasExtension(path, {".bmp", ".dib", ".jpeg", ".jpg", ".jpe", ".jp2", ".png", ".webp",
                               ".pbm", ".pgm", ".ppm", ".pnm", ".tiff", ".tif", ".exr", ".hdr"});
}

bool isVideoName(const std::string& path)
{
    return hasExtension(path, {".avi", ".mkv", ".mov", ".mp4"});
}

std::vector<Input> expandInputs(const std::vector<std::string>& arguments)
{
    std::vector<Input> inputs;
    for (const std::string& argument : arguments)
    {
        try
        {
            expand(argument, inputs);
        }
        catch (const fs::filesystem_error& error)
        {
            inputs.push_back({argument, error.code().message()});
        }
    }
    return inputs;
}

} // namespace program
