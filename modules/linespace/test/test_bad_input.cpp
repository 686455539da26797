// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Wrong input to LineSpaceDetector: a cv::Exception that names the argument and its value, outputs
// and detector as they were, and the detector works on. HoughLines' own rules are in
// test_houghlines.cpp, sizes in test_limits.cpp.

#include "test_precomp.hpp"

#include "brute_force.hpp"
#include "failing_allocation.hpp"
#include "generators.hpp"
#include "test_support.hpp"

#include <array>
#include <limits>

namespace opencv_test {
namespace {

using namespace generators;

const double notANumber = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

typedef std::vector<Vec3f> Lines;
typedef std::function<void()> Call;
typedef std::vector<std::string> Words;

class Linespace_BadInput : public testing::TestWithParam<tuple<int, int>> // back end, method
{
protected:
    void SetUp() CV_OVERRIDE
    {
        detector = LineSpaceDetector::create(8, 0, get<1>(GetParam()), 3, get<0>(GetParam()));
        good = randomEdges(Size(40, 31), 0.3, 1);
        detector->detect(good, expected);
        ASSERT_FALSE(expected.empty());
    }

    //! Every call that takes edges throws, and nothing else happens.
    void expectRefused(InputArray edges, const Words& words)
    {
        const Vec3f sentinel(1, 2, 3);
        Lines lines(2, sentinel);
        Mat table(2, 2, CV_32SC1, Scalar(77));
        const Mat before = table.clone();
        const Size frame = detector->getFrameSize();
        const int levels = detector->getLevelCount(), active = detector->getActiveBackend();
        EXPECT_EQ("", wrongException([&]() { detector->detect(edges, lines); }, words));
        EXPECT_EQ("", wrongException([&]() { detector->compute(edges, table); }, words));
        EXPECT_EQ("", wrongException([&]() { detector->computeLevel(edges, 0, table); }, words));
        EXPECT_EQ(Lines(2, sentinel), lines);
        ASSERT_EQ(before.size(), table.size());
        EXPECT_EQ(0, cvtest::norm(table, before, NORM_INF));
        EXPECT_EQ(frame, detector->getFrameSize());
        EXPECT_EQ(levels, detector->getLevelCount());
        EXPECT_EQ(active, detector->getActiveBackend());
    }

    void expectWorksOn()
    {
        Lines lines;
        detector->detect(good, lines);
        EXPECT_EQ(expected, lines);
    }

