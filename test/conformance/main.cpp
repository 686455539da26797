// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// cv::linespace::HoughLines beside cv::HoughLines of the installed OpenCV: how many of its lines
// ours has (doc/algorithm.md, section 8). Prints every case and fails below the floors.

#include <algorithm>
#include <cstdlib>
#include <iostream>

#include <CLI/CLI.hpp>

#include "cases.hpp"
#include "comparison.hpp"
#include "opencv2/linespace.hpp"
#include "opencv_lines.hpp"
#include "report.hpp"
#include "support/machine.hpp"

namespace {

using namespace conformance;

//! What ctest takes for a skipped test.
const int exitSkipped = 77;

struct Options
{
    Folders folders;
    bool all = false, markdown = false;
    std::string image;
    // Somewhat below what doc/conformance.md reports.
    double leastMean = 0.995, leastWorst = 0.85;
    double leastRealMean = 0.9995, leastRealWorst = 0.995;
};

void parse(int argc, char** argv, Options& options)
{
    CLI::App app("Compares cv::linespace::HoughLines with cv::HoughLines", "linespace_conformance");
    app.add_option("--samples-data", options.folders.samples,
                   "Folder samples/data of OpenCV's sources")
        ->envname("LINESPACE_SAMPLES_DATA");
    std::string evaluation;
    app.add_option("--eval-data", evaluation, "Folder that has opencv_extra/stitching/a1.png")
        ->envname("LINESPACE_EVAL_DATA");
    app.add_flag("--all", options.all, "More images, angle ranges and thresholds; takes long");
    app.add_option("--image", options.image, "Only images whose name begins so");
    app.add_flag("--markdown", options.markdown, "Print doc/conformance.md instead of the cases");
    app.add_option("--least-mean", options.leastMean, "Fail below this mean share")
        ->capture_default_str();
    app.add_option("--least-worst", options.leastWorst, "Fail below this share in any case")
        ->capture_default_str();
    app.add_option("--least-real-mean", options.leastRealMean, "The same by real votes")
        ->capture_default_str();
    app.add_option("--least-real-worst", options.leastRealWorst, "The same by real votes")
        ->capture_default_str();
    try
    {
        app.parse(argc, argv);
    }
    catch (const CLI::ParseError& error)
    {
        const int status = app.exit(error);
        std::exit(status ? 2 : 0);
    }
    if (!evaluation.empty())
        options.folders.extra = evaluation + "/opencv_extra";
}

//! Whether what is missing is a failure, not a reason to skip.
bool isDataRequired()
{
    const char* const required = std::getenv("LINESPACE_REQUIRE_BACKENDS");
    return required && std::string(required) == "1";
}

Lines above(int threshold, const Lines& lines)
{
    Lines result;
    for (const cv::Vec3f& line : lines)
        if (line[2] > threshold)
            result.push_back(line);
    return result;
}

Share shareOf(const Lines& wanted, const Lines& lines, const Arguments& arguments)
{
    return {countFound(wanted, lines, arguments), static_cast<int>(wanted.size())};
}

double sumOfVotes(const Lines& lines)
{
    double sum = 0;
    for (const cv::Vec3f& line : lines)
        sum += line[2];
    return sum;
}

//! All thresholds of one search with one set of arguments.
void compare(const Search& search, const Arguments& arguments, std::vector<Result>& results,
             std::ostream* cases)
{
    // Which lines are local maxima does not depend on the threshold: one call serves all.
    Lines all = opencvLines(search.edges, arguments, leastThreshold(search, arguments));
    const std::vector<int> thresholds = thresholdsOf(search, all);
    if (thresholds.empty())
        return;
    all = above(*std::min_element(thresholds.begin(), thresholds.end()), all);
    const Lines real = withRealVotes(all, search.edges, arguments);
    if (sumOfVotes(real) < 0.95 * sumOfVotes(all))
        CV_Error(cv::Error::StsError,
                 "the rho of this cv::HoughLines has a bias that is not known");
    for (int threshold : thresholds)
    {
        const Lines wanted = above(threshold, all);
        if (wanted.empty())
            continue;
        Lines lines;
        cv::linespace::HoughLines(search.edges, lines, arguments.rho, arguments.theta, threshold, 0,
                                  0, arguments.minTheta, arguments.maxTheta, arguments.weighted);
        results.push_back({search.image, search.group, arguments, threshold,
                           shareOf(wanted, lines, arguments),
                           shareOf(above(threshold, real), lines, arguments),
                           static_cast<int>(lines.size()), countCrowded(lines, arguments),
                           countWrongVotes(lines, countVotes(lines, search.edges, arguments))});
        if (cases)
            printCase(results.back(), *cases);
    }
}

} // namespace

int main(int argc, char** argv)
try
{
    Options options;
    parse(argc, argv, options);
    const Grid grid = makeGrid(options.folders, options.all);
    std::ostream& notes = options.markdown ? std::cerr : std::cout;
    for (const std::string& line : grid.skipped)
        notes << "skipped: " << line << std::endl;

    std::vector<Result> results;
    for (const Search& search : grid.searches)
        if (search.image.compare(0, options.image.size(), options.image) == 0)
            for (const Arguments& arguments : search.arguments)
                compare(search, arguments, results, options.markdown ? nullptr : &std::cout);
    if (!grid.isComplete && isDataRequired())
    {
        notes << "FAILED: images are missing, and LINESPACE_REQUIRE_BACKENDS is set" << std::endl;
        return EXIT_FAILURE;
    }
    if (results.empty())
    {
        notes << "no image to compare on: give --samples-data or LINESPACE_SAMPLES_DATA"
              << std::endl;
        return exitSkipped;
    }

    const Summary summary = summaryOf(results);
    if (options.markdown)
        printMarkdown(results,
                      {"command: `" + support::commandLine(argc, argv) + "`, " + support::commit(),
                       "machine: " + support::machine()},
                      grid.skipped, std::cout);
    printSummary(summary, notes);
    const bool passes = summary.dishonest == 0 && summary.mean >= options.leastMean &&
                        summary.worst >= options.leastWorst &&
                        summary.realMean >= options.leastRealMean &&
                        summary.realWorst >= options.leastRealWorst;
    notes << (passes ? "PASSED" : "FAILED") << ": wanted are " << options.leastMean << " and "
          << options.leastWorst << ", by real votes " << options.leastRealMean << " and "
          << options.leastRealWorst << std::endl;
    return !passes ? EXIT_FAILURE : grid.isComplete ? EXIT_SUCCESS : exitSkipped;
}
catch (const std::exception& error)
{
    std::cerr << "linespace_conformance: " << error.what() << std::endl;
    return EXIT_FAILURE;
}
