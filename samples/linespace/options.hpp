// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// What the user asked for. Reading the command line also checks every value, so that the rest of
// the program can rely on it.

#ifndef LINESPACE_SAMPLES_OPTIONS_HPP
#define LINESPACE_SAMPLES_OPTIONS_HPP

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "opencv2/core.hpp"

namespace program {

//! Exit statuses, as promised by --help.
enum Status
{
    STATUS_OK = 0,
    STATUS_SOME_FAILED = 1,
    STATUS_USAGE = 2
};

//! A wrong argument that only shows once the inputs are known. Ends the program with STATUS_USAGE.
struct UsageError : std::runtime_error
{
    using std::runtime_error::runtime_error;
};

struct Options
{
    std::vector<std::string> inputs;

    std::string output;
    std::vector<std::string> lineFiles;
    std::string lineSpace;
    bool compare = false;
    double houghStep = 1; //!< degrees
    bool quiet = false;

    bool edgeMap = false;
    double cannyLow = 50, cannyHigh = 150;
    double blur = 1; //!< sigma in pixels, 0: none
    std::string mask;
    cv::Size resize; //!< empty: as it is

    int threshold = 0;
    int maxLines = 20;
    std::string method = "cascaded";
    std::string selection = "explain"; // people want one line per edge
    bool oriented = false;
    double minDistance = 3; //!< pixels
    int cellSize = 8;
    std::string backend = "auto";
    double minAngle = 0, maxAngle = 180; //!< degrees
};

//! Reads the command line; a value is the exit status of a program that has nothing more to do.
std::optional<int> parse(int argc, char** argv, Options& options);

int methodOf(const Options& options);    //!< one of cv::linespace::Method
int selectionOf(const Options& options); //!< one of cv::linespace::Selection
int backendOf(const Options& options);   //!< one of cv::linespace::Backend
const char* backendName(int backend);

} // namespace program

#endif // LINESPACE_SAMPLES_OPTIONS_HPP
