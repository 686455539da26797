// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "sections.hpp"

#include "stage_work.hpp"
#include "turns.hpp"

#include "common/peak_memory.hpp"

#include "opencv2/linespace.hpp"

#include <iostream>

namespace benchmark {

namespace {

std::vector<cv::Size> squares(const std::vector<int>& sides)
{
    std::vector<cv::Size> sizes;
    for (const int n : sides)
        sizes.push_back({n, n});
    return sizes;
}

void append(std::vector<Call>& calls, const std::vector<Call>& more)
{
    calls.insert(calls.end(), more.begin(), more.end());
}

/** The drop-in beside cv::HoughLines, with two thresholds: a fifth of the shorter side, as
everywhere, and a tenth, for thousands of lines, which "low" in a method's name tells. */
std::vector<Call> houghCalls(const Settings& settings, const std::vector<NewerOpenCv>& newer,
                             const Input& input, bool low)
{
    const int threshold = low ? std::max(1, input.threshold / 2) : input.threshold;
    std::vector<Call> calls;
    for (const char* step : {"1 deg", "0.1 deg"})
    {
        append(calls, everyHoughLines(settings, newer, input, step, threshold));
        calls.push_back(dropIn(input, step, threshold));
    }
    if (low)
        for (Call& call : calls)
            call.method += " low";
    return calls;
}

} // namespace

void timePhotographs(const Settings& settings, Recorder& recorder,
                     const std::vector<NewerOpenCv>& newer)
{
    for (const cv::Size size : photographSizes(settings))
        for (const std::string& name : photographNames(settings))
        {
            const Input input = photograph(settings.data, name, size);
            std::vector<Call> calls = detections(input, {Kind::DETECT, Kind::UNPRUNED, Kind::NEW});
            append(calls,
                   {fastHoughTransform(input), houghLinesP(input), lineSegmentDetector(input),
                    fastLineDetector(input), edgeDrawing(input), canny(input)});
            append(calls, houghCalls(settings, newer, input, false));
            append(calls, houghCalls(settings, newer, input, true));
            append(calls, everyHoughLines(settings, newer, input, "1/(2n)", input.threshold));
            timeInTurn("photographs", input, calls, settings, recorder);
        }
}

void timePaper(const Settings& settings, Recorder& recorder, const std::vector<NewerOpenCv>& newer)
{
    if (!isOpenClThere())
        std::cerr << "Left out: OpenCL (no device; OPENCV_OPENCL_DEVICE names one)\n";
    for (const cv::Size size : squares(settings.some<int>({64, 128, 256, 512, 1024}, 2)))
        for (const char* name : {"sudoku.png", "board.jpg"})
        {
            const Input input = photograph(settings.data, name, size);
            std::vector<Call> calls =
                everyHoughLines(settings, newer, input, "1/(2n)", input.threshold);
            if (isOpenClThere())
                calls.push_back(openClHoughLines(input, "1/(2n)"));
            append(calls, detections(input, {Kind::EXACT, Kind::UNPRUNED, Kind::DETECT}));
            calls.push_back(fastHoughTransform(input));
            timeInTurn("paper", input, calls, settings, recorder);
        }
}

void timeOpenCl(const Settings& settings, Recorder& recorder, const std::vector<NewerOpenCv>& newer)
{
    if (!isOpenClThere())
        return;
    for (const cv::Size size : photographSizes(settings))
        for (const std::string& name : photographNames(settings))
        {
            const Input input = photograph(settings.data, name, size);
            std::vector<Call> calls = {detection(input, Kind::DETECT),
                                       dropIn(input, "1 deg", input.threshold)};
            append(calls, everyHoughLines(settings, newer, input, "1 deg", input.threshold));
            append(calls, openClCalls(input));
            timeInTurn("opencl", input, calls, settings, recorder);
        }
}

void timeOpenGl(const Settings& settings, Recorder& recorder, const std::vector<NewerOpenCv>& newer)
{
    if (!isOpenGlThere())
    {
        std::cerr << "Left out: OpenGL (no context without a window)\n";
        return;
    }
    for (const cv::Size size : squares(settings.some<int>({64, 128, 256, 512}, 2)))
        for (const char* name : {"sudoku.png", "board.jpg"})
        {
            const Input input = photograph(settings.data, name, size);
            std::vector<Call> calls =
                everyHoughLines(settings, newer, input, "1/(2n)", input.threshold);
            append(calls, openGlDetections(input, {Kind::EXACT, Kind::DETECT}));
            append(calls, detections(input, {Kind::EXACT, Kind::UNPRUNED}));
            timeInTurn("opengl", input, calls, settings, recorder);
        }
    CsvFile file(settings.output + "/opengl-work.csv",
                 "n,stage,loads,stores,adds,shared_loads,fused_loads");
    for (const int n : settings.some<int>({64, 128, 256, 512}, 2))
        for (const WordWork& work : wordWork({n, n}, 8))
            file.row(n, work.stage, work.loads, work.stores, work.adds, work.sharedLoads,
                     work.fusedLoads);
    file.close();
}

void timeSizes(const Settings& settings, Recorder& recorder, const std::vector<NewerOpenCv>& newer)
{
    for (const cv::Size size : squares(settings.some<int>({64, 128, 256, 512, 1024, 2048}, 3)))
    {
        const Input input = photograph(settings.data, "building.jpg", size);
        std::vector<Call> calls = detections(input, {Kind::DETECT, Kind::UNPRUNED});
        append(calls, {fastHoughTransform(input), dropIn(input, "1 deg", input.threshold),
                       houghLinesP(input), lineSegmentDetector(input), fastLineDetector(input),
                       edgeDrawing(input)});
        std::vector<std::string> steps = {"1 deg", "0.1 deg"};
        if (size.width <= 1024) // minutes beyond
            steps.push_back("1/(2n)");
        for (const std::string& step : steps)
            append(calls, everyHoughLines(settings, newer, input, step, input.threshold));
        timeInTurn("sizes", input, calls, settings, recorder);
    }
}

void timeDensities(const Settings& settings, Recorder& recorder,
                   const std::vector<NewerOpenCv>& newer)
{
    for (const cv::Size size :
         squares(settings.quick ? std::vector<int>{128} : std::vector<int>{512, 1024}))
        for (const double density : settings.some<double>({0.01, 0.3, 0.02, 0.05, 0.1, 0.2}, 2))
            for (const Input& input :
                 {randomMap(size, density),
                  photographOfDensity(settings.data, "board.jpg", size, density)})
            {
                std::vector<Call> calls = detections(input, {Kind::DETECT, Kind::UNPRUNED});
                append(calls,
                       {fastHoughTransform(input), fastLineDetector(input), houghLinesP(input)});
                std::vector<std::string> steps = {"1 deg", "0.1 deg"};
                if (size.width <= 512)
                    steps.push_back("1/(2n)");
                for (const std::string& step : steps)
                    append(calls, everyHoughLines(settings, newer, input, step, input.threshold));
                timeInTurn("densities", input, calls, settings, recorder);
            }
}

void timeThreads(const Settings& settings, Recorder& recorder)
{
    for (const cv::Size size : photographSizes(settings))
        for (const std::string& name : photographNames(settings))
        {
            const Input input = photograph(settings.data, name, size);
            const std::vector<Call> one = {
                detection(input, Kind::DETECT), detection(input, Kind::UNPRUNED),
                dropIn(input, "1 deg", input.threshold), fastHoughTransform(input),
                houghLines(input, "1 deg", input.threshold)};
            std::vector<Call> calls;
            for (int threads = 1; threads <= settings.threads; threads *= 2)
                for (Call call : one)
                {
                    call.threads = threads;
                    calls.push_back(call);
                }
            timeInTurn("threads", input, calls, settings, recorder);
        }
}

void timeInstructionSets(const Settings& settings, Recorder& recorder)
{
    std::vector<std::pair<InstructionSet, std::shared_ptr<ChildProcess>>> helpers;
    for (const InstructionSet& set : instructionSets())
    {
        helpers.push_back({set, onInstructionSet(settings, set)});
        std::cerr << "A process really runs " << set.name << "\n";
    }
    for (const cv::Size size : photographSizes(settings))
        for (const std::string& name : photographNames(settings))
        {
            const Input input = photograph(settings.data, name, size);
            std::vector<Call> calls;
            for (const Kind kind : {Kind::DETECT, Kind::UNPRUNED})
                for (const auto& helper : helpers)
                    calls.push_back(
                        helperDetection(helper.second, settings, helper.first, input, kind));
            timeInTurn("instruction-sets", input, calls, settings, recorder);
        }
}

void measureMemory(const Settings& settings)
{
    CsvFile file(settings.output + "/memory.csv", "image,width,height,bytes");
    std::vector<cv::Size> sizes = photographSizes(settings);
    if (!settings.quick)
        sizes.push_back({4096, 4096});
    for (const cv::Size size : sizes)
    {
        const Input input = photograph(settings.data, "building.jpg", size);
        cv::setNumThreads(1);
        const auto detect = [&]
        {
            std::vector<cv::Vec3f> lines;
            cv::linespace::LineSpaceDetector::create(input.threshold, 100)
                ->detect(input.edges, lines);
        };
        file.row(input.name, size.width, size.height, 1024. * measure::riseOfPeakMemory(detect));
    }
    file.close();
}

} // namespace benchmark
