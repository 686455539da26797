// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Writes doc/cascade.md: see perf/README.md.

#include "candidate_rules.hpp"
#include "crossing_rules.hpp"
#include "inputs.hpp"
#include "losses.hpp"
#include "recall.hpp"
#include "texts.hpp"

#include "support/machine.hpp"

#include <CLI/CLI.hpp>

#include <fstream>
#include <iostream>
#include <sstream>

namespace {

struct Options
{
    std::string samples, evaluation, output, csv;
    int longest = 384;
    int every = 1;
    int scenes = 200;
    int detailsEvery = 8;
};

void write(const std::string& path, const std::string& text)
{
    if (!(std::ofstream(path) << text))
        throw std::runtime_error("cannot write " + path);
}

//! What is studied, image after image.
struct Study
{
    std::vector<cascade::Recall> recalls;
    std::vector<cascade::FrameRecall> frameRecalls;
    std::vector<cascade::Loss> losses;
    cascade::CandidateRules candidateRules;
    cascade::CrossingRules crossingRules;
    int details = 0;

    void addLines(const cascade::Source& source, int longest)
    {
        const cascade::Input input = cascade::readInput(source, longest);
        for (const cascade::Recall& recall : cascade::recallsOf(input))
            recalls.push_back(recall);
        for (const cascade::FrameRecall& recall : cascade::frameRecallsOf(input))
            frameRecalls.push_back(recall);
    }
    void addDetails(const cascade::Source& source, int longest)
    {
        const cascade::Input input = cascade::readInput(source, longest);
        for (const cascade::Loss& loss : cascade::lossesOf(input))
            losses.push_back(loss);
        const cascade::Input square = cascade::readSquare(source, cascade::SQUARE_SIZE);
        const cascade::SquareMap plain(square, false);
        candidateRules.add(plain, cascade::SquareMap(square, true));
        crossingRules.add(plain);
        ++details;
    }

    std::string text() const
    {
        std::ostringstream out;
        out << "What follows from these figures is in [decisions.md](decisions.md).\n"
            << cascade::LINES_TEXT;
        cascade::writeRecallTables(out, recalls);
        out << cascade::FRAMES_TEXT;
        cascade::writeFrameTable(out, frameRecalls);
        out << cascade::LOSSES_TEXT << details << " images.\n\n";
        cascade::writeLosses(out, losses);
        out << cascade::CANDIDATES_TEXT << details << " images.\n\n";
        candidateRules.write(out);
        out << cascade::CROSSINGS_TEXT;
        crossingRules.write(out);
        return out.str();
    }

    void writeCsv(const std::string& folder) const
    {
        std::ostringstream recall, loss, candidates, crossings;
        cascade::writeRecallCsv(recall, recalls);
        cascade::writeLossesCsv(loss, losses);
        candidateRules.writeCsv(candidates);
        crossingRules.writeCsv(crossings);
        write(folder + "/recall.csv", recall.str());
        write(folder + "/losses.csv", loss.str());
        write(folder + "/candidates.csv", candidates.str());
        write(folder + "/crossings.csv", crossings.str());
    }
};

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
    app.add_option("--scenes", options.scenes, "Number of synthetic scenes")
        ->check(CLI::Range(0, 10000))
        ->capture_default_str();
    app.add_option("--every", options.every, "Look at every so many-th image only")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--details-every", options.detailsEvery,
                   "Look into lost lines, candidates and crossings on every so many-th image only")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--output", options.output, "File to write; standard output without it");
    app.add_option("--csv", options.csv,
                   "Folder for recall.csv, losses.csv, candidates.csv and crossings.csv")
        ->check(CLI::ExistingDirectory);
    CLI11_PARSE(app, argc, argv);
    try
    {
        cascade::requireModulesVotes();
        auto sources = cascade::photographs(options.samples, options.evaluation);
        for (const cascade::Source& scene : cascade::syntheticScenes(options.scenes))
            sources.push_back(scene);
        Study study;
        for (std::size_t i = 0; i < sources.size(); i += options.every)
        {
            std::cerr << sources[i].group << "/" << sources[i].name << "\n";
            study.addLines(sources[i], options.longest);
            if (i % options.detailsEvery == 0)
                study.addDetails(sources[i], options.longest);
        }
        const std::string text = "# The cascade beside the exact method\n\n" + support::machine() +
                                 "; " + support::commit() + ".  \nCommand: `" +
                                 support::commandLine(argc, argv) + "`\n\n" + study.text();
        if (options.output.empty())
            std::cout << text;
        else
            write(options.output, text);
        if (!options.csv.empty())
            study.writeCsv(options.csv);
    }
    catch (const std::exception& error)
    {
        std::cerr << "linespace_cascade_study: " << error.what() << "\n";
        return 1;
    }
    return 0;
}
