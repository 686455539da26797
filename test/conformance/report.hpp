// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The results: a line for each case as it comes, a summary, and the tables of doc/conformance.md.

#ifndef LINESPACE_CONFORMANCE_REPORT_HPP
#define LINESPACE_CONFORMANCE_REPORT_HPP

#include <iosfwd>
#include <string>
#include <vector>

#include "lines.hpp"

namespace conformance {

//! How many of a number of lines have a counterpart.
struct Share
{
    int found, of;
    double value() const { return of ? static_cast<double>(found) / of : 1; }
};

struct Result
{
    std::string image, group;
    Arguments arguments;
    int threshold;
    Share claimed;  //!< lines of cv::HoughLines with the votes that it reports
    Share real;     //!< those whose real votes are above the threshold, with these votes
    int lines;      //!< ours
    int crowded;    //!< ours within one cell of another one
    int wrongVotes; //!< ours whose votes are not what counting gives

    bool isHonest() const { return crowded == 0 && wrongVotes == 0; }
};

//! Over cases.
struct Summary
{
    int cases = 0, dishonest = 0;
    double mean = 0, worst = 1;         //!< of the claimed shares
    double realMean = 0, realWorst = 1; //!< of the real ones
};

Summary summaryOf(const std::vector<Result>& results);

void printCase(const Result& result, std::ostream& out);
void printSummary(const Summary& summary, std::ostream& out);
//! `heading`: command, commit and machine, a line each.
void printMarkdown(const std::vector<Result>& results, const std::vector<std::string>& heading,
                   const std::vector<std::string>& skipped, std::ostream& out);

} // namespace conformance

#endif // LINESPACE_CONFORMANCE_REPORT_HPP
