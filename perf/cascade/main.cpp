// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Writes doc/cascade.md: see perf/README.md.

#include "crossing_rules.hpp"
#include "inputs.hpp"
#include "losses.hpp"
#include "recall.hpp"

#include "support/edge_maps.hpp"
#include "support/machine.hpp"

#include <CLI/CLI.hpp>

#include "opencv2/imgproc.hpp"

#include <fstream>
#include <iostream>
#include <sstream>

namespace {

struct Options
{
    std::string samples, evaluation, output, csv;
    int longest = 384;
    int every = 1;
};

void write(const std::string& path, const std::string& text)
{
    if (!(std::ofstream(path) << text))
        throw std::runtime_error("cannot write " + path);
}

//! The same photograph as a square of the size that the rules of the crossing are studied at.
cascade::Input squareOf(const cascade::Source& source)
{
    const cv::Size size(cascade::RULE_SIZE, cascade::RULE_SIZE);
    const std::size_t slash = source.path.rfind('/');
    return {source,
            support::cannyEdges(support::scaled(
                support::readPhotograph(source.path.substr(0, slash), source.name), size)),
            {},
            {}};
}

std::string study(const Options& options, const std::string& heading)
{
    std::vector<cascade::Recall> recalls;
    std::vector<cascade::Loss> losses;
    std::vector<cascade::Input> squares;
    const auto sources = cascade::photographs(options.samples, options.evaluation);
    for (std::size_t i = 0; i < sources.size(); i += options.every)
    {
        std::cerr << sources[i].group << "/" << sources[i].name << "\n";
        const cascade::Input input = cascade::readInput(sources[i], options.longest);
        for (const cascade::Recall& recall : cascade::recallsOf(input))
            recalls.push_back(recall);
        for (const cascade::Loss& loss : cascade::lossesOf(input))
            losses.push_back(loss);
        squares.push_back(squareOf(sources[i]));
    }
    std::ostringstream text, recallCsv, lossCsv, ruleCsv;
    text << heading << "## Lines of the exact method\n\n";
    cascade::writeRecallTables(text, recalls);
    text << "## What is lost\n\n";
    cascade::writeLosses(text, losses);
    text << "## Rules of the crossing\n\n";
    cascade::writeCrossingRules(text, ruleCsv, squares);
    if (!options.csv.empty())
    {
        cascade::writeRecallCsv(recallCsv, recalls);
        cascade::writeLossesCsv(lossCsv, losses);
        write(options.csv + "/recall.csv", recallCsv.str());
        write(options.csv + "/losses.csv", lossCsv.str());
        write(options.csv + "/rules.csv", ruleCsv.str());
    }
    return text.str();
}

} // namespace

int main(int argc, char** argv)
{
    Options options;
    CLI::App app("Compares the lines and votes of the cascade with the exact method's and writes a "
                 "markdown document.");
    app.add_option("--data", options.samples,
                   "Folder of OpenCV's sample images (building.jpg, ...)")
        ->envname("LINESPACE_SAMPLES_DATA")
        ->required()
        ->check(CLI::ExistingDirectory);
    app.add_option("--evaluation", options.evaluation,
                   "Folder with the photographs chessboard/, sudoku/ and york/")
        ->envname("LINESPACE_EVAL_DATA")
        ->check(CLI::ExistingDirectory);
    app.add_option("--longest", options.longest,
                   "Longer side that larger photographs are reduced to")
        ->check(CLI::Range(64, 1024))
        ->capture_default_str();
    app.add_option("--every", options.every, "Look at every so many-th image only")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--output", options.output, "File to write; standard output without it");
    app.add_option("--csv", options.csv, "Folder for recall.csv, losses.csv and rules.csv")
        ->check(CLI::ExistingDirectory);
    CLI11_PARSE(app, argc, argv);
    try
    {
        cascade::requireShippedRule();
        const std::string text =
            study(options, "# The cascade beside the exact method\n\n" + support::machine() + "; " +
                               support::commit() + ".  \nCommand: `" +
                               support::commandLine(argc, argv) + "`\n\n");
        if (options.output.empty())
            std::cout << text;
        else
            write(options.output, text);
    }
    catch (const std::exception& error)
    {
        std::cerr << "linespace_cascade_study: " << error.what() << "\n";
        return 1;
    }
    return 0;
}
