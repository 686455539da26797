// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Writes doc/measurements.md: see perf/README.md.

#include "sections.hpp"

#include "support/machine.hpp"

#include <CLI/CLI.hpp>

#include <fstream>
#include <iostream>
#include <sstream>

int main(int argc, char** argv)
{
    measure::Settings settings{"", 1920, 9};
    std::string output;
    CLI::App app("Measures the Line Space beside cv::HoughLines and writes a markdown document.");
    app.add_option("--data", settings.data, "Folder of OpenCV's sample images (building.jpg, ...)")
        ->envname("LINESPACE_SAMPLES_DATA")
        ->required()
        ->check(CLI::ExistingDirectory);
    app.add_option("--largest", settings.largest, "Longest side of the images that are timed")
        ->check(CLI::Range(512, 1920))
        ->capture_default_str();
    app.add_option("--runs", settings.runs, "Runs of each timed call")
        ->check(CLI::Range(1, 99))
        ->capture_default_str();
    bool requirementsOnly = false;
    app.add_flag("--requirements", requirementsOnly,
                 "Only check what is required of the times; status 1 if it does not hold");
    app.add_option("--output", output, "File to write; standard output without it");
    CLI11_PARSE(app, argc, argv);
    try
    {
        std::ostringstream text;
        text << "# Measurements\n\n"
             << support::machine() << "; " << support::commit() << ".  \nCommand: `"
             << support::commandLine(argc, argv) << "`\n\n";
        if (!requirementsOnly)
            measure::writeMemory(text, settings); // first: the others would raise the peak
        const bool holds = measure::writeRequirements(text, settings);
        if (!requirementsOnly)
        {
            measure::writeSelection(text, settings);
            measure::writeTimes(text, settings);
            measure::writeVoteRatio(text, settings);
        }
        if (output.empty())
            std::cout << text.str();
        else if (!(std::ofstream(output) << text.str()))
            throw std::runtime_error("cannot write " + output);
        if (!holds)
            throw std::runtime_error("a requirement does not hold; see the table");
    }
    catch (const std::exception& error)
    {
        std::cerr << "linespace_measure: " << error.what() << "\n";
        return 1;
    }
    return 0;
}
