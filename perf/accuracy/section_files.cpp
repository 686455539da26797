// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "section_files.hpp"

#include <iomanip>
#include <stdexcept>

namespace accuracy {

namespace {

std::ofstream opened(const std::string& path, const std::string& heading)
{
    std::ofstream file(path);
    file << std::setprecision(10) << heading << "\n";
    if (!file)
        throw std::runtime_error("cannot write " + path);
    return file;
}

} // namespace

SectionFiles::SectionFiles(const std::string& folder, const std::string& section)
    : runs(opened(folder + "/" + section + "-runs.csv", "group,image,width,height,detector,lines")),
      lines(opened(folder + "/" + section + "-lines.csv",
                   "group,image,detector,rank,rho,theta,votes")),
      truths(opened(folder + "/" + section + "-truth.csv", "group,image,rho,theta"))
{
}

void SectionFiles::run(const ImageName& name, const EdgeInput& input,
                       const std::vector<Detector>& detectors, const Request& request)
{
    const std::string key = name.group + "," + name.image + ",";
    for (const Detector& detector : detectors)
        for (const Result& result : detector(input, request))
        {
            runs << key << input.edges.cols << "," << input.edges.rows << "," << result.detector
                 << "," << result.lines.size() << "\n";
            int rank = 0;
            for (const DetectedLine& line : result.lines)
                lines << key << result.detector << "," << ++rank << "," << line.rho << ","
                      << line.theta << "," << line.votes << "\n";
        }
}

void SectionFiles::truth(const ImageName& name, const std::vector<scenes::Line>& list)
{
    for (const scenes::Line& line : list)
        truths << name.group << "," << name.image << "," << line.rho << "," << line.theta << "\n";
}

void SectionFiles::close()
{
    for (std::ofstream* file : {&runs, &lines, &truths})
    {
        file->close();
        if (!*file)
            throw std::runtime_error("cannot write the lines");
    }
}

} // namespace accuracy
