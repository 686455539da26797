// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The sections of the benchmark; each records the calls that it times.

#ifndef LINESPACE_BENCHMARK_SECTIONS_HPP
#define LINESPACE_BENCHMARK_SECTIONS_HPP

#include "helpers.hpp"
#include "recorder.hpp"
#include "settings.hpp"

namespace benchmark {

//! All methods on the four photographs at three sizes: what is required is judged by these.
void timePhotographs(const Settings& settings, Recorder& recorder,
                     const std::vector<NewerOpenCv>& newer);

//! Table 1 of the paper: two images of different density, n = 64 to 1024.
void timePaper(const Settings& settings, Recorder& recorder, const std::vector<NewerOpenCv>& newer);

//! cv::UMat beside cv::Mat on the photographs.
void timeOpenCl(const Settings& settings, Recorder& recorder,
                const std::vector<NewerOpenCv>& newer);

//! The columns of Table 1 of the paper for OpenGL, n = 64 to 512.
void timeOpenGl(const Settings& settings, Recorder& recorder,
                const std::vector<NewerOpenCv>& newer);

//! One photograph at n = 64 to 2048.
void timeSizes(const Settings& settings, Recorder& recorder, const std::vector<NewerOpenCv>& newer);

//! 1 to 30 % edge pixels: random maps, and a photograph by other thresholds of Canny.
void timeDensities(const Settings& settings, Recorder& recorder,
                   const std::vector<NewerOpenCv>& newer);

//! One thread to all cores.
void timeThreads(const Settings& settings, Recorder& recorder);

//! Every instruction set that this machine has.
void timeInstructionSets(const Settings& settings, Recorder& recorder);

/** The stages of `detect`, with one thread and with all. Also writes their work, stage-work.csv, and
the machine's limits, limits.csv. */
void timeStages(const Settings& settings, Recorder& recorder);

//! The rise of the peak of memory by the first `detect` of a process: memory.csv.
void measureMemory(const Settings& settings);

} // namespace benchmark

#endif // LINESPACE_BENCHMARK_SECTIONS_HPP
