// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "naming.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include "frames.hpp"
#include "text.hpp"

namespace fs = std::filesystem;

namespace program {

namespace {

bool isFolder(const std::string& path)
{
    const fs::path name(path);
    return fs::is_directory(name) || !name.has_filename() || !name.has_extension();
}

bool hasStar(const std::string& path)
{
    return fs::path(path).filename().string().find('*') != std::string::npos;
}

std::string replaceStar(const std::string& path, const std::string& name)
{
    std::string file = fs::path(path).filename().string();
    file.replace(file.find('*'), 1, name);
    return (fs::path(path).parent_path() / file).string();
}

//! "a/house.jpg" is "house", and a second one is "house-2".
std::string uniqueName(const std::string& input, std::set<std::string>& taken)
{
    const std::string stem = fs::path(input).stem().string();
    std::string name = stem;
    for (int i = 2; !taken.insert(name).second; ++i)
        name = stem + "-" + std::to_string(i);
    return name;
}

std::string nameFor(const std::string& option, const std::string& input, const char* inFolder)
{
    if (option.empty())
        return "";
    if (isFolder(option))
        return (fs::path(option) / (input + inFolder)).string();
    return hasStar(option) ? replaceStar(option, input) : option;
}

void requireFormat(const char* option, const std::string& path, bool known, const char* allowed)
{
    if (!path.empty() && !known)
        throw UsageError(
            format("%s: '%s' is not allowed; it must be %s", option, path.c_str(), allowed));
}

void requireKnownFormats(const Options& o)
{
    requireFormat("--output", o.output,
                  isFolder(o.output) || isImageName(o.output) || isVideoName(o.output),
                  "a folder, an image (.png, .jpg, .bmp, .tif, .webp, ...) or a video (.mp4, .avi, "
                  ".mkv, .mov)");
    requireFormat("--show-linespace", o.lineSpace,
                  isFolder(o.lineSpace) || isImageName(o.lineSpace),
                  "a folder or an image (.png, .jpg, .bmp, .tif, .webp, ...)");
    for (const std::string& path : o.lineFiles)
        requireFormat("--lines", path, !lineFormat(path).empty(), "a .json, .csv or .svg file");
}

//! The files that are written, each with the option that asked for it.
class Claims
{
public:
    explicit Claims(const Options& options, const std::vector<Input>& inputs)
    {
        for (const Input& input : inputs)
            if (input.error.empty())
                read_.insert(canonical(input.path));
        if (!options.mask.empty())
            read_.insert(canonical(options.mask));
    }

    void add(const char* option, const std::string& path)
    {
        if (path.empty())
            return;
        const std::string file = canonical(path);
        if (read_.count(file) != 0)
            throw UsageError(format("%s: %s would overwrite an input", option, path.c_str()));
        if (!written_.insert(file).second)
            throw UsageError(format("%s: %s would be written twice; give a folder, or a name with "
                                    "a * that stands for the input's name",
                                    option, path.c_str()));
        makeFolder(option, path);
    }

private:
    static std::string canonical(const std::string& path)
    {
        return fs::weakly_canonical(fs::absolute(path)).string();
    }

    static void makeFolder(const char* option, const std::string& path)
    {
        std::error_code error;
        const fs::path folder = fs::absolute(path).parent_path();
        fs::create_directories(folder, error);
        if (!fs::is_directory(folder))
            throw UsageError(format("%s: the folder %s cannot be made: %s", option, folder.c_str(),
                                    error.message().c_str()));
    }

    std::set<std::string> read_, written_;
};

} // namespace

std::string lineFormat(const std::string& path)
{
    const std::string extension = fs::path(path).extension().string();
    for (const char* known : {".json", ".csv", ".svg"})
        if (extension == known)
            return extension;
    return "";
}

bool isSharedLineFile(const std::string& option)
{
    return lineFormat(option) != ".svg" && !hasStar(option);
}

std::string numbered(const std::string& path, int frame)
{
    if (frame < 0)
        return path;
    const fs::path name(path);
    const std::string file =
        name.stem().string() + format("-%06d", frame) + name.extension().string();
    return (name.parent_path() / file).string();
}

std::vector<OutputNames> planOutputs(const Options& o, const std::vector<Input>& inputs)
{
    requireKnownFormats(o);
    Claims claims(o, inputs);
    for (const std::string& path : o.lineFiles)
        if (isSharedLineFile(path))
            claims.add("--lines", path);

    std::vector<OutputNames> plan;
    std::set<std::string> taken;
    for (const Input& input : inputs)
    {
        OutputNames names;
        if (input.error.empty())
        {
            const std::string name = uniqueName(input.path, taken);
            const bool image = isImageFile(input.path);
            names.annotated = nameFor(o.output, name, image ? ".lines.png" : ".lines.mp4");
            if (image && isVideoName(names.annotated))
                throw UsageError("--output: the video " + names.annotated +
                                 " cannot be made of the image " + input.path);
            claims.add("--output", names.annotated);
            names.lineSpace = nameFor(o.lineSpace, name, ".linespace.png");
            claims.add("--show-linespace", names.lineSpace);
            for (const std::string& option : o.lineFiles)
            {
                names.lineFiles.push_back(nameFor(option, name, ""));
                if (!isSharedLineFile(option))
                    claims.add("--lines", names.lineFiles.back());
            }
        }
        plan.push_back(names);
    }
    return plan;
}

} // namespace program
