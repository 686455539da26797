// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "helpers.hpp"

#include "opencv2/imgcodecs.hpp"

#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>

namespace benchmark {

namespace {

/** The edge map is written to a file that other processes can read. They keep it by its name, so
that maps of different density have different ones. */
std::string written(const Settings& settings, const Input& input)
{
    const std::string path = settings.output + "/handed-over-" + std::to_string(input.edges.cols) +
                             "x" + std::to_string(input.edges.rows) + "-" +
                             std::to_string(cv::countNonZero(input.edges)) + "-" + input.name +
                             ".png";
    if (!cv::imwrite(path, input.edges))
        throw std::runtime_error("cannot write " + path);
    return path;
}

Outcome outcomeOf(const std::string& answer)
{
    Outcome outcome{0, 0, true, {}};
    std::istringstream fields(answer);
    if (!(fields >> outcome.milliseconds >> outcome.lines >> outcome.valid))
        throw std::runtime_error("a helper answers: " + answer);
    fields.ignore(1, '\t');
    std::string name, milliseconds;
    while (std::getline(fields, name, '\t') && std::getline(fields, milliseconds, '\t'))
        outcome.stages.push_back({name, std::stod(milliseconds)});
    return outcome;
}

std::string textOf(const Outcome& outcome)
{
    std::ostringstream text;
    text << outcome.milliseconds << "\t" << outcome.lines << "\t" << outcome.valid;
    for (const Stage& stage : outcome.stages)
        text << "\t" << stage.name << "\t" << stage.milliseconds;
    return text.str();
}

//! The patch level is left out: "4.14" of "4.14.0".
std::string majorMinor(const std::string& version)
{
    return version.substr(0, version.find('.', version.find('.') + 1));
}

} // namespace

std::vector<NewerOpenCv> newerOpenCvs(const Settings& settings)
{
    if (settings.newerPythons.empty())
        std::cerr << "Left out: newer versions of OpenCV (no --newer-python)\n";
    std::vector<NewerOpenCv> found;
    for (const std::string& path : settings.newerPythons)
        try
        {
            const auto python = std::make_shared<ChildProcess>(
                std::vector<std::string>{path, LINESPACE_BENCHMARK_DIR "/newer_opencv.py"},
                std::vector<std::string>{});
            const std::string version = python->ask("version");
            for (const NewerOpenCv& other : found)
                if (majorMinor(other.version) == majorMinor(version))
                    throw std::runtime_error(path + " has " + version + ", another one " +
                                             other.version);
            found.push_back({version, python});
        }
        catch (const std::exception& error)
        {
            std::cerr << "Left out: a newer OpenCV (" << error.what() << ")\n";
        }
    return found;
}

std::vector<Call> everyHoughLines(const Settings& settings, const std::vector<NewerOpenCv>& newer,
                                  const Input& input, const std::string& step, int threshold)
{
    std::vector<Call> calls = {houghLines(input, step, threshold)};
    if (newer.empty())
        return calls;
    std::ostringstream question;
    question.precision(17);
    question << "HoughLines\t" << written(settings, input) << "\t"
             << angleStep(step, input.edges.size()) << "\t" << threshold << "\t"
             << settings.threads;
    const std::string text = question.str();
    for (const NewerOpenCv& one : newer)
    {
        const auto python = one.python;
        calls.push_back({"HoughLines " + majorMinor(one.version) + " " + step, [=]
                         {
                             return outcomeOf(python->ask(text));
                         }});
    }
    return calls;
}

std::shared_ptr<ChildProcess> onInstructionSet(const Settings& settings, const InstructionSet& set)
{
    const auto helper = std::make_shared<ChildProcess>(
        std::vector<std::string>{settings.program, "--serve"},
        std::vector<std::string>{"OPENCV_CPU_DISABLE=" + set.disable});
    const std::string really = helper->ask("isa");
    if (really != set.name)
        throw std::runtime_error("OPENCV_CPU_DISABLE=" + set.disable + " runs " + really +
                                 ", not " + set.name);
    return helper;
}

Call helperDetection(const std::shared_ptr<ChildProcess>& helper, const Settings& settings,
                     const InstructionSet& set, const Input& input, Kind kind)
{
    const std::string question =
        "detect\t" + written(settings, input) + "\t" + std::to_string(input.threshold) + "\t" +
        std::to_string((int)kind) + "\t" + std::to_string(settings.threads);
    return {kind == Kind::UNPRUNED ? "Line Space unpruned" : "Line Space",
            [=] { return outcomeOf(helper->ask(question)); }, 0, set.name};
}

void serve()
{
    std::map<std::string, std::vector<Call>> calls; // by file and threshold
    for (std::string question; std::getline(std::cin, question);)
    {
        std::istringstream fields(question);
        std::string what, file;
        std::getline(fields, what, '\t');
        if (what == "isa")
        {
            std::cout << instructionSet() << std::endl;
            continue;
        }
        int threshold = 0, kind = 0, threads = 1;
        std::getline(fields, file, '\t');
        fields >> threshold >> kind >> threads;
        cv::setNumThreads(threads);
        std::vector<Call>& both = calls[file + "\t" + std::to_string(threshold)];
        if (both.empty())
        {
            const cv::Mat1b edges = cv::imread(file, cv::IMREAD_GRAYSCALE);
            both =
                detections({file, cv::Mat1b(), edges, threshold}, {Kind::DETECT, Kind::UNPRUNED});
        }
        std::cout << textOf(both.at(kind).run()) << std::endl;
    }
}

} // namespace benchmark
