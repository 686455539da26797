// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Times ways to merge, to find the strongest maxima and to sort candidates by OpenGL beside what
// the library does, and checks that they give the same. Prints a table in markdown.

#include "ways.hpp"

#include "backends.hpp"
#include "gl_cascade.hpp"

#include "common/stopwatch.hpp"
#include "support/edge_maps.hpp"
#include "support/machine.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <iostream>

namespace ways {

Input::Input(ls::GlDevice& device_, ls::Executor& executor_, const cv::Mat1b& image)
    : device(device_), executor(executor_), plan(ls::Plan::cascaded(image.size(), 8)),
      levels(plan->levelCount())
{
    cv::min(image, cv::Scalar(1), edges.votes);
    for (int l = 0; l < plan->levelCount(); ++l)
    {
        const ls::Level& level = plan->level(l);
        executor.allocate(level, edges.depthFor(level.maxVotes), levels[l]);
        if (l == 0)
            executor.firstCells(edges, *plan, levels[0]);
        else
            executor.mergeCells(*plan, l, levels[l - 1], levels[l]);
    }
    executor.fetch(levels.back()); // for what the host finds
}

namespace {

struct Settings
{
    std::string data;
    std::vector<int> sides, most;
    int turns;
    int mostSlow; //!< maxima for which the whole table is reduced each time
};

//! Milliseconds; negative: the device has no clock.
double timeOf(const Way& way, ls::GlDevice& device)
{
    device.end();
    if (way.prepare)
    {
        device.begin();
        way.prepare();
        device.end();
    }
    if (way.isOfHost)
    {
        const double milliseconds = measure::millisecondsOf(way.queue);
        device.begin();
        return milliseconds;
    }
    device.begin();
    device.stamp();
    way.queue();
    device.stamp();
    device.finish();
    const std::vector<double> laps = device.laps();
    return laps.empty() ? -1 : laps.front();
}

//! Whether all were right.
bool timeInTurn(const std::vector<Way>& ways, Input& input, int turns)
{
    std::vector<std::vector<double>> times(ways.size());
    bool areRight = true;
    for (int turn = 0; turn <= turns; ++turn)
        for (size_t i = 0; i < ways.size(); ++i)
        {
            const double milliseconds = timeOf(ways[i], input.device);
            if (turn > 0)
                times[i].push_back(milliseconds);
            else if (!ways[i].isRight()) // it was a first call
            {
                std::cerr << ways[i].step << ", " << ways[i].name << ", most " << ways[i].most
                          << ": not the library's result\n";
                areRight = false;
            }
        }
    for (size_t i = 0; i < ways.size(); ++i)
    {
        const Way& way = ways[i];
        const double milliseconds = times[i].empty() ? -1 : measure::median(times[i]);
        std::printf("| %s | %s | %d | %s | %s | %.4g | %.4g | %.4g |\n", way.step.c_str(),
                    way.name.c_str(), input.plan->imageSize().width,
                    way.most ? std::to_string(way.most).c_str() : "",
                    milliseconds < 0 ? "-" : cv::format("%.3g", milliseconds).c_str(),
                    way.loads * 1e-6, way.stores * 1e-6, way.adds * 1e-6);
    }
    std::fflush(stdout);
    return areRight;
}

bool run(const Settings& settings)
{
    const ls::GlContext context = ls::GlContext::headless();
    const ls::GlBinding binding(context); // as if it were a caller's, for all that follows
    const cv::Ptr<ls::Executor> executor = ls::createOpenGlExecutor();
    const cv::Ptr<ls::GlDevice> device = ls::GlDevice::take();
    const ls::WorkingTime time(*executor);
    device->begin();
    std::printf(
        "%s; OpenGL: %s; %s. Medians of %d turns of all ways of a step, by the device's clock, "
        "by that of the host where it sorts. Words and additions (or comparisons) in 10^6.\n\n"
        "| step | way | n | most | ms | loads | stores | adds |\n"
        "| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: |\n",
        support::machine().c_str(), device->renderer().c_str(), support::commit().c_str(),
        settings.turns);
    const cv::Mat1b photograph = support::readPhotograph(settings.data, "building.jpg");
    bool areRight = true;
    for (const int n : settings.sides)
    {
        Input input(*device, *executor,
                    support::cannyEdges(support::scaled(photograph, cv::Size(n, n))));
        areRight = timeInTurn(mergeWays(input), input, settings.turns) && areRight;
        for (const int most : settings.most)
        {
            areRight = timeInTurn(maximaWays(input, most, most <= settings.mostSlow), input,
                                  settings.turns) &&
                       areRight;
            areRight = timeInTurn(sortingWays(input, most), input, settings.turns) && areRight;
        }
    }
    device->end();
    return areRight;
}

} // namespace
} // namespace ways

int main(int argc, char** argv)
{
    ways::Settings settings{"", {128, 256, 512}, {10, 100, 1000, 4096}, 9, 1000};
    CLI::App app("Times ways to merge, find maxima and sort by OpenGL beside the library's.");
    app.add_option("--data", settings.data, "Folder of OpenCV's sample images (building.jpg, ...)")
        ->envname("LINESPACE_SAMPLES_DATA")
        ->required()
        ->check(CLI::ExistingDirectory);
    app.add_option("--sides", settings.sides, "Sides of the square images")
        ->check(CLI::Range(1, 4096))
        ->capture_default_str();
    app.add_option("--most", settings.most, "How many maxima, and candidates")
        ->check(CLI::Range(1, 1 << 20))
        ->capture_default_str();
    app.add_option("--turns", settings.turns, "Of each way")
        ->check(CLI::Range(0, 99))
        ->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    try
    {
        if (!ways::run(settings))
            return 1;
    }
    catch (const cv::linespace::DeviceFailure& failure)
    {
        std::cout << "SKIPPED: " << failure.reason << "\n";
        return 77;
    }
    catch (const std::exception& error)
    {
        std::cerr << "linespace_opengl_ways: " << error.what() << "\n";
        return 1;
    }
    return 0;
}
