// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Runs line detectors, ours and others, on images whose lines are known, and writes what they find:
// the first half of perf/accuracy.sh.

#include "sections.hpp"

#include "support/machine.hpp"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <fstream>
#include <iostream>

namespace {

struct Section
{
    const char* name;
    bool photographs;
    void (*write)(const accuracy::Settings&);
};

const Section sections[] = {{"chessboard", true, accuracy::writeChessboards},
                            {"sudoku", true, accuracy::writeSudoku},
                            {"york", true, accuracy::writeYork},
                            {"steps", false, accuracy::writeSteps},
                            {"scenes", false, accuracy::writeScenes},
                            {"one-edge", false, accuracy::writeOneEdge},
                            {"negatives", false, accuracy::writeNegatives},
                            {"scales", true, accuracy::writeScales}};

} // namespace

int main(int argc, char** argv)
{
    accuracy::Settings settings{"", "", false};
    std::vector<std::string> only;
    CLI::App app("Runs line detectors on images whose lines are known and writes CSV files.");
    app.add_option("--data", settings.data,
                   "Folder with chessboard, sudoku and york; without it synthetic images only")
        ->envname("LINESPACE_EVAL_DATA")
        ->check(CLI::ExistingDirectory);
    app.add_option("--output", settings.output, "Folder to write to")->required();
    app.add_option("--only", only, "Names of sections to run; all without it");
    app.add_flag("--quick", settings.quick, "A few images of each section");
    CLI11_PARSE(app, argc, argv);
    try
    {
        std::filesystem::create_directories(settings.output);
        for (const Section& section : sections)
        {
            if (!only.empty() && std::find(only.begin(), only.end(), section.name) == only.end())
                continue;
            if (section.photographs && settings.data.empty())
            {
                std::cerr << "Left out without --data: " << section.name << "\n";
                continue;
            }
            std::cerr << section.name << "\n";
            section.write(settings);
        }
        std::ofstream origin(settings.output + "/origin.txt");
        origin << support::machine() << "\n" << support::commit() << "\n";
        if (!origin)
            throw std::runtime_error("cannot write origin.txt");
    }
    catch (const std::exception& error)
    {
        std::cerr << "linespace_accuracy: " << error.what() << "\n";
        return 1;
    }
    return 0;
}
