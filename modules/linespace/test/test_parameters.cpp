// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// LineSpaceDetector as a cv::Algorithm: parameters, storage, state; and the process-wide default
// back end.

#include "test_precomp.hpp"

#include "generators.hpp"
#include "test_support.hpp"

#include <cstdio>
#include <fstream>
#include <numeric>

namespace opencv_test {
namespace {

using namespace generators;

//! Everything that can be set and is stored, as text, so that two detectors compare in one go.
std::string describe(const LineSpaceDetector& detector)
{
    double minTheta = 0, maxTheta = 0;
    detector.getAngleRange(minTheta, maxTheta);
    std::ostringstream out;
    out.precision(17);
    out << "threshold " << detector.getThreshold() << ", maxLines " << detector.getMaxLines()
        << ", method " << detector.getMethod() << ", cellSize " << detector.getCellSize()
        << ", backend " << detector.getBackend() << ", suppression " << detector.getSuppression()
        << ", radius " << detector.getSuppressionRadius() << ", distance "
        << detector.getSuppressionDistance() << ", refine " << detector.getRefine()
        << ", selection " << detector.getSelection() << ", ratio " << detector.getCandidateRatio()
        << ", pool " << detector.getPoolSize() << ", range " << minTheta << " " << maxTheta
        << ", tolerance " << detector.getOrientationTolerance() << ", falseAlarms "
        << detector.getFalseAlarms() << ", weights " << detector.getEdgeWeights() << ", pruning "
        << detector.getPruning() << ", memory " << detector.getMemoryLimit();
    return out.str();
}

//! Every parameter away from its default.
void setEverything(LineSpaceDetector& detector)
{
    detector.setThreshold(17);
    detector.setMaxLines(23);
    detector.setMethod(METHOD_EXACT);
    detector.setCellSize(11);
    detector.setBackend(BACKEND_REFERENCE);
    detector.setSuppression(SUPPRESS_GREEDY);
    detector.setSuppressionRadius(5);
    detector.setSuppressionDistance(1.0 / 3);
    detector.setRefine(REFINE_NONE);
    detector.setSelection(SELECT_EXPLAIN);
    detector.setCandidateRatio(0.1);
    detector.setPoolSize(99);
    detector.setAngleRange(-1.0 / 7, 2.0 / 3);
    detector.setOrientationTolerance(100.0 / 7);
    detector.setFalseAlarms(1e-3);
    detector.setEdgeWeights(true);
    detector.setPruning(false);
    detector.setMemoryLimit(123);
}

TEST(Linespace_Parameters, defaults)
{
    const Ptr<LineSpaceDetector> detector = LineSpaceDetector::create();
    double minTheta = 1, maxTheta = 0;
    detector->getAngleRange(minTheta, maxTheta);
    EXPECT_EQ(0, detector->getThreshold());
    EXPECT_EQ(0, detector->getMaxLines());
    EXPECT_EQ(METHOD_CASCADED, detector->getMethod());
    EXPECT_EQ(8, detector->getCellSize());
    EXPECT_EQ(BACKEND_AUTO, detector->getBackend());
    EXPECT_EQ(SUPPRESS_RING, detector->getSuppression());
    EXPECT_EQ(2, detector->getSuppressionRadius());
    EXPECT_EQ(3, detector->getSuppressionDistance());
    EXPECT_EQ(REFINE_LEAST_SQUARES, detector->getRefine());
    EXPECT_EQ(SELECT_PEAKS, detector->getSelection());
    EXPECT_EQ(0.75, detector->getCandidateRatio());
    EXPECT_EQ(8192, detector->getPoolSize());
    EXPECT_EQ(0, minTheta);
    EXPECT_EQ(CV_PI, maxTheta);
    EXPECT_EQ(22.5, detector->getOrientationTolerance());
    EXPECT_EQ(1, detector->getFalseAlarms());
    EXPECT_FALSE(detector->getEdgeWeights());
    EXPECT_TRUE(detector->getPruning());
    EXPECT_EQ(8192, detector->getMemoryLimit());
    Mat mask;
    detector->getMask(mask);
    EXPECT_TRUE(mask.empty());
}

TEST(Linespace_Parameters, create_and_set)
{
    const Ptr<LineSpaceDetector> created =
        LineSpaceDetector::create(7, 9, METHOD_EXACT, 64, BACKEND_REFERENCE);
    EXPECT_EQ(7, created->getThreshold());
    EXPECT_EQ(9, created->getMaxLines());
    EXPECT_EQ(METHOD_EXACT, created->getMethod());
    EXPECT_EQ(64, created->getCellSize());
    EXPECT_EQ(BACKEND_REFERENCE, created->getBackend());

    const Ptr<LineSpaceDetector> detector = LineSpaceDetector::create();
    setEverything(*detector);
    EXPECT_EQ(
        "threshold 17, maxLines 23, method 0, cellSize 11, backend 1, suppression 2, radius 5, "
        "distance 0.33333333333333331, refine 0, selection 1, ratio 0.10000000000000001, pool 99, "
        "range "
        "-0.14285714285714285 0.66666666666666663, tolerance 14.285714285714286, falseAlarms "
        "0.001, weights 1, pruning 0, memory 123",
        describe(*detector));
}

// The ends of every range are allowed.
TEST(Linespace_Parameters, ends_of_the_ranges)
{
    const Ptr<LineSpaceDetector> detector =
        LineSpaceDetector::create(INT_MAX, INT_MAX, METHOD_CASCADED, 2);
    EXPECT_NO_THROW(detector->setThreshold(0));
    EXPECT_NO_THROW(detector->setMaxLines(0));
    EXPECT_NO_THROW(detector->setCellSize(64));
    EXPECT_NO_THROW(detector->setSuppressionRadius(0));
    EXPECT_NO_THROW(detector->setSuppressionRadius(64));
    EXPECT_NO_THROW(detector->setSuppressionDistance(0));
    EXPECT_NO_THROW(detector->setCandidateRatio(0));
    EXPECT_NO_THROW(detector->setCandidateRatio(1));
    EXPECT_NO_THROW(detector->setPoolSize(1));
    EXPECT_NO_THROW(detector->setPoolSize(INT_MAX));
    EXPECT_NO_THROW(detector->setAngleRange(2, 2));
    EXPECT_NO_THROW(detector->setAngleRange(-1e6, 1e6));
    EXPECT_NO_THROW(detector->setOrientationTolerance(DBL_MIN));
    EXPECT_NO_THROW(detector->setOrientationTolerance(90));
    EXPECT_NO_THROW(detector->setFalseAlarms(DBL_MIN));
    EXPECT_NO_THROW(detector->setMemoryLimit(1));
    EXPECT_NO_THROW(detector->setMemoryLimit(INT_MAX));
}

//! The stages of the last call, as one text.
std::string stagesOf(const LineSpaceDetector& detector)
{
    std::vector<String> stages;
    std::vector<double> milliseconds;
    detector.getStageTimes(stages, milliseconds);
    EXPECT_EQ(stages.size(), milliseconds.size());
    std::string all;
    for (size_t i = 0; i < stages.size(); ++i)
    {
        all += (i > 0 ? ", " : "") + stages[i];
        EXPECT_GE(milliseconds[i], 0);
    }
    return all;
}

TEST(Linespace_StageTimes, stages_of_the_last_call)
{
    const Mat edges = randomEdges(Size(64, 32), 0.1, 3);
    const Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(10);
    EXPECT_EQ("", stagesOf(*detector));
    std::vector<Vec3f> lines;
    detector->setPruning(false);
    detector->detect(edges, lines);
    EXPECT_EQ("edge map, level 0, level 1, level 2, level 3, level 4, level 5, candidates, ascent, "
              "selection",
              stagesOf(*detector));
    Mat table;
    detector->computeLevel(edges, 1, table);
    EXPECT_EQ("edge map, level 0, level 1", stagesOf(*detector));
    detector->setMethod(METHOD_EXACT);
    detector->detect(edges, lines);
    EXPECT_EQ("edge map, level 0, candidates, selection", stagesOf(*detector));
    detector->clear();
    EXPECT_EQ("", stagesOf(*detector));
}

// Their sum is the time of the call, but for what is around them.
TEST(Linespace_StageTimes, sum)
{
    const Mat edges = randomEdges(Size(512, 512), 0.1, 3);
    const Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(60);
    std::vector<Vec3f> lines;
    double best = 0;
    for (int i = 0; i < 5; ++i) // another program may hold it up between two stages
    {
        const int64 start = getTickCount();
        detector->detect(edges, lines);
        const double whole = (double)(getTickCount() - start) * 1e3 / getTickFrequency();
        std::vector<String> stages;
        std::vector<double> milliseconds;
        detector->getStageTimes(stages, milliseconds);
        const double sum = std::accumulate(milliseconds.begin(), milliseconds.end(), 0.);
        EXPECT_LE(sum, whole);
        best = std::max(best, sum / whole);
    }
    EXPECT_GE(best, 0.9);
}

TEST(Linespace_Storage, write_and_read)
{
    const Ptr<LineSpaceDetector> written = LineSpaceDetector::create(),
                                 read = LineSpaceDetector::create();
    setEverything(*written);
    const char* formats[] = {".xml", ".yml", ".json"};
    for (int i = 0; i < 3; ++i)
    {
        FileStorage out(formats[i], FileStorage::WRITE | FileStorage::MEMORY);
        written->write(out);
        const std::string text = out.releaseAndGetString();
        FileStorage in(text, FileStorage::READ | FileStorage::MEMORY);
        read->read(in.root());
        EXPECT_EQ(describe(*written), describe(*read)) << text;
    }
}

TEST(Linespace_Storage, save_and_load)
{
    const Ptr<LineSpaceDetector> saved = LineSpaceDetector::create();
    setEverything(*saved);
    EXPECT_FALSE(saved->getDefaultName().empty());
    const std::string file = cv::tempfile(".xml"), other = cv::tempfile(".yml");
    saved->save(other);
    // load() gives no detector at all if empty() is true after reading.
    const Ptr<LineSpaceDetector> fromYaml = Algorithm::load<LineSpaceDetector>(other);
    ASSERT_FALSE(fromYaml.empty());
    EXPECT_EQ(describe(*saved), describe(*fromYaml));
    std::remove(other.c_str());
    saved->save(file);
    const Ptr<LineSpaceDetector> loaded = Algorithm::load<LineSpaceDetector>(file);
    ASSERT_FALSE(loaded.empty());
    EXPECT_EQ(describe(*saved), describe(*loaded));

    std::ifstream stream(file.c_str());
    const std::string text((std::istreambuf_iterator<char>(stream)),
                           std::istreambuf_iterator<char>());
    EXPECT_NE(std::string::npos, text.find("<" + saved->getDefaultName() + ">")) << text;
    const Ptr<LineSpaceDetector> parsed = Algorithm::loadFromString<LineSpaceDetector>(text);
    ASSERT_FALSE(parsed.empty());
    EXPECT_EQ(describe(*saved), describe(*parsed));

    // Cut off: an exception, not half a detector.
    std::ofstream(file.c_str()) << text.substr(0, text.size() / 2);
    EXPECT_THROW(Algorithm::load<LineSpaceDetector>(file), cv::Exception);
    std::remove(file.c_str());
}

// A stored value that no setter would take is refused, and the reader stays as it was.
TEST(Linespace_Storage, bad_values_are_refused)
{
    const Ptr<LineSpaceDetector> written = LineSpaceDetector::create();
    FileStorage out(".yml", FileStorage::WRITE | FileStorage::MEMORY);
    written->write(out);
    const std::string text = out.releaseAndGetString();
    FileStorage stored(text, FileStorage::READ | FileStorage::MEMORY);
    const FileNode root = stored.root();
    int refused = 0;
    for (FileNodeIterator it = root.begin(); it != root.end(); ++it)
    {
        const std::string key = (*it).name();
        // Any real angle is allowed, for a bool anything is something; format is OpenCV's.
        if (!((*it).isInt() || (*it).isReal()) || key.find("heta") != std::string::npos ||
            key.find("eights") != std::string::npos || key == "pruning" || key == "format")
            continue;
        FileStorage changed(".yml", FileStorage::WRITE | FileStorage::MEMORY);
        for (FileNodeIterator other = root.begin(); other != root.end(); ++other)
        {
            const std::string name = (*other).name();
            if (name == key)
                changed << name << -12345;
            else if ((*other).isInt())
                changed << name << (int)*other;
            else if ((*other).isReal())
                changed << name << (double)*other;
            else if ((*other).isString())
                changed << name << (std::string)*other;
        }
        const Ptr<LineSpaceDetector> reader = LineSpaceDetector::create();
        setEverything(*reader);
        const std::string before = describe(*reader);
        FileStorage in(changed.releaseAndGetString(), FileStorage::READ | FileStorage::MEMORY);
        EXPECT_EQ("", wrongException([&]() { reader->read(in.root()); }, {"-12345"})) << key;
        EXPECT_EQ(before, describe(*reader)) << key;
        ++refused;
    }
    EXPECT_GE(refused, 12) << text;
}

TEST(Linespace_State, before_and_after)
{
    const Ptr<LineSpaceDetector> detector =
        LineSpaceDetector::create(5, 0, METHOD_CASCADED, 4, BACKEND_CPU);
    setEverything(*detector);
    detector->setMethod(METHOD_CASCADED);
    detector->setBackend(BACKEND_CPU);
    const std::string parameters = describe(*detector);
    const Mat1b edges = randomEdges(Size(50, 41), 0.3, 1);
    for (int round = 0; round < 2; ++round)
    {
        EXPECT_EQ(Size(), detector->getFrameSize());
        EXPECT_EQ(0, detector->getLevelCount());
        EXPECT_EQ(-1, detector->getActiveBackend());
        EXPECT_THROW(detector->getLevelCellSize(0), cv::Exception);
        EXPECT_THROW(detector->getLevelGridSize(0), cv::Exception);

        std::vector<Vec3f> lines;
        detector->detect(edges, lines);
        const Size frame = detector->getFrameSize();
        const int count = detector->getLevelCount();
        EXPECT_GE(frame.width, 50);
        EXPECT_GE(frame.height, 41);
        EXPECT_GT(count, 1);
        EXPECT_EQ(BACKEND_CPU, detector->getActiveBackend());
        EXPECT_EQ(frame, detector->getLevelCellSize(count - 1));
        EXPECT_EQ(Size(1, 1), detector->getLevelGridSize(count - 1));
        EXPECT_THROW(detector->getLevelCellSize(count), cv::Exception);
        EXPECT_THROW(detector->getLevelGridSize(-1), cv::Exception);
        // Of the last call, whatever is set since.
        detector->setMethod(METHOD_EXACT);
        EXPECT_EQ(count, detector->getLevelCount());
        detector->setMethod(METHOD_CASCADED);

        detector->clear();
        EXPECT_EQ(parameters, describe(*detector))
            << "clear() forgets the plan, not the parameters";
    }
}

TEST(Linespace_State, default_back_end)
{
    ASSERT_EQ(BACKEND_AUTO, getDefaultBackend());
    const Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(5);
    const Mat1b edges = randomEdges(Size(30, 20), 0.3, 1);
    const int backends[] = {BACKEND_REFERENCE, BACKEND_CPU};
    for (int i = 0; i < 2; ++i)
    {
        setDefaultBackend(backends[i]);
        EXPECT_EQ(backends[i], getDefaultBackend());
        std::vector<Vec3f> lines;
        detector->detect(edges, lines);
        EXPECT_EQ(backends[i], detector->getActiveBackend());
        EXPECT_EQ(BACKEND_AUTO, detector->getBackend());
    }
    const int bad[] = {-1, 5, INT_MAX};
    for (int i = 0; i < 3; ++i)
    {
        EXPECT_EQ("", wrongException([&]() { setDefaultBackend(bad[i]); },
                                     {"backend", format("%d", bad[i])}));
        EXPECT_EQ(BACKEND_CPU, getDefaultBackend());
    }
    setDefaultBackend(BACKEND_AUTO);
    std::vector<Vec3f> lines;
    detector->detect(edges, lines);
    EXPECT_EQ(BACKEND_CPU, detector->getActiveBackend());
}

// A device that cannot run says so before it writes anything; one that runs gives the same lines.
TEST(Linespace_State, device_back_ends)
{
    const Mat1b edges = randomEdges(Size(60, 50), 0.2, 1);
    std::vector<Vec3f> expected;
    LineSpaceDetector::create(15, 0, METHOD_CASCADED, 8, BACKEND_CPU)->detect(edges, expected);
    const int backends[] = {BACKEND_OPENCL, BACKEND_OPENGL};
    for (int i = 0; i < 2; ++i)
    {
        const Vec3f sentinel(1, 2, 3);
        std::vector<Vec3f> lines(2, sentinel);
        try
        {
            const Ptr<LineSpaceDetector> detector =
                LineSpaceDetector::create(15, 0, METHOD_CASCADED, 8, backends[i]);
            detector->detect(edges, lines);
            EXPECT_EQ(backends[i], detector->getActiveBackend());
            EXPECT_EQ(expected, lines);
            std::cout << "back end " << backendName(backends[i]) << " runs" << std::endl;
        }
        catch (const cv::Exception& exception)
        {
            std::cout << "back end " << backendName(backends[i])
                      << " does not run: " << exception.err << std::endl;
            EXPECT_EQ(std::vector<Vec3f>(2, sentinel), lines);
        }
    }
}

} // namespace
} // namespace opencv_test
