// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Times the Line Space beside other methods: the first half of perf/run.sh.

#include "caches.hpp"
#include "sections.hpp"

#include "support/machine.hpp"

#include "test_gl.hpp"

#include "opencv2/core/ocl.hpp"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <iostream>

namespace {

using namespace benchmark;

//! What the head of the report tells about this machine and this run.
void writeMachine(const Settings& settings, const std::vector<NewerOpenCv>& newer)
{
    std::string newerVersions;
    for (const NewerOpenCv& one : newer)
        newerVersions += (newerVersions.empty() ? "" : ", ") + one.version;
    nlohmann::ordered_json json;
    json["machine"] = support::machine();
    for (const Cache& cache : caches())
        json["caches"][cache.name] = {{"bytes", cache.bytes}, {"shared", cache.isShared}};
    json["compiler"] = LINESPACE_COMPILER;
    json["instruction_set"] = instructionSet();
    json["threads"] = settings.threads;
    json["opencv"] = cv::getVersionString();
    json["newer_opencv"] = newerVersions;
    json["opencl"] = isOpenClThere() ? cv::ocl::Device::getDefault().name() : "";
    json["opengl"] = opencv_test::headlessRenderer();
    json["commit"] = support::commit();
    json["turns"] = settings.turns;
    json["budget_milliseconds"] = settings.budget;
    json["quick"] = settings.quick;
    std::ofstream file(settings.output + "/machine.json");
    if (!(file << json.dump(2) << "\n"))
        throw std::runtime_error("cannot write machine.json");
}

void run(const Settings& settings, const std::vector<std::string>& only)
{
    const auto isWanted = [&](const std::string& section)
    {
        return only.empty() || std::find(only.begin(), only.end(), section) != only.end();
    };
    std::filesystem::create_directories(settings.output);
    // First, while there is no other thread: it forks.
    if (isWanted("memory"))
        measureMemory(settings);
    const std::vector<NewerOpenCv> newer = newerOpenCvs(settings);
    writeMachine(settings, newer);

    Recorder recorder(settings.output);
    const std::vector<std::pair<std::string, std::function<void()>>> sections = {
        {"photographs",
         [&]
         {
             timePhotographs(settings, recorder, newer);
         }},
        {"paper",
         [&]
         {
             timePaper(settings, recorder, newer);
         }},
        {"opencl",
         [&]
         {
             timeOpenCl(settings, recorder, newer);
         }},
        {"opengl",
         [&]
         {
             timeOpenGl(settings, recorder, newer);
         }},
        {"sizes",
         [&]
         {
             timeSizes(settings, recorder, newer);
         }},
        {"densities",
         [&]
         {
             timeDensities(settings, recorder, newer);
         }},
        {"threads",
         [&]
         {
             timeThreads(settings, recorder);
         }},
        {"instruction-sets",
         [&]
         {
             timeInstructionSets(settings, recorder);
         }},
        {"stages", [&]
         {
             timeStages(settings, recorder);
         }}};
    for (const auto& section : sections)
        if (isWanted(section.first))
        {
            std::cerr << section.first << "\n";
            section.second();
        }
    recorder.close();
    for (const auto& entry : std::filesystem::directory_iterator(settings.output))
        if (entry.path().filename().string().rfind("handed-over-", 0) == 0)
            std::filesystem::remove(entry.path());
    if (recorder.invalidCount() > 0)
        throw std::runtime_error(std::to_string(recorder.invalidCount()) +
                                 " calls did not find the reference's lines");
}

} // namespace

int main(int argc, char** argv)
{
    Settings settings{"", "",   {}, std::filesystem::read_symlink("/proc/self/exe"),
                      11, 2000, 0,  false};
    std::vector<std::string> only;
    bool isServer = false;
    CLI::App app("Times the Line Space beside other methods and writes CSV files.");
    auto* serveOption = app.add_flag("--serve", isServer, "Answer another of these processes");
    app.add_option("--data", settings.data, "Folder of OpenCV's sample images (building.jpg, ...)")
        ->envname("LINESPACE_SAMPLES_DATA")
        ->check(CLI::ExistingDirectory);
    app.add_option("--output", settings.output, "Folder to write to")->excludes(serveOption);
    app.add_option("--only", only, "Names of sections to run; all without it")
        ->check(CLI::IsMember({"photographs", "paper", "opencl", "opengl", "sizes", "densities",
                               "threads", "instruction-sets", "stages", "memory"}));
    app.add_option("--newer-python", settings.newerPythons,
                   "Pythons with newer versions of cv2, separated by colons")
        ->delimiter(':')
        ->envname("LINESPACE_NEWER_OPENCV_PYTHON");
    app.add_option("--turns", settings.turns, "Most calls of a method on one input")
        ->check(CLI::Range(1, 99))
        ->capture_default_str();
    app.add_option("--budget", settings.budget, "Milliseconds for them, see turns.hpp")
        ->capture_default_str();
    app.add_option("--threads", settings.threads, "Threads of what is timed; 0: one for each core")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    app.add_flag("--quick", settings.quick, "Small images, few turns: shows that it works");
    CLI11_PARSE(app, argc, argv);
    try
    {
        if (isServer)
        {
            serve();
            return 0;
        }
        if (settings.output.empty() || settings.data.empty())
            throw std::runtime_error("--data and --output are needed");
        if (settings.threads == 0)
            settings.threads = cv::getNumberOfCPUs();
        if (settings.quick)
        {
            settings.turns = 2;
            settings.budget = 100;
        }
        run(settings, only);
    }
    catch (const std::exception& error)
    {
        std::cerr << "linespace_benchmark: " << error.what() << "\n";
        return 1;
    }
    return 0;
}
