// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "options.hpp"

#include <cstdlib>
#include <iostream>
#include <limits>
#include <sstream>

#include <CLI/CLI.hpp>

#include "opencv2/core/utility.hpp"
#include "opencv2/linespace.hpp"

namespace program {

namespace {

const char* const backendNames[] = {"auto", "reference", "cpu", "opencl", "opengl"};
const char* const methodNames[] = {"exact", "cascaded", "strips"};
const char* const selectionNames[] = {"peaks", "explain"};

const char* const examples =
    R"(Names of files to write: a plain name serves one input. For several inputs give a folder, or a
name with a * that stands for the input's name; frames of a video are numbered. One JSON or CSV
file takes the lines of all inputs.

Examples:
  linespace house.jpg                            the lines as a table
  linespace house.jpg -o lines.png               drawn over the photograph
  linespace photos -o found --lines found.json   all images of a folder
  linespace 'photos/*.png' --lines 'found/*.svg' one SVG for each image
  linespace road.mp4 -o lanes.mp4 --angle-range -60 60
  linespace edges.png --edge-map --threshold 80  the input is an edge map already
  linespace house.jpg --compare -o both.png --max-lines 8 --resize 512 512
  linespace house.jpg --show-linespace votes.png

Exit status: 0, 1 if some inputs failed (the others are done), 2 for a wrong argument.
)";

// CLI::Range lets NaN pass, and its message does not say what was given.
CLI::Validator between(double low, double high, bool whole)
{
    std::ostringstream range;
    range.precision(10);
    range << (whole ? "a whole number" : "a number") << " from " << low << " to " << high;
    const std::string allowed = range.str();
    return CLI::Validator(
        [=](const std::string& text)
        {
            char* end = nullptr;
            const double value = whole ? static_cast<double>(std::strtoll(text.c_str(), &end, 10))
                                       : std::strtod(text.c_str(), &end);
            const bool complete = !text.empty() && *end == '\0';
            if (complete && value >= low && value <= high)
                return std::string();
            return "'" + text + "' is not allowed; it must be " + allowed;
        },
        "");
}

CLI::Validator wholeNumber(int low, int high = std::numeric_limits<int>::max())
{
    return between(low, high, true);
}

CLI::Validator number(double low, double high)
{
    return between(low, high, false);
}

void requireOrder(const char* name, const std::vector<double>& pair)
{
    if (pair[0] <= pair[1])
        return;
    std::ostringstream message;
    message << name << ": " << pair[0] << " " << pair[1]
            << " is not allowed; the first must not be larger than the second";
    throw CLI::ValidationError(message.str(), CLI::ExitCodes::ValidationError);
}

// cv::HoughLines takes no other interval.
void requireComparable(const std::vector<double>& angles)
{
    if (angles[0] < 0 || angles[1] > 180)
        throw CLI::ValidationError("--angle-range: with --compare it must be from 0 to 180",
                                   CLI::ExitCodes::ValidationError);
}

template<typename Number>
std::string brief(Number value)
{
    std::ostringstream text;
    text << value;
    return text.str();
}

template<std::size_t N>
std::vector<std::string> listOf(const char* const (&names)[N])
{
    return {names, names + N};
}

template<std::size_t N>
int indexOf(const char* const (&names)[N], const std::string& name)
{
    for (std::size_t i = 0; i < N; ++i)
        if (name == names[i])
            return static_cast<int>(i);
    CV_Error(cv::Error::StsInternal, "the parser lets no other name pass: " + name);
}

// CLI11 wraps some messages over lines; an error of this program is one line.
std::string oneLine(std::string text)
{
    for (char& c : text)
        if (c == '\n')
            c = ' ';
    return text;
}

} // namespace

