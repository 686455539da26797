// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Any parameters and any small image: the CPU path gives the reference's tables at every level and
// the reference's lines, or both refuse with a cv::Exception.

#include "fuzz_image.hpp"

#include <opencv2/linespace.hpp>

#include <vector>

namespace ls = cv::linespace;

namespace {

struct Outcome
{
    bool refused;
    std::vector<cv::Mat> levels;
    std::vector<cv::Vec3f> lines;
};

Outcome run(int backend, const std::vector<uint8_t>& bytes)
{
    FuzzedDataProvider data(bytes.data(), bytes.size());
    Outcome outcome;
    outcome.refused = false;
    try
    {
        const int threshold = data.ConsumeIntegralInRange(-2, 60),
                  most = data.ConsumeIntegralInRange(-2, 20);
        const int method = data.ConsumeIntegralInRange(-1, 3),
                  cellSize = data.ConsumeIntegralInRange(1, 66);
        cv::Ptr<ls::LineSpaceDetector> detector =
            ls::LineSpaceDetector::create(threshold, most, method, cellSize, backend);
        detector->setSuppression(data.ConsumeIntegralInRange(-1, 3));
        detector->setSuppressionRadius(data.ConsumeIntegralInRange(-1, 66));
        detector->setSuppressionDistance(data.ConsumeFloatingPoint<double>());
        detector->setSelection(data.ConsumeIntegralInRange(-1, 2));
        detector->setRefine(data.ConsumeIntegralInRange(-1, 2));
        detector->setCandidateRatio(data.ConsumeProbability<double>());
        detector->setPoolSize(data.ConsumeIntegralInRange(0, 5000));
        detector->setEdgeWeights(data.ConsumeBool());
        const double from = data.ConsumeFloatingPointInRange<double>(-10, 10);
        detector->setAngleRange(from, from + data.ConsumeFloatingPointInRange<double>(-1, 10));
        detector->setFalseAlarms(data.ConsumeFloatingPoint<double>());
        const cv::Mat image = fuzzImage(data);
        if (data.ConsumeBool())
            detector->setMask(image.clone());
        if (data.ConsumeBool())
        {
            detector->setOrientationTolerance(data.ConsumeFloatingPointInRange<double>(-1, 91));
            const int type = data.ConsumeBool() ? CV_16SC1 : CV_32FC1;
            const cv::Mat dx = fuzzGradient(data, image.size(), type),
                          dy = fuzzGradient(data, image.size(), type);
            detector->detect(image, dx, dy, outcome.lines);
        }
        else
            detector->detect(image, outcome.lines);
        for (int level = 0; level < detector->getLevelCount(); ++level)
        {
            cv::Mat table;
            detector->computeLevel(image, level, table);
            outcome.levels.push_back(table);
        }
    }
    catch (const cv::Exception&)
    {
        outcome.refused = true;
    }
    return outcome;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size)
{
    cv::setNumThreads(2);
    const std::vector<uint8_t> input(bytes, bytes + size);
    const Outcome expected = run(ls::BACKEND_REFERENCE, input),
                  actual = run(ls::BACKEND_CPU, input);
    require(expected.refused == actual.refused, "one back end refuses");
    require(expected.levels.size() == actual.levels.size(), "number of levels");
    for (size_t i = 0; i < expected.levels.size(); ++i)
        require(cv::norm(expected.levels[i], actual.levels[i], cv::NORM_INF) == 0,
                "votes of a level");
    require(expected.lines == actual.lines, "lines");
    return 0;
}
