// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The sections of the evaluation. Each runs the detectors on its images and writes its CSV files,
// see section_files.hpp; what the numbers mean is in report.py.

#ifndef LINESPACE_ACCURACY_SECTIONS_HPP
#define LINESPACE_ACCURACY_SECTIONS_HPP

#include <string>

namespace accuracy {

struct Settings
{
    std::string data;   //!< folder with photographs and ground truth
    std::string output; //!< folder to write to
    bool quick;         //!< a few images of each section, to see that everything works
};

// Photographs.
void writeChessboards(const Settings& settings);
void writeSudoku(const Settings& settings);
void writeYork(const Settings& settings);
//! All of them at half, whole and double size, by each detector's own rule.
void writeScales(const Settings& settings);

// Synthetic images.
void writeSteps(const Settings& settings);  //!< eight step edges, two sizes, two levels of noise
void writeScenes(const Settings& settings); //!< other sizes, numbers of lines, bars, clutter, ...
void writeOneEdge(const Settings& settings);
void writeNegatives(const Settings& settings);

} // namespace accuracy

#endif // LINESPACE_ACCURACY_SECTIONS_HPP
