// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "cases.hpp"

#include <algorithm>

#include "opencv2/imgproc.hpp"
#include "opencv_lines.hpp"
#include "support/edge_maps.hpp"

namespace conformance {

namespace {

using support::CannyThresholds;

const double degree = CV_PI / 180;

struct Picture
{
    std::string name;
    cv::Mat1b grey;
};

//! Reads a picture, or notes why it is left out.
bool read(const std::string& folder, const std::string& name, Grid& grid, Picture& picture)
{
    try
    {
        picture = {name, support::readPhotograph(folder, name)};
        return true;
    }
    catch (const support::MissingImage& missing)
    {
        grid.skipped.push_back(missing.what());
        return false;
    }
}

bool readSample(const Folders& folders, const std::string& name, Grid& grid, Picture& picture)
{
    const bool isThere = read(folders.samples, name, grid, picture);
    grid.isComplete = grid.isComplete && isThere;
    return isThere;
}

std::string titleOf(const Picture& picture)
{
    const std::size_t folder = picture.name.rfind('/') + 1;
    return picture.name.substr(folder) + " " + std::to_string(picture.grey.cols) + " x " +
           std::to_string(picture.grey.rows);
}

Arguments resolution(double rho, double theta)
{
    Arguments arguments;
    arguments.rho = rho;
    arguments.theta = theta;
    return arguments;
}

std::vector<Arguments> everyResolution()
{
    std::vector<Arguments> list;
    for (double rho : {0.5, 1.0, 2.0})
        for (double theta : {0.25, 0.5, 1.0, 2.0})
            list.push_back(resolution(rho, theta * degree));
    return list;
}

//! Degrees: parts of the usual range, through 0, beyond pi, wholly negative, a turn.
std::vector<Arguments> angleRanges(bool all)
{
    const double ranges[][2] = {{0, 90},    {45, 135},    {-30, 30}, {-90, 90},
                                {150, 230}, {-180, -100}, {0, 360}};
    std::vector<Arguments> list;
    for (Arguments arguments : all ? everyResolution() : std::vector<Arguments>(1))
        for (const double* range : ranges)
        {
            arguments.minTheta = range[0] * degree;
            arguments.maxTheta = range[1] * degree;
            list.push_back(arguments);
        }
    return list;
}

//! The pictures, resolutions and thresholds of OpenCV's own test of HoughLines.
void addOpenCVsOwn(const Folders& folders, Grid& grid)
{
    std::vector<Arguments> own;
    for (double rho : {1.0, 10.0})
        for (double theta : {0.05, 0.1})
            own.push_back(resolution(rho, theta));
    const auto add = [&](const Picture& picture)
    {
        const cv::Mat1b edges = support::cannyEdges(picture.grey, CannyThresholds{100, 150});
        grid.searches.push_back({titleOf(picture), "OpenCV's own test", edges, own, {80, 150}, {}});
    };
    Picture picture;
    for (const char* name : {"pic5.png", "pic1.png"}) // the latter of its test of HoughLinesP
        if (readSample(folders, name, grid, picture))
            add(picture);
    if (read(folders.extra, "stitching/a1.png", grid, picture))
        add(picture);
}

void addWeighted(const Picture& picture, const std::vector<int>& lineCounts, Grid& grid)
{
    // The strength of an edge as its weight.
    cv::Mat dx, dy, magnitude;
    cv::Sobel(picture.grey, dx, CV_32F, 1, 0);
    cv::Sobel(picture.grey, dy, CV_32F, 0, 1);
    cv::magnitude(dx, dy, magnitude);
    cv::Mat1b weights, edges;
    magnitude.convertTo(weights, CV_8U, 0.25);
    cv::max(weights, 1, weights);
    weights.copyTo(edges, support::cannyEdges(picture.grey));
    std::vector<Arguments> list = everyResolution();
    for (Arguments& arguments : list)
        arguments.weighted = true;
    grid.searches.push_back({titleOf(picture), "edge values", edges, list, {}, lineCounts});
}

void addPicture(const Picture& picture, const std::vector<int>& lineCounts, bool all, Grid& grid)
{
    const std::string title = titleOf(picture);
    const cv::Mat1b edges = support::cannyEdges(picture.grey);
    grid.searches.push_back({title, "resolutions", edges, everyResolution(), {}, lineCounts});
    grid.searches.push_back({title, "angle ranges", edges, angleRanges(all), {}, lineCounts});
    if (opencvHasEdgeValues())
        addWeighted(picture, lineCounts, grid);
}

} // namespace

Grid makeGrid(const Folders& folders, bool all)
{
    Grid grid;
    addOpenCVsOwn(folders, grid);
    if (!opencvHasEdgeValues())
        grid.skipped.push_back(
            "edge values as weights: cv::HoughLines has no use_edgeval before 4.11");

    const std::vector<int> lineCounts = all ? std::vector<int>{5, 30, 100, 300, 1000, 3000, 10000}
                                            : std::vector<int>{10, 100, 2000};
    for (const char* name : {"building.jpg", "board.jpg", "home.jpg", "sudoku.png", "pic1.png",
                             "pic2.png", "pic3.png", "pic4.png", "pic5.png", "pic6.png"})
    {
        Picture picture;
        if (!readSample(folders, name, grid, picture))
            continue;
        addPicture(picture, lineCounts, all, grid);
        const bool isDrawing = picture.name.compare(0, 3, "pic") == 0;
        if (isDrawing && !all)
            continue;
        const cv::Size square(512, 512);
        if (picture.grey.size() != square)
            addPicture({picture.name, support::scaled(picture.grey, square)}, lineCounts, all,
                       grid);
    }
    return grid;
}

int leastThreshold(const Search& search, const Arguments& arguments)
{
    if (!search.thresholds.empty())
        return *std::min_element(search.thresholds.begin(), search.thresholds.end());
    // Fewer edge pixels than that are no line.
    return arguments.weighted ? 20 * 64 : 20;
}

std::vector<int> thresholdsOf(const Search& search, const Lines& lines)
{
    if (!search.thresholds.empty())
        return search.thresholds;
    std::vector<int> thresholds;
    for (int count : search.lineCounts)
        if (count < static_cast<int>(lines.size()))
        {
            // Where the strongest lines are all as strong, they are taken in.
            const float votes = lines[count][2];
            thresholds.push_back(static_cast<int>(votes) - (lines[0][2] <= votes));
        }
    return thresholds;
}

} // namespace conformance
