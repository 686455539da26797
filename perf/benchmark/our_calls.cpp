// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "calls.hpp"

#include "common/stopwatch.hpp"

#include "opencv2/linespace.hpp"

#include <algorithm>

namespace benchmark {

namespace {

namespace ls = cv::linespace;

using Lines = std::vector<cv::Vec3f>;

const int mostLines = 100;

const char* nameOf(Kind kind)
{
    switch (kind)
    {
    case Kind::UNPRUNED: return "Line Space unpruned";
    case Kind::NEW: return "Line Space first call";
    case Kind::EXACT: return "Line Space exact";
    default: return "Line Space";
    }
}

cv::Ptr<ls::LineSpaceDetector> detectorFor(const Input& input, Kind kind, int backend)
{
    const auto detector = ls::LineSpaceDetector::create(
        input.threshold, mostLines, kind == Kind::EXACT ? ls::METHOD_EXACT : ls::METHOD_CASCADED, 8,
        backend);
    detector->setPruning(kind != Kind::UNPRUNED);
    return detector;
}

Lines referenceLines(const Input& input, Kind kind)
{
    Lines lines;
    detectorFor(input, kind, ls::BACKEND_REFERENCE)->detect(input.edges, lines);
    return lines;
}

std::vector<Stage> stagesOf(const ls::LineSpaceDetector& detector)
{
    std::vector<cv::String> names;
    std::vector<double> milliseconds;
    detector.getStageTimes(names, milliseconds);
    std::vector<Stage> stages;
    for (std::size_t i = 0; i < names.size(); ++i)
        stages.push_back({names[i], milliseconds[i]});
    return stages;
}

Call detection(const Input& input, Kind kind, int backend,
               const std::shared_ptr<const Lines>& expected)
{
    const auto kept = detectorFor(input, kind, backend);
    const std::string name = backend == ls::BACKEND_OPENGL ? "OpenGL " : "";
    return {name + nameOf(kind), [=]
            {
                auto detector = kept;
                Lines lines;
                const double milliseconds = measure::millisecondsOf(
                    [&]
                    {
                        if (kind == Kind::NEW)
                            detector = detectorFor(input, kind, backend);
                        detector->detect(input.edges, lines);
                    });
                return Outcome{milliseconds, (int)lines.size(), lines == *expected,
                               stagesOf(*detector)};
            }};
}

std::vector<Call> detections(const Input& input, const std::vector<Kind>& kinds, int backend)
{
    const auto expected = std::make_shared<const Lines>(referenceLines(input, Kind::DETECT));
    std::vector<Call> calls;
    for (const Kind kind : kinds)
        calls.push_back(
            detection(input, kind, backend,
                      kind == Kind::EXACT
                          ? std::make_shared<const Lines>(referenceLines(input, kind))
                          : expected));
    return calls;
}

//! Of the drop-in, by the back end that is set for the whole process.
std::vector<cv::Vec2f> dropInLines(const cv::Mat1b& edges, double theta, int threshold)
{
    std::vector<cv::Vec2f> lines;
    ls::HoughLines(edges, lines, 1, theta, threshold);
    return lines;
}

} // namespace

Call detection(const Input& input, Kind kind)
{
    return detections(input, {kind}).front();
}

std::vector<Call> detections(const Input& input, const std::vector<Kind>& kinds)
{
    return detections(input, kinds, ls::BACKEND_CPU);
}

bool isOpenGlThere()
{
    try
    {
        Lines lines;
        ls::LineSpaceDetector::create(1, 0, ls::METHOD_CASCADED, 8, ls::BACKEND_OPENGL)
            ->detect(cv::Mat1b(1, 1, uchar(1)), lines);
        return true;
    }
    catch (const cv::Exception&)
    {
        return false;
    }
}

std::vector<Call> openGlDetections(const Input& input, const std::vector<Kind>& kinds)
{
    return detections(input, kinds, ls::BACKEND_OPENGL);
}

double angleStep(const std::string& step, cv::Size size)
{
    return step == "1 deg"     ? CV_PI / 180
           : step == "0.1 deg" ? CV_PI / 1800
                               : 0.5 / std::max(size.width, size.height);
}

Call dropIn(const Input& input, const std::string& step, int threshold)
{
    const double theta = angleStep(step, input.edges.size());
    const int before = ls::getDefaultBackend();
    ls::setDefaultBackend(ls::BACKEND_REFERENCE);
    const auto expected =
        std::make_shared<const std::vector<cv::Vec2f>>(dropInLines(input.edges, theta, threshold));
    ls::setDefaultBackend(before);
    return {"drop-in " + step, [=]
            {
                std::vector<cv::Vec2f> lines;
                const double milliseconds = measure::millisecondsOf(
                    [&] { lines = dropInLines(input.edges, theta, threshold); });
                return Outcome{milliseconds, (int)lines.size(), lines == *expected, {}};
            }};
}

} // namespace benchmark
