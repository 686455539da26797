// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "recorder.hpp"

#include <iomanip>
#include <iostream>
#include <stdexcept>

namespace benchmark {

namespace {

const char* const circumstances = "section,image,width,height,edge_pixels,threshold,threads,isa,"
                                  "method,turn,";

} // namespace

CsvFile::CsvFile(const std::string& path, const std::string& heading) : path_(path), file_(path)
{
    file_ << std::setprecision(10) << heading << "\n";
    if (!file_)
        throw std::runtime_error("cannot write " + path);
}

void CsvFile::close()
{
    file_.close();
    if (!file_)
        throw std::runtime_error("cannot write " + path_);
}

Recorder::Recorder(const std::string& folder)
    : times_(folder + "/times.csv", std::string(circumstances) + "milliseconds,lines,valid"),
      stages_(folder + "/stages.csv", std::string(circumstances) + "stage,order,milliseconds"),
      invalid_(0)
{
}

void Recorder::record(const Circumstances& where, const std::string& method, int turn,
                      const Outcome& outcome)
{
    const Input& input = *where.input;
    const auto write = [&](CsvFile& file, const auto&... cells)
    {
        file.row(where.section, input.name, input.edges.cols, input.edges.rows,
                 cv::countNonZero(input.edges), input.threshold, where.threads, where.isa, method,
                 turn, cells...);
    };
    write(times_, outcome.milliseconds, outcome.lines, outcome.valid ? 1 : 0);
    int order = 0;
    for (const Stage& stage : outcome.stages)
        write(stages_, stage.name, order++, stage.milliseconds);
    if (!outcome.valid && invalid_++ == 0)
        std::cerr << "Not the reference's lines: " << method << " on " << input.name << ", "
                  << input.edges.cols << " x " << input.edges.rows << "\n";
}

void Recorder::close()
{
    times_.close();
    stages_.close();
}

} // namespace benchmark
