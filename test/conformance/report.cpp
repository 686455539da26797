// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "report.hpp"

#include <algorithm>
#include <functional>
#include <iomanip>
#include <sstream>

namespace conformance {

namespace {

std::string number(double value, int digits)
{
    std::ostringstream text;
    text << std::setprecision(digits) << value;
    return text.str();
}

std::string share(double value)
{
    std::ostringstream text;
    text << std::fixed << std::setprecision(4) << value;
    return text.str();
}

//! An angle as it is best read: OpenCV's own test gives round numbers of radians, the others
//! degrees.
std::string angle(double radians)
{
    const double hundredths = radians * 100;
    if (std::abs(hundredths - std::round(hundredths)) < 1e-9 && radians != 0)
        return number(radians, 4) + " rad";
    return number(radians * 180 / CV_PI, 5) + "°";
}

std::string rangeOf(const Arguments& arguments)
{
    return angle(arguments.minTheta) + " to " + angle(arguments.maxTheta);
}

std::string thresholdClass(const Result& result)
{
    const int lines = result.claimed.of;
    return lines <= 10     ? "up to 10"
           : lines <= 100  ? "11 to 100"
           : lines <= 1000 ? "101 to 1000"
                           : "more than 1000";
}

//! One table: the cases by a key, in the order in which the keys first appear.
void printTable(const std::vector<Result>& results, const std::string& title,
                const std::function<std::string(const Result&)>& keyOf, std::ostream& out)
{
    std::vector<std::string> keys;
    for (const Result& result : results)
        if (std::find(keys.begin(), keys.end(), keyOf(result)) == keys.end())
            keys.push_back(keyOf(result));
    out << "\n| " << title
        << " | cases | mean | worst | mean, real votes | worst, real votes | lines of cv | ours |\n"
        << "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n";
    for (const std::string& key : keys)
    {
        std::vector<Result> selected;
        long wanted = 0, lines = 0;
        for (const Result& result : results)
            if (keyOf(result) == key)
            {
                selected.push_back(result);
                wanted += result.claimed.of;
                lines += result.lines;
            }
        const Summary summary = summaryOf(selected);
        out << "| " << key << " | " << summary.cases << " | " << share(summary.mean) << " | "
            << share(summary.worst) << " | " << share(summary.realMean) << " | "
            << share(summary.realWorst) << " | " << wanted << " | " << lines << " |\n";
    }
}

void printWorst(std::vector<Result> results, std::ostream& out)
{
    std::stable_sort(results.begin(), results.end(),
                     [](const Result& a, const Result& b)
                     { return a.claimed.value() < b.claimed.value(); });
    results.resize(std::min<std::size_t>(results.size(), 10));
    out << "\nThe ten worst cases:\n\n"
           "| image | rho | theta | range | threshold | found | of | share | found, real votes | "
           "of |\n"
           "| --- | ---: | ---: | --- | ---: | ---: | ---: | ---: | ---: | ---: |\n";
    for (const Result& r : results)
        out << "| " << r.image << " | " << number(r.arguments.rho, 3) << " | "
            << angle(r.arguments.theta) << " | " << rangeOf(r.arguments) << " | " << r.threshold
            << " | " << r.claimed.found << " | " << r.claimed.of << " | "
            << share(r.claimed.value()) << " | " << r.real.found << " | " << r.real.of << " |\n";
}

} // namespace

Summary summaryOf(const std::vector<Result>& results)
{
    Summary summary;
    for (const Result& result : results)
    {
        ++summary.cases;
        summary.dishonest += !result.isHonest();
        summary.mean += result.claimed.value();
        summary.worst = std::min(summary.worst, result.claimed.value());
        summary.realMean += result.real.value();
        summary.realWorst = std::min(summary.realWorst, result.real.value());
    }
    summary.mean /= std::max(1, summary.cases);
    summary.realMean /= std::max(1, summary.cases);
    return summary;
}

void printCase(const Result& r, std::ostream& out)
{
    std::ostringstream line;
    line << std::left << std::setw(24) << r.image << " rho " << std::setw(4)
         << number(r.arguments.rho, 3) << " theta " << std::setw(9) << angle(r.arguments.theta)
         << std::setw(15) << rangeOf(r.arguments) << " threshold " << std::setw(6) << r.threshold
         << (r.arguments.weighted ? "weighted " : "") << "found " << r.claimed.found << " of "
         << r.claimed.of << " = " << share(r.claimed.value()) << ", real votes " << r.real.found
         << " of " << r.real.of << ", ours " << r.lines;
    if (r.crowded)
        line << ", " << r.crowded << " WITHIN ONE CELL OF ANOTHER";
    if (r.wrongVotes)
        line << ", " << r.wrongVotes << " WITH WRONG VOTES";
    out << line.str() << std::endl;
}

void printSummary(const Summary& summary, std::ostream& out)
{
    out << summary.cases << " cases: mean share " << share(summary.mean) << ", worst case "
        << share(summary.worst) << "; by real votes " << share(summary.realMean) << ", "
        << share(summary.realWorst)
        << "; cases with lines in one cell or with wrong votes: " << summary.dishonest << std::endl;
}

void printMarkdown(const std::vector<Result>& results, const std::vector<std::string>& heading,
                   const std::vector<std::string>& skipped, std::ostream& out)
{
    const Summary summary = summaryOf(results);
    out << "# Conformance of the drop-in to cv::HoughLines\n\n"
           "How many lines of `cv::HoughLines` has `cv::linespace::HoughLines`, called with the "
           "same\n"
           "arguments on the same edge map? A line counts as found if ours has one within one "
           "cell\n"
           "(rho differs by at most rho, theta by at most theta) with at least 98 % of its votes.\n"
           "cv::HoughLines reports every local maximum of its accumulator, so that an edge gives\n"
           "several neighbouring lines; ours reports no two within one cell, hence the difference\n"
           "in numbers. The lines of cv::HoughLines are first freed of the bias of half a rho "
           "that\n"
           "its versions before 4.13 have where the number of cells is even.\n\n"
           "A case is an edge map, a resolution, an angle range and a threshold. Thresholds are\n"
           "those at which cv::HoughLines gives 10, 100 and 2000 lines, and those of OpenCV's own\n"
           "test. The share of a case is the lines found by all lines of cv::HoughLines; means "
           "are\n"
           "over cases. In every case the test also checks that no two of our lines are within "
           "one\n"
           "cell, and counts the edge pixels of each of our lines to verify its votes.\n\n"
           "*Real votes*: cv::HoughLines adds up its angles in float, and so counts at an angle "
           "that\n"
           "differs from the reported one by up to 1e-4 rad. Some of the votes that it reports "
           "are\n"
           "pixels that are not within rho / 2 of the line that it reports, and lines just above "
           "the\n"
           "threshold are really at it. The columns with real votes count the edge pixels of its\n"
           "lines too: a line whose real votes are not above the threshold is not asked for, and "
           "the\n"
           "98 % are of the real votes. Votes of ours are always real.\n\n";
    for (const std::string& line : heading)
        out << "- " << line << "\n";
    for (const std::string& line : skipped)
        out << "- left out: " << line << "\n";
    out << "\n**" << summary.cases << " cases: mean share " << share(summary.mean)
        << ", worst case " << share(summary.worst) << "; by real votes " << share(summary.realMean)
        << ", worst case " << share(summary.realWorst)
        << "; cases with two lines in one cell or with wrong votes: " << summary.dishonest
        << ".**\n";
    std::vector<Result> bySize = results;
    std::stable_sort(bySize.begin(), bySize.end(),
                     [](const Result& a, const Result& b) { return a.claimed.of < b.claimed.of; });
    printTable(bySize, "lines of cv::HoughLines in the case", thresholdClass, out);
    printTable(
        results, "what is varied", [](const Result& r) { return r.group; }, out);
    printTable(
        results, "rho, theta",
        [](const Result& r)
        { return number(r.arguments.rho, 3) + " px, " + angle(r.arguments.theta); },
        out);
    printTable(
        results, "angle range", [](const Result& r) { return rangeOf(r.arguments); }, out);
    printTable(
        results, "image", [](const Result& r) { return r.image; }, out);
    printWorst(results, out);
}

} // namespace conformance
