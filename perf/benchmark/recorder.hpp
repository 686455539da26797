// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The CSV files of a run, which report.py reads. Every timed call is one row:
//   times.csv   section,image,width,height,edge_pixels,threshold,threads,isa,method,turn,
//               milliseconds,lines,valid
//   stages.csv  the same up to turn, then stage,order,milliseconds: a row for each stage of a call
//               that has any
// `valid` is 0 where the lines were not the reference's: such a time does not count.

#ifndef LINESPACE_BENCHMARK_RECORDER_HPP
#define LINESPACE_BENCHMARK_RECORDER_HPP

#include "calls.hpp"

#include <fstream>
#include <string>

namespace benchmark {

//! A CSV file; throws std::runtime_error if it cannot be written.
class CsvFile
{
public:
    CsvFile(const std::string& path, const std::string& heading);
    //! Cells are numbers, or texts without commas.
    template<class... Cells>
    void row(const Cells&... cells)
    {
        const char* separator = "";
        ((file_ << separator << cells, separator = ","), ...);
        file_ << "\n";
    }
    void close();

private:
    std::string path_;
    std::ofstream file_;
};

//! Under what circumstances a call was timed.
struct Circumstances
{
    std::string section;
    const Input* input;
    int threads;
    std::string isa;
};

class Recorder
{
public:
    explicit Recorder(const std::string& folder);

    void record(const Circumstances& where, const std::string& method, int turn,
                const Outcome& outcome);
    //! How many of the recorded calls did not find the reference's lines.
    int invalidCount() const { return invalid_; }
    void close();

private:
    CsvFile times_, stages_;
    int invalid_;
};

} // namespace benchmark

#endif // LINESPACE_BENCHMARK_RECORDER_HPP
