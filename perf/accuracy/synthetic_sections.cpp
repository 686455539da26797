// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "sections.hpp"

#include "accuracy/random.hpp"
#include "accuracy/scene.hpp"
#include "edge_input.hpp"
#include "section_files.hpp"

#include "opencv2/imgcodecs.hpp"

#include <functional>
#include <sstream>
#include <stdexcept>

namespace accuracy {

namespace {

using scenes::Scene;
using scenes::SceneOptions;

//! Of all synthetic images: Gaussian 5 x 5 of sigma 1.2, Canny 30/80.
const EdgeSettings edgeSettings{true, 30, 80};

std::string numbered(const std::string& name, int number)
{
    return name + " " + std::to_string(number);
}

template<class... Parts>
std::string joined(const Parts&... parts)
{
    std::ostringstream text;
    (text << ... << parts);
    return text.str();
}

void savePicture(const Settings& settings, const std::string& name, const cv::Mat& image)
{
    const std::string path = settings.output + "/" + name + ".png";
    if (!cv::imwrite(path, image))
        throw std::runtime_error("cannot write " + path);
}

//! One row of the table of other scenes: how to make them and what is done to the edge map.
struct SceneKind
{
    std::string group;
    SceneOptions options;
    std::function<Scene(const SceneOptions&, std::uint64_t)> make;
    double keptPixels = 1, clutter = 0;
};

SceneOptions benchmark(cv::Size size, double noise)
{
    SceneOptions options;
    options.size = size;
    options.noise = noise;
    return options;
}

Scene stepScene(const SceneOptions& options, std::uint64_t seed)
{
    return scenes::stepEdges(options, seed);
}

//! Two parallel lines near the middle of the image, at a random angle.
Scene parallelPair(const SceneOptions& options, std::uint64_t seed, double separation)
{
    scenes::Random random(seed, 100);
    const double theta = random.uniform(0, CV_PI);
    const double rho = 0.5 * (options.size.width - 1) * std::cos(theta) +
                       0.5 * (options.size.height - 1) * std::sin(theta) + random.uniform(-20, 20);
    return scenes::stepEdges({{rho, theta}, {rho + separation, theta}}, options, seed);
}

//! Two lines that cross near the middle of the image under an angle in degrees.
Scene crossing(const SceneOptions& options, std::uint64_t seed, double degrees)
{
    scenes::Random random(seed, 100);
    const double theta = random.uniform(0, CV_PI - 0.1), other = theta + degrees * CV_PI / 180;
    const double x = 0.5 * (options.size.width - 1) + random.uniform(-20, 20);
    const double y = 0.5 * (options.size.height - 1) + random.uniform(-20, 20);
    return scenes::stepEdges({{x * std::cos(theta) + y * std::sin(theta), theta},
                              {x * std::cos(other) + y * std::sin(other), other}},
                             options, seed);
}

std::vector<SceneKind> sceneKinds()
{
    const cv::Size middle(256, 256);
    std::vector<SceneKind> kinds;
    for (const cv::Size size :
         {cv::Size(128, 128), middle, cv::Size(512, 512), cv::Size(1024, 1024), cv::Size(333, 217)})
        kinds.push_back(
            {joined("steps|", size.width, " x ", size.height), benchmark(size, 8), stepScene});
    for (const int lines : {1, 3, 20})
    {
        SceneOptions options = benchmark(middle, 8);
        options.lines = lines;
        kinds.push_back(
            {joined("steps|", lines, lines == 1 ? " line" : " lines"), options, stepScene});
    }
    for (const double width : {1, 3, 5})
    {
        SceneOptions options = benchmark(middle, 8);
        options.contrast = 40;
        options.barWidth = width;
        kinds.push_back({joined("bars|width ", width), options, scenes::bars});
    }
    {
        SceneOptions options = benchmark(cv::Size(512, 512), 8);
        options.contrast = 40;
        options.lines = 50;
        kinds.push_back({"bars|50 lines 512 x 512", options, scenes::bars});
    }
    for (const double kept : {0.5, 0.25})
    {
        SceneOptions options = benchmark(middle, 8);
        options.contrast = 40;
        options.keptFraction = kept;
        kinds.push_back({joined("bars|dashed ", kept), options, scenes::bars});
    }
    for (const double kept : {0.5, 0.25})
        kinds.push_back({joined("edge pixels|kept ", kept), benchmark(middle, 8), stepScene, kept});
    for (const double clutter : {0.02, 0.05, 0.1})
        kinds.push_back(
            {joined("edge pixels|clutter ", clutter), benchmark(middle, 8), stepScene, 1, clutter});
    for (const double separation : {2, 3, 4, 6, 8, 10})
        kinds.push_back({joined("pair|", separation, " px apart"), benchmark(middle, 8),
                         [=](const SceneOptions& options, std::uint64_t seed)
                         {
                             return parallelPair(options, seed, separation);
                         }});
    for (const double degrees : {1, 2, 5})
        kinds.push_back({joined("crossing|", degrees, " deg"), benchmark(middle, 8),
                         [=](const SceneOptions& options, std::uint64_t seed)
                         {
                             return crossing(options, seed, degrees);
                         }});
    return kinds;
}

} // namespace

void writeSteps(const Settings& settings)
{
    SectionFiles files(settings.output, "steps");
    const int count = settings.quick ? 1 : 200;
    for (const int side : {256, 512})
        for (const double noise : {8.0, 20.0})
            for (int i = 0; i < count; ++i)
            {
                const Scene scene = scenes::stepEdges(benchmark(cv::Size(side, side), noise), i);
                const EdgeInput input = edgeInput(scene.image, edgeSettings);
                const std::string group = joined(side, "|", noise), image = numbered("scene", i);
                files.truth({"strongest|" + group, image}, scene.truth);
                files.run({"strongest|" + group, image}, input, allDetectors(),
                          {8, lowThreshold(input.edges.size())});
                files.truth({"own rule|" + group, image}, scene.truth);
                files.run({"own rule|" + group, image}, input, detectorsByOwnRule(), {0, 0});
                if (i == 0 && side == 512)
                    savePicture(settings, joined("steps-", noise), scene.image);
            }
    files.close();
}

void writeScenes(const Settings& settings)
{
    SectionFiles files(settings.output, "scenes");
    const int count = settings.quick ? 1 : 20;
    int number = 0;
    for (const SceneKind& kind : sceneKinds())
    {
        if (settings.quick && number++ % 4 != 0)
            continue;
        for (int i = 0; i < count; ++i)
        {
            const Scene scene = kind.make(kind.options, 1000 + i);
            EdgeInput input = edgeInput(scene.image, edgeSettings);
            scenes::thinOut(input.edges, kind.keptPixels, i);
            scenes::addClutter(input.edges, kind.clutter, i);
            const ImageName name{kind.group, numbered("scene", i)};
            files.truth(name, scene.truth);
            // Both edges of a bar are lines of the edge map.
            const int edges = kind.group.rfind("bars", 0) == 0 ? 2 : 1;
            files.run(name, input, allDetectors(),
                      {edges * (int)scene.truth.size(), lowThreshold(input.edges.size())});
        }
    }
    files.close();
}

void writeOneEdge(const Settings& settings)
{
    SectionFiles files(settings.output, "one-edge");
    const int side = 256, count = settings.quick ? 1 : 40;
    struct Angle
    {
        std::string name;
        double theta;
    };
    const std::vector<Angle> angles = {{"0", 0},
                                       {"0 + 0.001 rad", 0.001},
                                       {"0 - 0.001 rad", CV_PI - 0.001},
                                       {"45", CV_PI / 4},
                                       {"45 + 0.001 rad", CV_PI / 4 + 0.001},
                                       {"45 - 0.001 rad", CV_PI / 4 - 0.001},
                                       {"90", CV_PI / 2},
                                       {"90 + 0.001 rad", CV_PI / 2 + 0.001},
                                       {"90 - 0.001 rad", CV_PI / 2 - 0.001},
                                       {"17.3", 0.302},
                                       {"63.1", 1.101},
                                       {"126.2", 2.203}};
    for (const double ratio : {0.0, 10.0, 5.0, 3.0, 2.0}) // contrast / noise; 0: no noise
        for (std::size_t a = 0; a < angles.size(); a += settings.quick ? 4 : 1)
            for (int i = 0; i < count; ++i)
            {
                SceneOptions options;
                options.size = cv::Size(side, side);
                options.contrast = 50;
                options.blur = 1;
                options.noise = ratio > 0 ? options.contrast / ratio : 0;
                const std::uint64_t seed = 10000 + 100 * a + i;
                const double theta = angles[a].theta, middle = 0.5 * (side - 1);
                const double rho = middle * (std::cos(theta) + std::sin(theta)) +
                                   scenes::Random(seed, 100).uniform(-side / 8.0, side / 8.0);
                const Scene scene = scenes::stepEdges({{rho, theta}}, options, seed);
                const EdgeInput input = edgeInput(scene.image, edgeSettings);
                std::vector<Detector> detectors = allDetectors();
                detectors.push_back(unrefinedDetector());
                const ImageName name{joined(angles[a].name, "|", ratio), numbered("edge", i)};
                files.truth(name, scene.truth);
                files.run(name, input, detectors, {1, lowThreshold(input.edges.size())});
            }
    files.close();
}

void writeNegatives(const Settings& settings)
{
    SectionFiles files(settings.output, "negatives");
    const int count = settings.quick ? 1 : 50;
    struct Kind
    {
        const char* name;
        scenes::Negative kind;
    };
    for (const Kind& kind :
         {Kind{"noise", scenes::Negative::Noise}, Kind{"ramp", scenes::Negative::Ramp},
          Kind{"discs", scenes::Negative::Discs}, Kind{"salt", scenes::Negative::Salt}})
        for (int i = 0; i < count; ++i)
        {
            const cv::Mat1b image = scenes::negative(kind.kind, cv::Size(512, 512), i);
            files.run({kind.name, numbered("image", i)}, edgeInput(image, edgeSettings),
                      allDetectors(), {0, 0});
            if (i == 0)
                savePicture(settings, joined("negative-", kind.name), image);
        }
    files.close();
}

} // namespace accuracy
