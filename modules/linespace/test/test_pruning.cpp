// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The search by bundles (doc/algorithm.md, section 4, point 6) finds the lines that whole tables
// give, to the bit, whatever the image and the parameters.

#include "test_precomp.hpp"

#include "generators.hpp"
#include "test_support.hpp"

namespace opencv_test {
namespace {

using namespace generators;

struct Found
{
    std::vector<Vec3f> lines, deviations;
    std::vector<String> stages;

    bool hasStage(const char* name) const
    {
        return std::find(stages.begin(), stages.end(), name) != stages.end();
    }
};

Found detectWith(LineSpaceDetector& detector, const Mat& edges, bool oriented = false)
{
    Found found;
    std::vector<double> milliseconds;
    if (oriented)
        detector.detect(edges, noArray(), noArray(), found.lines);
    else
        detector.detect(edges, found.lines);
    detector.getDeviations(found.deviations);
    detector.getStageTimes(found.stages, milliseconds);
    return found;
}

//! Pruned or not; returns the pruned one.
Found expectSameLines(LineSpaceDetector& detector, const Mat& edges, bool oriented = false)
{
    detector.setPruning(false);
    const Found expected = detectWith(detector, edges, oriented);
    EXPECT_FALSE(expected.hasStage("bundles"));
    detector.setPruning(true);
    const Found found = detectWith(detector, edges, oriented);
    // Where no chord can be significant nothing is looked for.
    EXPECT_EQ(expected.hasStage("candidates"), found.hasStage("bundles"));
    EXPECT_EQ(expected.lines, found.lines);
    EXPECT_EQ(expected.deviations, found.deviations);
    // What was found the first time says where to begin the second time.
    const Found again = detectWith(detector, edges, oriented);
    EXPECT_EQ(expected.lines, again.lines);
    EXPECT_EQ(expected.deviations, again.deviations);
    // The next one is of another kind for the detector.
    detector.clear();
    return found;
}

Mat1b someLines(const Size& size, unsigned seed)
{
    std::vector<Vec2d> lines;
    return linesInNoise(size, 12, 0.02, seed, lines);
}

const Size sizes[] = {Size(256, 256), Size(300, 200), Size(128, 512), Size(333, 257),
                      Size(640, 96)};

typedef testing::TestWithParam<Size> Linespace_Pruning;

TEST_P(Linespace_Pruning, images)
{
    const Size size = GetParam();
    const Mat images[] = {someLines(size, 1),        randomEdges(size, 0.01, 2),
                          randomEdges(size, 0.1, 3), randomEdges(size, 0.5, 4),
                          whiteEdges(size),          onePixel(size, Point(size.width / 2, 7)),
                          Mat::zeros(size, CV_8UC1)};
    for (size_t i = 0; i < sizeof(images) / sizeof(images[0]); ++i)
        for (int threshold = 0; threshold <= 80; threshold += 40)
        {
            SCOPED_TRACE(format("image %d, threshold %d", (int)i, threshold));
            expectSameLines(*LineSpaceDetector::create(threshold, 100), images[i]);
        }
}

// Where few candidates are wanted the search begins high, where all are it begins at the threshold.
TEST_P(Linespace_Pruning, numbers_of_candidates)
{
    const Mat edges = someLines(GetParam(), 5);
    const int lines[] = {1, 30, 0};
    for (int i = 0; i < 3; ++i)
        for (int pool = 1; pool <= 10000; pool *= 100)
            for (int threshold = 0; threshold <= 60; threshold += 30)
            {
                SCOPED_TRACE(format("%d lines, pool %d, threshold %d", lines[i], pool, threshold));
                const Ptr<LineSpaceDetector> detector =
                    LineSpaceDetector::create(threshold, lines[i]);
                detector->setPoolSize(pool);
                detector->setSuppressionDistance(0);
                detector->setRefine(REFINE_NONE);
                expectSameLines(*detector, edges);
            }
}

// Maxima of neighbourhoods of every size, and the statistical rule, which refuses chords that may
// be stronger than a neighbour that it accepts.
TEST_P(Linespace_Pruning, neighbourhoods)
{
    const Mat edges = someLines(GetParam(), 6);
    for (int radius = 0; radius <= 4; ++radius)
        for (int i = 0; i < 3; ++i)
        {
            const double ratio = i / 2.;
            SCOPED_TRACE(format("radius %d, ratio %g", radius, ratio));
            const Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(0, 0);
            detector->setSuppressionRadius(radius);
            detector->setCandidateRatio(ratio);
            detector->setRefine(REFINE_NONE);
            detector->setSuppressionDistance(0);
            if (ratio > 0)
                expectSameLines(*detector, edges);
            detector->setThreshold(40);
            if (ratio > 0)
                expectSameLines(*detector, edges);
            detector->setThreshold(0);
            detector->setMaxLines(200);
            detector->setPoolSize(1000);
            expectSameLines(*detector, edges);
        }
}

// Where chance is allowed much, many chords have just the votes that their length asks for.
TEST_P(Linespace_Pruning, significance)
{
    for (unsigned seed = 0; seed < 4; ++seed)
    {
        const Mat edges = randomEdges(GetParam(), 0.02 + 0.03 * seed, seed);
        for (double falseAlarms = 100; falseAlarms < 1e6; falseAlarms *= 10)
            for (int radius = 0; radius <= 4; radius += 2)
            {
                SCOPED_TRACE(format("seed %u, %g, radius %d", seed, falseAlarms, radius));
                const Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(0, 0);
                detector->setFalseAlarms(falseAlarms);
                detector->setSuppressionRadius(radius);
                detector->setCandidateRatio(1);
                detector->setRefine(REFINE_NONE);
                detector->setSuppressionDistance(0);
                expectSameLines(*detector, edges);
            }
    }
}

// Of a line alone the bounds are exact: nothing is left between them and what its length asks for.
TEST_P(Linespace_Pruning, a_line_that_is_just_significant)
{
    const Size size = GetParam();
    RNG random(9);
    int found = 0;
    for (int i = 0; i < 10; ++i)
    {
        const Point from(random.uniform(0, size.width), 0),
            to(i % 2 ? Point(random.uniform(0, size.width), size.height - 1)
                     : Point(size.width - 1, random.uniform(0, size.height)));
        Mat1b edges = Mat1b::zeros(size);
        LineIterator pixel(edges, from, to);
        const int drawn = pixel.count / 4;
        for (int k = 0; k < drawn; ++k, ++pixel)
            **pixel = 1;
        const Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(0, 0);
        detector->setCandidateRatio(1);
        detector->setRefine(REFINE_NONE);
        detector->setSuppressionDistance(0);
        // From nothing to many lines; in between they are just significant.
        for (double falseAlarms = 1e-12; falseAlarms < 1e6; falseAlarms *= 3)
        {
            SCOPED_TRACE(format("line %d, %g", i, falseAlarms));
            detector->setFalseAlarms(falseAlarms);
            detector->setPruning(false);
            const Found expected = detectWith(*detector, edges);
            detector->setPruning(true);
            EXPECT_EQ(expected.lines, detectWith(*detector, edges).lines);
            found += !expected.lines.empty();
        }
    }
    EXPECT_GT(found, 10);
}

TEST_P(Linespace_Pruning, options)
{
    const Mat edges = someLines(GetParam(), 7);
    for (int threshold = 0; threshold <= 50; threshold += 50)
    {
        SCOPED_TRACE(format("threshold %d", threshold));
        const Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(threshold, 50);
        expectSameLines(*detector, edges, true);
        detector->setAngleRange(0.3, 1.2);
        expectSameLines(*detector, edges);
        detector->setSelection(SELECT_EXPLAIN);
        expectSameLines(*detector, edges);
        Mat mask = Mat::zeros(edges.size(), CV_8UC1);
        mask(Rect(10, 20, edges.cols / 2, edges.rows / 2)).setTo(1);
        detector->setMask(mask);
        expectSameLines(*detector, edges);
        detector->setMask(noArray());
        for (int cellSize = 4; cellSize <= 16; cellSize *= 2)
        {
            detector->setCellSize(cellSize);
            expectSameLines(*detector, edges);
        }
    }
    // With weights votes of more than 16 bits have no bundles: few do not.
    const Ptr<LineSpaceDetector> weighted = LineSpaceDetector::create(0, 50);
    weighted->setEdgeWeights(true);
    weighted->setPruning(false);
    const Mat weights = edges / 40;
    const Found expected = detectWith(*weighted, weights);
    weighted->setPruning(true);
    EXPECT_EQ(expected.lines, detectWith(*weighted, weights).lines);
}

INSTANTIATE_TEST_CASE_P(Linespace, Linespace_Pruning, testing::ValuesIn(sizes));

// What it begins with comes from the image before, which can be any other.
TEST(Linespace_Pruning_Sequence, images_of_all_kinds)
{
    const Size size(256, 192);
    const Ptr<LineSpaceDetector> pruned = LineSpaceDetector::create(10, 50),
                                 whole = LineSpaceDetector::create(10, 50);
    pruned->setPoolSize(500);
    whole->setPoolSize(500);
    whole->setPruning(false);
    for (unsigned i = 0; i < 24; ++i)
    {
        const Mat edges = i % 3 == 0   ? Mat(randomEdges(size, 0.01 * (1 + i * 7 % 50), i))
                          : i % 3 == 1 ? Mat(someLines(size, i))
                                       : Mat(whiteEdges(i % 2 ? size : Size(128, 128)));
        SCOPED_TRACE(format("image %u", i));
        EXPECT_EQ(detectWith(*whole, edges).lines, detectWith(*pruned, edges).lines);
    }
}

// Lines stand out, so most of the table is never counted; of a white image whole tables are faster.
TEST(Linespace_Pruning_Sequence, stages)
{
    const Size size(512, 512);
    const Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(60, 100);
    const Found few = detectWith(*detector, someLines(size, 8));
    EXPECT_TRUE(few.hasStage("bundles"));
    EXPECT_FALSE(few.hasStage("level 12"));
    const Found all = detectWith(*detector, whiteEdges(size));
    EXPECT_TRUE(all.hasStage("bundles"));
    EXPECT_TRUE(all.hasStage("level 12"));
    EXPECT_FALSE(detectWith(*detector, whiteEdges(size)).hasStage("bundles")); // does not try again
    EXPECT_TRUE(detectWith(*detector, whiteEdges(size)).hasStage("bundles"));  // but later
    detector->setSuppression(SUPPRESS_GREEDY);
    EXPECT_FALSE(detectWith(*detector, someLines(size, 8)).hasStage("bundles"));
}

TEST(Linespace_Pruning_Sequence, photographs)
{
    const char* const names[] = {"building.jpg", "board.jpg", "home.jpg", "sudoku.png"};
    for (int i = 0; i < 4; ++i)
    {
        const Mat edges = photographEdges(names[i], 640);
        if (edges.empty())
            return;
        for (int threads = 1; threads <= 3; ++threads)
            for (int threshold = 0; threshold <= 90; threshold += 30)
            {
                SCOPED_TRACE(format("%s, threshold %d", names[i], threshold));
                const ThreadCount count(threads);
                expectSameLines(*LineSpaceDetector::create(threshold, 100), edges);
            }
    }
}

} // namespace
} // namespace opencv_test
