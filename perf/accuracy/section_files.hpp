// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The CSV files of one section of the evaluation, which report.py reads:
//   SECTION-runs.csv   group,image,width,height,detector,lines   one row for each detector and image
//   SECTION-lines.csv  group,image,detector,rank,rho,theta,votes   strongest first, rank from 1
//   SECTION-truth.csv  group,image,rho,theta   of synthetic images only

#ifndef LINESPACE_ACCURACY_SECTION_FILES_HPP
#define LINESPACE_ACCURACY_SECTION_FILES_HPP

#include "detectors.hpp"

#include "accuracy/scene.hpp"

#include <fstream>
#include <string>

namespace accuracy {

//! Names an image; neither part contains a comma. The parts of a group are separated by "|".
struct ImageName
{
    std::string group, image;
};

class SectionFiles
{
public:
    //! Throws std::runtime_error if the files cannot be written.
    SectionFiles(const std::string& folder, const std::string& section);

    //! Runs the detectors and writes what they find.
    void run(const ImageName& name, const EdgeInput& input, const std::vector<Detector>& detectors,
             const Request& request);
    void truth(const ImageName& name, const std::vector<scenes::Line>& lines);
    //! Throws std::runtime_error if anything could not be written.
    void close();

private:
    std::ofstream runs, lines, truths;
};

} // namespace accuracy

#endif // LINESPACE_ACCURACY_SECTION_FILES_HPP