    Ptr<LineSpaceDetector> detector;
    Mat1b good;
    Lines expected;
};

TEST_P(Linespace_BadInput, edges)
{
    expectRefused(Mat(), {"edges"});
    expectRefused(Mat(0, 5, CV_8UC1), {"edges"});
    expectRefused(noArray(), {"edges"});
    expectRefused(UMat(), {"edges"});
    const int types[] = {CV_8SC1,  CV_16UC1, CV_16SC1, CV_32SC1, CV_32FC1,
                         CV_64FC1, CV_8UC2,  CV_8UC3,  CV_8UC4};
    for (size_t i = 0; i < sizeof(types) / sizeof(types[0]); ++i)
    {
        expectRefused(Mat(9, 9, types[i], Scalar::all(1)), {"edges", typeToString(types[i])});
        expectRefused(UMat(9, 9, types[i], Scalar::all(1)), {"edges", typeToString(types[i])});
    }
    const int sizes[] = {4, 5, 6};
    expectRefused(Mat(3, sizes, CV_8UC1, Scalar(1)), {"edges"});
    expectWorksOn();
}

// From OpenCV 5 on a vector has one dimension: it is an image of one row as before.
TEST_P(Linespace_BadInput, vectors_are_images_of_one_row)
{
    const std::vector<uchar> row(60, (uchar)1), mask(60, (uchar)1);
    const std::vector<short> dx(60, (short)0), dy(60, (short)100);
    Mat rowAsMat(1, 60, CV_8UC1, Scalar(1)), dxAsMat(1, 60, CV_16SC1, Scalar(0)),
        dyAsMat(1, 60, CV_16SC1, Scalar(100));
    detector->setMask(mask);
    Lines vectors, images;
    detector->detect(row, vectors);
    detector->detect(rowAsMat, images);
    EXPECT_EQ(images, vectors);
    detector->detect(row, dx, dy, vectors);
    detector->detect(rowAsMat, dxAsMat, dyAsMat, images);
    EXPECT_EQ(images, vectors);
    EXPECT_FALSE(images.empty());
    Mat table, sameTable;
    detector->compute(row, table);
    detector->compute(rowAsMat, sameTable);
    EXPECT_EQ(0, cvtest::norm(table, sameTable, NORM_INF));
}

TEST_P(Linespace_BadInput, mask)
{
    detector->setMask(Mat1b(good.size(), (uchar)1));
    EXPECT_EQ(
        "", wrongException([&]() { detector->setMask(Mat1f(good.size())); }, {"mask", "CV_32FC1"}));
    EXPECT_EQ("", wrongException([&]() { detector->setMask(Mat(good.size(), CV_8UC3)); },
                                 {"mask", "CV_8UC3"}));
    expectWorksOn(); // with the mask it had
    detector->setMask(Mat1b(31, 41, (uchar)1));
    expectRefused(good, {"mask", "41", "31"});
    detector->setMask(Mat1b(30, 40, (uchar)1));
    expectRefused(good, {"mask", "40", "30"});
    detector->setMask(noArray());
    expectWorksOn();
}

TEST_P(Linespace_BadInput, level)
{
    Mat table(2, 2, CV_32SC1, Scalar(77));
    const Mat before = table.clone();
    const int levels[] = {-1, detector->getLevelCount(), INT_MAX, INT_MIN};
    for (int i = 0; i < 4; ++i)
    {
        const Words words = {"level", format("%d", levels[i])};
        EXPECT_EQ("",
                  wrongException([&]() { detector->computeLevel(good, levels[i], table); }, words));
        EXPECT_EQ("", wrongException([&]() { detector->getLevelCellSize(levels[i]); }, words));
        EXPECT_EQ("", wrongException([&]() { detector->getLevelGridSize(levels[i]); }, words));
    }
    EXPECT_EQ(0, cvtest::norm(table, before, NORM_INF));
    expectWorksOn();
}

TEST_P(Linespace_BadInput, types_of_outputs)
{
    std::vector<Vec2f> pairs(2, Vec2f(1, 2));
    Mat1b bytes(2, 2, (uchar)5);
    const Mat before = bytes.clone();
    const Size frame = detector->getFrameSize();
    const Mat1b larger = randomEdges(Size(60, 50), 0.3, 2);
    EXPECT_EQ("", wrongException([&]() { detector->detect(larger, pairs); }, Words()));
    EXPECT_EQ("", wrongException([&]() { detector->compute(larger, bytes); }, Words()));
    EXPECT_EQ(frame, detector->getFrameSize()) << "the detector changed";
    EXPECT_EQ("", wrongException([&]() { detector->detect(good, pairs); }, Words()));
    EXPECT_EQ("", wrongException([&]() { detector->detect(good, bytes); }, Words()));
    EXPECT_EQ("", wrongException([&]() { detector->compute(good, bytes); }, Words()));
    EXPECT_EQ("", wrongException([&]() { detector->computeLevel(good, 0, bytes); }, Words()));
    EXPECT_EQ(std::vector<Vec2f>(2, Vec2f(1, 2)), pairs);
    ASSERT_EQ(before.size(), bytes.size());
    EXPECT_EQ(0, cvtest::norm(bytes, before, NORM_INF));
    expectWorksOn();
}

// Whether an output can take the result shows when everything is computed.
TEST_P(Linespace_BadInput, sizes_of_outputs)
{
    Lines deviations, deviationsAfter;
    detector->getDeviations(deviations);
    const Size frame = detector->getFrameSize();
    const Mat1b larger = randomEdges(Size(60, 50), 0.3, 2);
    std::array<Vec3f, 1> oneLine = {{Vec3f(1, 2, 3)}};
    Matx<int, 2, 2> smallTable(1, 2, 3, 4);
    const Mat1b images[] = {larger, good};
    for (const Mat1b& image : images)
    {
        EXPECT_EQ("", wrongException([&]() { detector->detect(image, oneLine); }, Words()));
        EXPECT_EQ("", wrongException([&]() { detector->compute(image, smallTable); }, Words()));
        EXPECT_EQ("",
                  wrongException([&]() { detector->computeLevel(image, 0, smallTable); }, Words()));
        EXPECT_EQ(frame, detector->getFrameSize());
        detector->getDeviations(deviationsAfter);
        EXPECT_EQ(deviations, deviationsAfter);
    }
    EXPECT_EQ(Vec3f(1, 2, 3), oneLine[0]);
    EXPECT_EQ(4, smallTable(1, 1));
    expectWorksOn();
    Ptr<LineSpaceDetector> fresh =
        LineSpaceDetector::create(8, 0, get<1>(GetParam()), 3, get<0>(GetParam()));
    EXPECT_EQ("", wrongException([&]() { fresh->detect(good, oneLine); }, Words()));
    EXPECT_EQ(0, fresh->getLevelCount());
    EXPECT_EQ(-1, fresh->getActiveBackend());
}

// The n-th large allocation of a call fails, for every n.
TEST_P(Linespace_BadInput, failed_allocation)
{
    if (get<0>(GetParam()) == BACKEND_OPENCL)
        return; // its allocations also fail, and PoCL then ends the process
    if (!canFailAllocations())
        throw SkipTestException("no allocator that can be replaced");
    ThreadCount one(1); // whose allocation fails is then the same on every run
    failAllocationAfter(0);
    EXPECT_THROW(Mat(64, 64, CV_8UC1), cv::Exception) << "those of OpenCV fail too";
    failAllocationAfter(-1);
    Mat fullTable;
    detector->compute(good, fullTable);
    const Mat dx(good.size(), CV_32FC1, Scalar(2)), dy(good.size(), CV_32FC1, Scalar(-3));
    for (int call = 0; call < 4; ++call)
    {
        bool succeeded = false;
        int failures = 0;
        for (int n = 0; n < 2000 && !succeeded; ++n)
        {
            Ptr<LineSpaceDetector> fresh =
                LineSpaceDetector::create(8, 0, get<1>(GetParam()), 3, get<0>(GetParam()));
            const Vec3f sentinel(1, 2, 3);
            Lines lines(2, sentinel);
            Mat table(fullTable.size(), CV_32SC1, Scalar(77));
            failAllocationAfter(n);
            const std::string wrong = wrongException(
                [&]()
                {
                    if (call == 0)
                        fresh->detect(good, lines);
                    else if (call == 1)
                        fresh->compute(good, table);
                    else if (call == 2)
                        fresh->detect(good, dx, dy, lines);
                    else
                        fresh->detect(good, noArray(), noArray(), lines);
                },
                Words());
            failAllocationAfter(-1);
            succeeded = wrong == "no exception";
            if (!succeeded)
            {
                ++failures;
                ASSERT_EQ("", wrong) << "allocation " << n;
                ASSERT_EQ(Lines(2, sentinel), lines) << "allocation " << n;
                ASSERT_EQ(
                    0, cvtest::norm(table, Mat(fullTable.size(), CV_32SC1, Scalar(77)), NORM_INF))
                    << "allocation " << n;
                ASSERT_EQ(-1, fresh->getActiveBackend()) << "allocation " << n;
                ASSERT_EQ(0, fresh->getLevelCount()) << "allocation " << n;
            }
            fresh->detect(good, lines);
            ASSERT_EQ(expected, lines) << "after a failure of allocation " << n;
        }
        EXPECT_TRUE(succeeded);
        EXPECT_GT(failures, 0);
    }
}

INSTANTIATE_TEST_CASE_P(/**/, Linespace_BadInput,
                        testing::Combine(LINESPACE_TEST_BACKENDS,
                                         testing::Values((int)METHOD_EXACT, (int)METHOD_CASCADED)));

TEST(Linespace_BadParameter, create)
{
    const int bad[][5] = {{-1, 0, METHOD_CASCADED, 8, BACKEND_AUTO},
                          {INT_MIN, 0, METHOD_CASCADED, 8, BACKEND_AUTO},
                          {0, -1, METHOD_CASCADED, 8, BACKEND_AUTO},
                          {0, INT_MIN, METHOD_CASCADED, 8, BACKEND_AUTO},
                          {0, 0, 3, 8, BACKEND_AUTO},
                          {0, 0, -1, 8, BACKEND_AUTO},
                          {0, 0, METHOD_CASCADED, 1, BACKEND_AUTO},
                          {0, 0, METHOD_CASCADED, 65, BACKEND_AUTO},
                          {0, 0, METHOD_EXACT, 0, BACKEND_AUTO},
                          {0, 0, METHOD_CASCADED, -8, BACKEND_AUTO},
                          {0, 0, METHOD_CASCADED, 8, 5},
                          {0, 0, METHOD_CASCADED, 8, -1}};
    const char* names[] = {"threshold", "threshold", "maxLines", "maxLines", "method",  "method",
                           "cellSize",  "cellSize",  "cellSize", "cellSize", "backend", "backend"};
    const int values[] = {-1, INT_MIN, -1, INT_MIN, 2, -1, 1, 65, 0, -8, 5, -1};
    for (int i = 0; i < 12; ++i)
    {
        const int* p = bad[i];
        EXPECT_EQ("",
                  wrongException([&]() { LineSpaceDetector::create(p[0], p[1], p[2], p[3], p[4]); },
                                 {names[i], format("%d", values[i])}))
            << i;
    }
}

struct BadSetting
{
    const char* name;
    const char* value; //!< as it must stand in the message; empty for any
    std::function<void(LineSpaceDetector&)> set;
};

TEST(Linespace_BadParameter, setters)
{
    typedef LineSpaceDetector D;
    const std::vector<BadSetting> settings = {{"threshold", "-1",
                                               [](D& d)
                                               {
                                                   d.setThreshold(-1);
                                               }},
                                              {"threshold", "-2147483648",
                                               [](D& d)
                                               {
                                                   d.setThreshold(INT_MIN);
                                               }},
                                              {"maxLines", "-1",
                                               [](D& d)
                                               {
                                                   d.setMaxLines(-1);
                                               }},
                                              {"maxLines", "-2147483648",
                                               [](D& d)
                                               {
                                                   d.setMaxLines(INT_MIN);
                                               }},
                                              {"method", "-1",
                                               [](D& d)
                                               {
                                                   d.setMethod(-1);
                                               }},
                                              {"method", "3",
                                               [](D& d)
                                               {
                                                   d.setMethod(3);
                                               }},
                                              {"cellSize", "1",
                                               [](D& d)
                                               {
                                                   d.setCellSize(1);
                                               }},
                                              {"cellSize", "65",
                                               [](D& d)
                                               {
                                                   d.setCellSize(65);
                                               }},
                                              {"cellSize", "-5",
                                               [](D& d)
                                               {
                                                   d.setCellSize(-5);
                                               }},
                                              {"backend", "-1",
                                               [](D& d)
                                               {
                                                   d.setBackend(-1);
                                               }},
                                              {"backend", "5",
                                               [](D& d)
                                               {
                                                   d.setBackend(5);
                                               }},
                                              {"suppression", "-1",
                                               [](D& d)
                                               {
                                                   d.setSuppression(-1);
                                               }},
                                              {"suppression", "3",
                                               [](D& d)
                                               {
                                                   d.setSuppression(3);
                                               }},
                                              {"adius", "-1",
                                               [](D& d)
                                               {
                                                   d.setSuppressionRadius(-1);
                                               }},
                                              {"adius", "65",
                                               [](D& d)
                                               {
                                                   d.setSuppressionRadius(65);
                                               }},
                                              {"istance", "-0.5",
                                               [](D& d)
                                               {
                                                   d.setSuppressionDistance(-0.5);
                                               }},
                                              {"istance", "nan",
                                               [](D& d)
                                               {
                                                   d.setSuppressionDistance(notANumber);
                                               }},
                                              {"istance", "inf",
                                               [](D& d)
                                               {
                                                   d.setSuppressionDistance(infinity);
                                               }},
                                              {"selection", "-1",
                                               [](D& d)
                                               {
                                                   d.setSelection(-1);
                                               }},
                                              {"selection", "2",
                                               [](D& d)
                                               {
                                                   d.setSelection(2);
                                               }},
                                              {"refine", "-1",
                                               [](D& d)
                                               {
                                                   d.setRefine(-1);
                                               }},
                                              {"refine", "2",
                                               [](D& d)
                                               {
                                                   d.setRefine(2);
                                               }},
                                              {"atio", "-0.25",
                                               [](D& d)
                                               {
                                                   d.setCandidateRatio(-0.25);
                                               }},
                                              {"atio", "1.25",
                                               [](D& d)
                                               {
                                                   d.setCandidateRatio(1.25);
                                               }},
                                              {"atio", "nan",
                                               [](D& d)
                                               {
                                                   d.setCandidateRatio(notANumber);
                                               }},
                                              {"atio", "inf",
                                               [](D& d)
                                               {
                                                   d.setCandidateRatio(infinity);
                                               }},
                                              {"poolSize", "0",
                                               [](D& d)
                                               {
                                                   d.setPoolSize(0);
                                               }},
                                              {"poolSize", "-7",
                                               [](D& d)
                                               {
                                                   d.setPoolSize(-7);
                                               }},
                                              {"heta", "nan",
                                               [](D& d)
                                               {
                                                   d.setAngleRange(notANumber, 1);
                                               }},
                                              {"heta", "nan",
                                               [](D& d)
                                               {
                                                   d.setAngleRange(0, notANumber);
                                               }},
                                              {"heta", "inf",
                                               [](D& d)
                                               {
                                                   d.setAngleRange(0, infinity);
                                               }},
                                              {"heta", "inf",
                                               [](D& d)
                                               {
                                                   d.setAngleRange(-infinity, 0);
                                               }},
                                              {"heta", "0.5",
                                               [](D& d)
                                               {
                                                   d.setAngleRange(0.5, 0.25);
                                               }},
                                              {"orientationTolerance", "0",
                                               [](D& d)
                                               {
                                                   d.setOrientationTolerance(0);
                                               }},
                                              {"orientationTolerance", "90.5",
                                               [](D& d)
                                               {
                                                   d.setOrientationTolerance(90.5);
                                               }},
                                              {"orientationTolerance", "nan",
                                               [](D& d)
                                               {
                                                   d.setOrientationTolerance(notANumber);
                                               }},
                                              {"alseAlarms", "0",
                                               [](D& d)
                                               {
                                                   d.setFalseAlarms(0);
                                               }},
                                              {"alseAlarms", "-1",
                                               [](D& d)
                                               {
                                                   d.setFalseAlarms(-1);
                                               }},
                                              {"alseAlarms", "nan",
                                               [](D& d)
                                               {
                                                   d.setFalseAlarms(notANumber);
                                               }},
                                              {"alseAlarms", "inf",
                                               [](D& d)
                                               {
                                                   d.setFalseAlarms(infinity);
                                               }},
                                              {"emory", "0",
                                               [](D& d)
                                               {
                                                   d.setMemoryLimit(0);
                                               }},
                                              {"emory", "-1",
                                               [](D& d)
                                               {
                                                   d.setMemoryLimit(-1);
                                               }}};
    const Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(9, 0, METHOD_CASCADED, 4);
    const Mat1b edges = randomEdges(Size(40, 31), 0.3, 1);
    Lines expected, lines;
    detector->detect(edges, expected);
    for (size_t i = 0; i < settings.size(); ++i)
        EXPECT_EQ("", wrongException([&]() { settings[i].set(*detector); },
                                     {settings[i].name, settings[i].value}))
            << settings[i].name << " " << settings[i].value;
    detector->detect(edges, lines);
    EXPECT_EQ(expected, lines);
    EXPECT_EQ(9, detector->getThreshold());
    EXPECT_EQ(4, detector->getCellSize());
}

// Of video: what a detector needs for a size it has from the call before.
TEST(Linespace_Video, later_calls_allocate_nothing_of_image_size)
{
    if (!canFailAllocations())
        throw SkipTestException("no allocator that can be replaced");
    const Size size(1600, 1200);
    std::vector<Vec2d> drawn;
    const Mat edges = linesInNoise(size, 30, 0.03, 5, drawn);
    Mat dx, dy;
    Sobel(edges, dx, CV_16S, 1, 0);
    Sobel(edges, dy, CV_16S, 0, 1);
    const char* const kinds[] = {"plain",   "statistical", "unpruned",  "mask",
                                 "weights", "gradients",   "estimated", "explained"};
    for (int kind = 0; kind < 8; ++kind)
    {
        SCOPED_TRACE(kinds[kind]);
        const Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(kind == 1 ? 0 : 80, 100);
        detector->setPruning(kind != 2);
        if (kind == 3)
            detector->setMask(Mat(size, CV_8UC1, Scalar(1)));
        detector->setEdgeWeights(kind == 4);
        detector->setSelection(kind == 7 ? SELECT_EXPLAIN : SELECT_PEAKS);
        Lines lines;
        const auto detect = [&]()
        {
            if (kind == 5)
                detector->detect(edges, dx, dy, lines);
            else if (kind == 6)
                detector->detect(edges, noArray(), noArray(), lines);
            else
                detector->detect(edges, lines);
            return largestAllocation();
        };
        largestAllocation();
        EXPECT_GE(detect(), (size_t)size.area());
        for (int call = 0; call < 3; ++call)
            EXPECT_LT(detect(), (size_t)size.area());
    }
}

} // namespace
} // namespace opencv_test
