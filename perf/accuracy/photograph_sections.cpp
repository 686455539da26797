// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "sections.hpp"

#include "edge_input.hpp"
#include "section_files.hpp"

#include "opencv2/imgcodecs.hpp"
#include "opencv2/imgproc.hpp"

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <stdexcept>

namespace accuracy {

namespace {

//! The photographs of a folder in the order of their names; one of them for a quick look.
std::vector<std::string> photographs(const Settings& settings, const std::string& folder)
{
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(settings.data + "/" + folder))
        if (entry.path().extension() == ".png" || entry.path().extension() == ".jpg")
            names.push_back(entry.path().filename().string());
    if (names.empty())
        throw std::runtime_error("no photographs in " + settings.data + "/" + folder);
    std::sort(names.begin(), names.end());
    if (settings.quick)
        names.resize(1);
    return names;
}

cv::Mat1b photograph(const Settings& settings, const std::string& folder, const std::string& name)
{
    const std::string path = settings.data + "/" + folder + "/" + name;
    const cv::Mat1b image = cv::imread(path, cv::IMREAD_GRAYSCALE);
    if (image.empty())
        throw std::runtime_error("cannot read " + path);
    return image;
}

std::string cannyGroup(const EdgeSettings& edges)
{
    std::ostringstream text;
    text << "Canny " << edges.low << "/" << edges.high;
    return text.str();
}

//! Every detector on every photograph of a folder, for its strongest lines.
void writeFolder(const Settings& settings, const std::string& folder,
                 const std::vector<EdgeSettings>& edgeSettings,
                 const std::vector<Detector>& detectors, int maxLines)
{
    SectionFiles files(settings.output, folder);
    for (const std::string& name : photographs(settings, folder))
    {
        const cv::Mat1b image = photograph(settings, folder, name);
        for (const EdgeSettings& edges : edgeSettings)
            files.run({cannyGroup(edges), name}, edgeInput(image, edges), detectors,
                      {maxLines, lowThreshold(image.size())});
    }
    files.close();
}

} // namespace

void writeChessboards(const Settings& settings)
{
    std::vector<Detector> detectors = allDetectors();
    detectors.push_back(unrefinedDetector());
    if (!settings.quick) // it takes seconds
        detectors.push_back(exactDetector());
    writeFolder(settings, "chessboard", {{false, 50, 150}}, detectors, 100);
}

void writeSudoku(const Settings& settings)
{
    std::vector<EdgeSettings> edges{{true, 50, 150}, {true, 20, 60}, {true, 10, 40}};
    if (settings.quick)
        edges.resize(1);
    writeFolder(settings, "sudoku", edges, allDetectors(), 100);
}

void writeYork(const Settings& settings)
{
    writeFolder(settings, "york", {{false, 50, 150}}, allDetectors(), 200);
}

void writeScales(const Settings& settings)
{
    SectionFiles files(settings.output, "scales");
    for (const char* folder : {"chessboard", "sudoku", "york"})
        for (const std::string& name : photographs(settings, folder))
        {
            const cv::Mat1b image = photograph(settings, folder, name);
            const auto run = [&](const char* scale, const cv::Mat& scaled, double low)
            {
                files.run({std::string(folder) + "|" + scale, name},
                          edgeInput(scaled, {false, low, 3 * low}), detectorsByOwnRule(), {0, 0});
            };
            cv::Mat half, twice;
            cv::resize(image, half, cv::Size(image.cols / 2, image.rows / 2), 0, 0, cv::INTER_AREA);
            cv::resize(image, twice, image.size() * 2, 0, 0, cv::INTER_CUBIC);
            run("half", half, 50);
            run("whole", image, 50);
            run("double", twice, 25); // interpolated grey levels change half as fast
        }
    files.close();
}

} // namespace accuracy
