// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "run.hpp"

#include <iostream>
#include <memory>

#include "compare.hpp"
#include "draw.hpp"
#include "finder.hpp"
#include "frames.hpp"
#include "inputs.hpp"
#include "line_files.hpp"
#include "naming.hpp"
#include "picture_file.hpp"
#include "progress.hpp"
#include "text.hpp"

namespace program {

namespace {

const std::size_t maxTableRows = 40;

class Run
{
public:
    Run(const Options& options, const std::vector<Input>& inputs,
        const std::vector<OutputNames>& names);
    int all();

private:
    void one(const Input& input, const OutputNames& names);
    void readInput(const Input& input, const OutputNames& names);
    Found searchFrame(const Picture& picture, const Input& input, const FrameReader& reader,
                      int frame);
    void writeFrame(const Picture& picture, const Found& found, const OutputNames& names,
                    PictureFile& annotated);
    void tell(const Found& found);
    void tellVideo(const std::string& input, int frames, std::size_t lines, double milliseconds);
    void fail(const std::string& what, const std::string& reason);
    void writeLineFile(const LineFile& file, const std::string& name);

    bool alone() const { return inputs_.size() == 1; }

    const Options& options_;
    const std::vector<Input>& inputs_;
    const std::vector<OutputNames>& names_;
    LineFinder finder_;
    std::vector<std::unique_ptr<LineFile>> shared_;  // one for each --lines; null: one per input
    std::vector<std::unique_ptr<LineFile>> ofInput_; // as shared_, for the input at work
    std::unique_ptr<Progress> progress_;
    bool failed_ = false;
};

Run::Run(const Options& options, const std::vector<Input>& inputs,
         const std::vector<OutputNames>& names)
    : options_(options), inputs_(inputs), names_(names), finder_(options)
{
    for (const std::string& path : options.lineFiles)
        shared_.push_back(isSharedLineFile(path) ? std::make_unique<LineFile>(options, path)
                                                 : nullptr);
}

int Run::all()
{
    if (!alone())
        progress_ = std::make_unique<Progress>(static_cast<int>(inputs_.size()), !options_.quiet);
    for (std::size_t i = 0; i < inputs_.size(); ++i)
    {
        if (!alone())
            progress_->update(static_cast<int>(i), inputs_[i].path);
        one(inputs_[i], names_[i]);
    }
    for (std::size_t i = 0; i < shared_.size(); ++i)
        if (shared_[i])
            writeLineFile(*shared_[i], options_.lineFiles[i]);
    progress_.reset();
    std::cout.flush();
    if (!std::cout)
        fail("standard output", "cannot be written");
    return failed_ ? STATUS_SOME_FAILED : STATUS_OK;
}

void Run::one(const Input& input, const OutputNames& names)
{
    ofInput_.clear();
    for (std::size_t i = 0; i < shared_.size(); ++i)
    {
        const bool own =
            !shared_[i] && !names.lineFiles.empty() && lineFormat(options_.lineFiles[i]) != ".svg";
        ofInput_.push_back(own ? std::make_unique<LineFile>(options_, names.lineFiles[i])
                               : nullptr);
    }
    try
    {
        if (!input.error.empty())
            throw InputError(input.error);
        readInput(input, names);
    }
    catch (const std::exception& error)
    {
        fail(input.path, reasonOf(error));
        for (const auto* files : {&shared_, &ofInput_})
            for (const auto& file : *files)
                if (file)
                    file->addError(input.path, reasonOf(error));
    }
    for (std::size_t i = 0; i < ofInput_.size(); ++i)
        if (ofInput_[i])
            writeLineFile(*ofInput_[i], names.lineFiles[i]);
}

void Run::readInput(const Input& input, const OutputNames& names)
{
    FrameReader reader(input.path);
    if (alone()) // the bar then counts frames
        progress_ =
            std::make_unique<Progress>(reader.frameCount(), reader.isVideo() && !options_.quiet);
    PictureFile annotated(names.annotated, reader.framesPerSecond());
    int frames = 0;
    std::size_t lines = 0;
    double milliseconds = 0;
    const auto tellSoFar = [&]
    {
        if (reader.isVideo())
            tellVideo(input.path, frames, lines, milliseconds);
    };
    try
    {
        for (cv::Mat frame; reader.next(frame);)
        {
            const Picture picture = finder_.prepare(frame);
            const Found found = searchFrame(picture, input, reader, frames);
            writeFrame(picture, found, names, annotated);
            if (!reader.isVideo())
                tell(found);
            ++frames;
            lines += found.lines.size();
            milliseconds += found.milliseconds;
            if (alone())
                progress_->update(frames, input.path);
        }
    }
    catch (const std::exception&)
    {
        if (frames > 0) // a truncated video: what was read of it is done
            tellSoFar();
        throw;
    }
    tellSoFar();
}

Found Run::searchFrame(const Picture& picture, const Input& input, const FrameReader& reader,
                       int frame)
{
    Found found = finder_.find(picture);
    found.input = input.path;
    if (reader.isVideo())
    {
        found.frame = frame;
        found.seconds = reader.framesPerSecond() > 0 ? frame / reader.framesPerSecond() : 0;
    }
    return found;
}

void Run::writeFrame(const Picture& picture, const Found& found, const OutputNames& names,
                     PictureFile& annotated)
{
    if (options_.compare)
    {
        const Comparison both = compare(options_, picture, found, finder_);
        annotated.write(both.picture, found.frame);
        if (!options_.quiet)
            progress_->print(found.input + ": " + both.text);
    }
    else if (!names.annotated.empty())
        annotated.write(drawOver(picture.colors, found.lines, ourColor), found.frame);

    for (std::size_t i = 0; i < shared_.size(); ++i)
    {
        if (lineFormat(names.lineFiles[i]) == ".svg")
            writeSvg(numbered(names.lineFiles[i], found.frame), picture, found);
        else
            (shared_[i] ? shared_[i] : ofInput_[i])->add(found);
    }
    // Last, because a large image may have no room for its table while its lines are fine.
    if (!names.lineSpace.empty())
        PictureFile(names.lineSpace)
            .write(lineSpacePicture(finder_.lineSpace(picture)), found.frame);
}

void Run::tell(const Found& found)
{
    if (options_.quiet || progress_->isShown())
        return;
    progress_->print(summary(found));
    if (alone() && !found.lines.empty())
        progress_->print("\n" + table(found, maxTableRows));
}

void Run::tellVideo(const std::string& input, int frames, std::size_t lines, double milliseconds)
{
    if (options_.quiet || (!alone() && progress_->isShown()))
        return;
    progress_->print(format("%s: %d frames, %zu lines, %.1f ms a frame", input.c_str(), frames,
                            lines, frames > 0 ? milliseconds / frames : 0.0));
}

void Run::fail(const std::string& what, const std::string& reason)
{
    failed_ = true;
    const std::string text = "linespace: " + what + ": " + reason;
    if (progress_)
        progress_->printError(text);
    else
        std::cerr << text << std::endl;
}

void Run::writeLineFile(const LineFile& file, const std::string& name)
{
    try
    {
        file.write();
    }
    catch (const std::exception& error)
    {
        fail(name, reasonOf(error));
    }
}

} // namespace

int run(const Options& options)
{
    const std::vector<Input> inputs = expandInputs(options.inputs);
    const std::vector<OutputNames> names = planOutputs(options, inputs);
    return Run(options, inputs, names).all();
}

} // namespace program
