// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "inputs.hpp"

#include "accuracy/scene.hpp"
#include "support/edge_maps.hpp"

#include "opencv2/imgproc.hpp"

#include <algorithm>
#include <filesystem>

namespace cascade {

namespace {

// Scenes with and without straight lines; of the views of one scene, one.
const char* const sampleNames[] = {"aero1.jpg",
                                   "aloeL.jpg",
                                   "apple.jpg",
                                   "baboon.jpg",
                                   "basketball1.png",
                                   "blox.jpg",
                                   "board.jpg",
                                   "box_in_scene.png",
                                   "building.jpg",
                                   "butterfly.jpg",
                                   "cards.png",
                                   "fruits.jpg",
                                   "graf1.png",
                                   "home.jpg",
                                   "left.jpg",
                                   "left01.jpg",
                                   "left12.jpg",
                                   "leuvenA.jpg",
                                   "licenseplate_motion.jpg",
                                   "messi5.jpg",
                                   "notes.png",
                                   "smarties.png",
                                   "starry_night.jpg",
                                   "stuff.jpg",
                                   "sudoku.png"};

void addFolder(const std::string& evaluation, const std::string& group,
               const std::string& extension, std::vector<Source>& sources)
{
    const std::size_t before = sources.size();
    const std::filesystem::path folder = std::filesystem::path(evaluation) / group;
    if (std::filesystem::is_directory(folder))
        for (const auto& entry : std::filesystem::directory_iterator(folder))
            if (entry.path().extension() == extension)
                sources.push_back({group, entry.path().filename().string(), entry.path().string()});
    if (sources.size() == before)
        throw support::MissingImage("no " + extension + " in " + folder.string());
    std::sort(sources.begin() + before, sources.end(),
              [](const Source& a, const Source& b) { return a.name < b.name; });
}

cv::Mat1b read(const Source& source)
{
    const std::filesystem::path path(source.path);
    return support::readPhotograph(path.parent_path().string(), path.filename().string());
}

Input inputOf(const Source& source, const cv::Mat1b& image, support::CannyThresholds thresholds)
{
    Input input{source,
                support::cannyEdges(image, thresholds),
                {},
                {},
                std::min(image.cols, image.rows) / 10};
    cv::Sobel(image, input.dx, CV_16S, 1, 0);
    cv::Sobel(image, input.dy, CV_16S, 0, 1);
    return input;
}

Input drawnScene(const Source& source, cv::Size size)
{
    const int i = source.scene;
    scenes::SceneOptions options;
    options.size = size;
    options.lines = 1 << i % 5;                          // 1 to 16
    options.noise = options.contrast * (i / 5 % 4) / 10; // contrast / noise infinite, 10, 5, 3.3
    options.keptFraction = i % 3 == 0 ? 0.5 : 1;         // of bars
    const scenes::Scene scene =
        i % 2 == 0 ? scenes::stepEdges(options, i) : scenes::bars(options, i);
    Input input = inputOf(source, scene.image, {40, 80});
    if (i / 20 % 2 == 1)
        scenes::addClutter(input.edges, 0.05, i);
    return input;
}

cv::Size sizeOfScene(int scene)
{
    const cv::Size sizes[] = {{256, 256}, {320, 240}, {251, 181}, {192, 288}};
    return sizes[scene / 3 % std::size(sizes)];
}

} // namespace

std::vector<Source> photographs(const std::string& samples, const std::string& evaluation)
{
    std::vector<Source> sources;
    for (const char* name : sampleNames)
        sources.push_back({"samples", name, samples + "/" + name});
    if (!evaluation.empty())
    {
        addFolder(evaluation, "chessboard", ".png", sources);
        addFolder(evaluation, "sudoku", ".jpg", sources);
        addFolder(evaluation, "york", ".jpg", sources);
    }
    return sources;
}

std::vector<Source> syntheticScenes(int count)
{
    std::vector<Source> sources;
    for (int i = 0; i < count; ++i)
        sources.push_back({"synthetic", "scene " + std::to_string(i), "", i});
    return sources;
}

Input readInput(const Source& source, int longest)
{
    if (source.scene >= 0)
        return drawnScene(source, sizeOfScene(source.scene));
    cv::Mat1b image = read(source);
    const double scale = (double)longest / std::max(image.cols, image.rows);
    if (scale < 1)
        image = support::scaled(image,
                                cv::Size(cvRound(image.cols * scale), cvRound(image.rows * scale)));
    return inputOf(source, image, {});
}

Input readSquare(const Source& source, int side)
{
    const cv::Size size(side, side);
    return source.scene >= 0 ? drawnScene(source, size)
                             : inputOf(source, support::scaled(read(source), size), {});
}

} // namespace cascade