std::optional<int> parse(int argc, char** argv, Options& o)
{
    CLI::App app("Finds the straight lines of images and videos by the Line Space.", "linespace");
    app.footer(examples);
    app.set_version_flag("--version",
                         "linespace " LINESPACE_VERSION " (OpenCV " + cv::getVersionString() + ")",
                         "Print the versions and exit");
    app.get_formatter()->column_width(30);

    app.add_option("INPUT", o.inputs, "Images, folders, quoted patterns, videos")
        ->option_text("...")
        ->required();

    // The text that stands behind the name in --help: what it takes, and the default.
    const auto describe = [](CLI::Option* added, const char* group, const std::string& takes,
                             const std::string& usual = "")
    {
        return added->group(group)->option_text(usual.empty() ? takes : takes + " (" + usual + ")");
    };

    const char* group = "What to write";
    describe(app.add_option("-o,--output", o.output,
                            "The input with its lines: an image, a video of a video, or a folder"),
             group, "FILE");
    describe(app.add_option("--lines", o.lineFiles,
                            "The lines as .json, .csv or .svg; may be given several times"),
             group, "FILE")
        ->expected(1) // so that "--lines a.csv b.jpg" leaves b.jpg an input
        ->take_all();
    describe(app.add_option("--show-linespace", o.lineSpace,
                            "The table of votes as an image: row and column are the\n"
                            "two points where a line crosses the border"),
             group, "FILE");
    app.add_flag("--compare", o.compare,
                 "Show the strongest lines of cv::HoughLines beside ours, and both times")
        ->group(group);
    describe(
        app.add_option("--hough-step", o.houghStep, "Angle step of cv::HoughLines for --compare"),
        group, "DEGREES", brief(o.houghStep))
        ->check(number(0.01, 90));
    app.add_flag("-q,--quiet", o.quiet, "Print errors only")->group(group);

    group = "Edges";
    std::vector<double> canny = {o.cannyLow, o.cannyHigh};
    CLI::Option* const cannyOption =
        describe(app.add_option("--canny", canny, "Thresholds of the Canny edge detector"), group,
                 "LOW HIGH", brief(o.cannyLow) + " " + brief(o.cannyHigh))
            ->expected(2)
            ->check(number(0, 10000));
    CLI::Option* const blurOption =
        describe(app.add_option("--blur", o.blur, "Gaussian blur before Canny, in pixels; 0: none"),
                 group, "SIGMA", brief(o.blur))
            ->check(number(0, 100));
    std::vector<int> resize;
    CLI::Option* const resizeOption =
        describe(app.add_option("--resize", resize, "Scale the input first"), group, "WIDTH HEIGHT")
            ->expected(2)
            ->check(wholeNumber(1, 32767));
    app.add_flag("--edge-map", o.edgeMap,
                 "The input is an edge map: every pixel that is not black votes")
        ->group(group)
        ->excludes(cannyOption, blurOption, resizeOption)
        ->option_text(" ");
    describe(app.add_option("--mask", o.mask,
                            "An image of the input's size; where it is black, nothing votes"),
             group, "FILE")
        ->check(CLI::ExistingFile);

    group = "Lines";
    describe(app.add_option("--threshold", o.threshold,
                            "Edge pixels that a line must exceed; 0: taken from the\n"
                            "image, so that noise gives no lines"),
             group, "VOTES", brief(o.threshold))
        ->check(wholeNumber(0));
    describe(app.add_option("--max-lines", o.maxLines, "Report the N strongest; 0: all"), group,
             "N", brief(o.maxLines))
        ->check(wholeNumber(0));
    std::vector<double> angles = {o.minAngle, o.maxAngle};
    describe(app.add_option("--angle-range", angles,
                            "Report lines whose normal has an angle in this interval,\n"
                            "in degrees: 0 is a vertical line, 90 a horizontal one"),
             group, "MIN MAX", brief(o.minAngle) + " " + brief(o.maxAngle))
        ->expected(2)
        ->check(number(-36000, 36000));
    describe(app.add_option("--selection", o.selection,
                            "explain: an edge pixel counts for one line only, the strongest;\n"
                            "peaks: for every line through it"),
             group, "NAME", o.selection)
        ->check(CLI::IsMember(listOf(selectionNames)));
    app.add_flag("--oriented", o.oriented,
                 "An edge pixel counts for lines of its own direction only, which\n"
                 "is that of the image, or with --edge-map of the edges around it")
        ->group(group);
    describe(app.add_option("--min-distance", o.minDistance,
                            "Drop a line that stays within this distance of a stronger one"),
             group, "PIXELS", brief(o.minDistance))
        ->check(number(0, 10000));
    describe(app.add_option("--method", o.method,
                            "How votes are counted: exact (slow), cascaded, strips"),
             group, "NAME", o.method)
        ->check(CLI::IsMember(listOf(methodNames)));
    describe(app.add_option("--cell-size", o.cellSize,
                            "Side of the smallest cells of the cascade, 2 to 64 pixels"),
             group, "PIXELS", brief(o.cellSize))
        ->check(wholeNumber(2, 64));
    describe(app.add_option("--backend", o.backend,
                            "What counts them: auto, reference (slow), cpu, opencl, opengl"),
             group, "NAME", o.backend)
        ->check(CLI::IsMember(listOf(backendNames)));

    try
    {
        app.parse(argc, argv);
        requireOrder("--canny", canny);
        requireOrder("--angle-range", angles);
        if (o.compare)
            requireComparable(angles);
    }
    catch (const CLI::Success& request) // --help and --version
    {
        return app.exit(request);
    }
    catch (const CLI::ParseError& error)
    {
        std::cerr << "linespace: " << oneLine(error.what()) << " (see linespace --help)\n";
        return STATUS_USAGE;
    }
    o.cannyLow = canny[0];
    o.cannyHigh = canny[1];
    o.minAngle = angles[0];
    o.maxAngle = angles[1];
    if (!resize.empty())
        o.resize = cv::Size(resize[0], resize[1]);
    return std::nullopt;
}

int methodOf(const Options& o)
{
    return indexOf(methodNames, o.method);
}

int selectionOf(const Options& o)
{
    return indexOf(selectionNames, o.selection);
}

int backendOf(const Options& o)
{
    return indexOf(backendNames, o.backend);
}

const char* backendName(int backend)
{
    return backendNames[backend];
}

} // namespace program
