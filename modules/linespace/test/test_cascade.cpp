// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// METHOD_CASCADED against a recursive, top-down evaluation of its definition (doc/algorithm.md,
// section 3), at every level, tolerance 0; and the back ends against each other.

#include "test_precomp.hpp"

#include "brute_force.hpp"
#include "generators.hpp"
#include "test_support.hpp"

namespace opencv_test {
namespace {

using namespace generators;

Mat levelOf(LineSpaceDetector& detector, const Mat& edges, int level)
{
    Mat table;
    detector.computeLevel(edges, level, table);
    return table;
}

// The getters describe the cascade of the last call.
void checkShape(const LineSpaceDetector& detector, const Size& image, int cellSize)
{
    const brute::Cascade cascade = brute::cascadeOf(image, cellSize);
    ASSERT_EQ(cascade.frame(), detector.getFrameSize()) << image << ", cellSize " << cellSize;
    ASSERT_EQ(cascade.levelCount(), detector.getLevelCount()) << image << ", cellSize " << cellSize;
    for (int level = 0; level < cascade.levelCount(); ++level)
    {
        ASSERT_EQ(cascade.cellSize(level), detector.getLevelCellSize(level))
            << image << ", cellSize " << cellSize << ", level " << level;
        ASSERT_EQ(cascade.gridSize(level), detector.getLevelGridSize(level))
            << image << ", cellSize " << cellSize << ", level " << level;
    }
}

class Linespace_Cascade : public testing::TestWithParam<int>
{
protected:
    void checkEveryLevel(const Mat& edges, int cellSize, bool weighted = false)
    {
        const brute::Cascade cascade = brute::cascadeOf(edges.size(), cellSize);
        Ptr<LineSpaceDetector>& detector = detectors[cellSize];
        if (!detector)
            detector = LineSpaceDetector::create(1, 0, METHOD_CASCADED, cellSize, GetParam());
        detector->setEdgeWeights(weighted);
        Mat last;
        for (int level = 0; level < cascade.levelCount(); ++level)
        {
            const Mat expected = brute::cascadeTable(edges, cascade, level, weighted);
            const TableOrigin origin(GetParam(), edges.size(), cellSize, level,
                                     cascade.cellSize(level));
            last = levelOf(*detector, edges, level);
            ASSERT_TRUE(expectSameTable(last, expected, origin));
            ASSERT_EQ(GetParam(), detector->getActiveBackend());
        }
        checkShape(*detector, edges.size(), cellSize);
        Mat whole;
        detector->compute(edges, whole);
        ASSERT_EQ(0, cvtest::norm(whole, last, NORM_INF)) << "compute is not the last level";
    }

    std::map<int, Ptr<LineSpaceDetector>> detectors;
};

TEST_P(Linespace_Cascade, all_small_sizes)
{
    const int cellSizes[] = {2, 3, 5};
    for (int i = 0; i < 3; ++i)
        for (int height = 1; height <= 20; ++height)
            for (int width = 1; width <= 20; ++width)
            {
                const Size size(width, height);
                if (brute::cascadeOf(size, cellSizes[i]).levelCount() == 1 &&
                    width % 4 != height % 4)
                    continue; // one cell: some are enough, METHOD_EXACT has them all
                checkEveryLevel(randomEdges(Size(width, height), 0.4, 100 * width + height),
                                cellSizes[i]);
                if (HasFatalFailure())
                    return;
            }
}

TEST_P(Linespace_Cascade, odd_prime_and_narrow_sizes)
{
    const Size sizes[] = {Size(64, 48), Size(67, 45), Size(31, 89), Size(101, 7), Size(3, 97),
                          Size(1, 113), Size(127, 1), Size(2, 61),  Size(71, 2),  Size(40, 40)};
    const int cellSizes[] = {2, 3, 5, 8};
    for (size_t i = 0; i < sizeof(sizes) / sizeof(sizes[0]); ++i)
    {
        checkEveryLevel(asWindow(randomEdges(sizes[i], 0.3, (unsigned)i)), cellSizes[i % 4]);
        if (HasFatalFailure())
            return;
    }
}

TEST_P(Linespace_Cascade, weights)
{
    checkEveryLevel(randomEdges(Size(45, 38), 0.6, 11), 5, true);
    checkEveryLevel(Mat1b(37, 41, (uchar)255), 3, true); // sums beyond 8 and 16 bits' halves
}

TEST_P(Linespace_Cascade, votes_are_additive)
{
    const Size size(163, 121);
    const Mat1b edges = randomEdges(size, 0.5, 8), part = randomEdges(size, 0.5, 9);
    Mat1b inside = edges.clone(), outside = edges.clone();
    inside.setTo(0, part == 0);
    outside.setTo(0, part != 0);
    Ptr<LineSpaceDetector> detector =
        LineSpaceDetector::create(1, 0, METHOD_CASCADED, 8, GetParam());
    const brute::Cascade cascade = brute::cascadeOf(size, 8);
    for (int level = 0; level < cascade.levelCount(); ++level)
    {
        const Mat sum = levelOf(*detector, inside, level) + levelOf(*detector, outside, level);
        ASSERT_TRUE(
            expectSameTable(levelOf(*detector, edges, level), sum,
                            TableOrigin(GetParam(), size, 8, level, cascade.cellSize(level))));
    }
}

TEST_P(Linespace_Cascade, one_cell_equals_exact)
{
    const int cellSizes[] = {2, 3, 8, 16, 64};
    int tested = 0;
    for (int i = 0; i < 5; ++i)
        for (int height = 1; height <= 61; height += 1 + height / 7)
            for (int width = 1; width <= 61; width += 1 + width / 7)
            {
                const Size size(width, height);
                if (brute::cascadeOf(size, cellSizes[i]).levelCount() != 1)
                    continue;
                const Mat1b edges = randomEdges(size, 0.4, 61 * width + height);
                Mat exact, cascaded;
                Ptr<LineSpaceDetector> detector =
                    LineSpaceDetector::create(1, 0, METHOD_EXACT, cellSizes[i], GetParam());
                detector->compute(edges, exact);
                detector->setMethod(METHOD_CASCADED);
                detector->compute(edges, cascaded);
                ASSERT_EQ(1, detector->getLevelCount()) << size << ", cellSize " << cellSizes[i];
                ASSERT_EQ(size, detector->getFrameSize()) << size << ", cellSize " << cellSizes[i];
                ASSERT_TRUE(expectSameTable(cascaded, exact,
                                            TableOrigin(GetParam(), size, cellSizes[i], 0, size)));
                ++tested;
            }
    EXPECT_GT(tested, 200);
}

// One detector over changing sizes and parameters: no plan or buffer of an earlier call may shine
// through.
TEST_P(Linespace_Cascade, reused_detector)
{
    Ptr<LineSpaceDetector> detector =
        LineSpaceDetector::create(1, 0, METHOD_CASCADED, 8, GetParam());
    RNG rng(77);
    Size size;
    for (int i = 0; i < 60; ++i)
    {
        if (i % 4 == 0) // the same size several times, with other parameters
            size = Size(rng.uniform(1, 60), rng.uniform(1, 60));
        const int cellSize = rng.uniform(2, 9);
        const int method = rng.uniform(0, 4) == 0 ? METHOD_EXACT : METHOD_CASCADED;
        const bool weighted = rng.uniform(0, 3) == 0;
        const Mat1b edges = randomEdges(size, rng.uniform(0.0, 1.0), i);
        detector->setMethod(method);
        detector->setCellSize(cellSize);
        detector->setEdgeWeights(weighted);
        Mat table;
        detector->compute(edges, table);
        const brute::Cascade cascade = brute::cascadeOf(size, cellSize);
        const Mat expected =
            method == METHOD_EXACT
                ? brute::exactTable(edges, size, weighted)
                : brute::cascadeTable(edges, cascade, cascade.levelCount() - 1, weighted);
        ASSERT_TRUE(expectSameTable(table, expected,
                                    TableOrigin(GetParam(), size, cellSize, -1,
                                                method == METHOD_EXACT ? size : cascade.frame())));
    }
}

INSTANTIATE_TEST_CASE_P(/**/, Linespace_Cascade, LINESPACE_TEST_BACKENDS);

TEST(Linespace_Grid, rule)
{
    const int cellSizes[] = {2, 3, 5, 7, 8, 16, 33, 64};
    for (int i = 0; i < 8; ++i)
        for (int pixels = 1; pixels <= 700; pixels += pixels < 200 ? 1 : 7)
        {
            Ptr<LineSpaceDetector> detector =
                LineSpaceDetector::create(1, 0, METHOD_CASCADED, cellSizes[i], BACKEND_CPU);
            levelOf(*detector, whiteEdges(Size(pixels, 2)), 0);
            checkShape(*detector, Size(pixels, 2), cellSizes[i]);
            levelOf(*detector, whiteEdges(Size(2, pixels)), 0);
            checkShape(*detector, Size(2, pixels), cellSizes[i]);
            if (HasFatalFailure())
                return;
        }
}

TEST(Linespace_Grid, examples)
{
    const struct
    {
        Size image;
        int wanted;
        Size cell, grid;
    } examples[] = {{Size(512, 512), 8, Size(8, 8), Size(64, 64)},
                    {Size(256, 256), 16, Size(16, 16), Size(16, 16)},
                    {Size(640, 480), 8, Size(10, 15), Size(64, 32)},
                    {Size(1920, 1080), 8, Size(15, 17), Size(128, 64)}};
    for (int i = 0; i < 4; ++i)
    {
        const brute::Cascade cascade = brute::cascadeOf(examples[i].image, examples[i].wanted);
        EXPECT_EQ(examples[i].cell, cascade.cellSize(0));
        EXPECT_EQ(examples[i].grid, cascade.gridSize(0));
        Ptr<LineSpaceDetector> detector =
            LineSpaceDetector::create(1, 0, METHOD_CASCADED, examples[i].wanted, BACKEND_CPU);
        levelOf(*detector, whiteEdges(examples[i].image), 0);
        EXPECT_EQ(examples[i].cell, detector->getLevelCellSize(0));
        EXPECT_EQ(examples[i].grid, detector->getLevelGridSize(0));
    }
}

// The reference computes the expected tables once; the others follow with 1, 2 and 5 threads, and
// for a UMat.
void checkBackends(const Mat& edges, int method, int cellSize)
{
    const Ptr<LineSpaceDetector> reference =
        LineSpaceDetector::create(1, 0, method, cellSize, BACKEND_REFERENCE);
    const std::vector<int> backends = comparedBackends();
    std::vector<Ptr<LineSpaceDetector>> detectors;
    for (size_t i = 0; i < backends.size(); ++i)
        detectors.push_back(LineSpaceDetector::create(1, 0, method, cellSize, backends[i]));
    UMat onDevice;
    edges.copyTo(onDevice);
    for (int level = 0, levels = 1; level < levels; ++level)
    {
        const Mat expected = levelOf(*reference, edges, level);
        levels = reference->getLevelCount();
        ASSERT_EQ(BACKEND_REFERENCE, reference->getActiveBackend());
        for (size_t i = 0; i < backends.size(); ++i)
        {
            const TableOrigin origin(backends[i], edges.size(), cellSize, level,
                                     reference->getLevelCellSize(level));
            const int threads[] = {1, 2, 5};
            for (int k = 0; k < (backends[i] == BACKEND_CPU ? 3 : 1); ++k)
            {
                ThreadCount count(threads[k]);
                ASSERT_TRUE(expectSameTable(levelOf(*detectors[i], edges, level), expected, origin))
                    << threads[k] << " threads";
                ASSERT_EQ(backends[i], detectors[i]->getActiveBackend());
            }
            Mat table;
            detectors[i]->computeLevel(onDevice, level, table);
            ASSERT_TRUE(expectSameTable(table, expected, origin)) << "UMat";
        }
    }
}

void checkBackends(const Mat& edges, int cellSize)
{
    checkBackends(edges, METHOD_CASCADED, cellSize);
}

typedef testing::TestWithParam<int> Linespace_Backends; // the cell size

TEST_P(Linespace_Backends, all_small_sizes)
{
    for (int height = 1; height <= 20; ++height)
        for (int width = 1; width <= 20; ++width)
        {
            checkBackends(randomEdges(Size(width, height), 0.5, 100 * width + height), GetParam());
            if (HasFatalFailure())
                return;
        }
}

TEST_P(Linespace_Backends, medium_sizes)
{
    const Size sizes[] = {Size(97, 89), Size(128, 64), Size(61, 150), Size(199, 3), Size(5, 211)};
    for (int i = 0; i < 5; ++i)
    {
        checkBackends(randomEdges(sizes[i], 0.5, i), GetParam());
        checkBackends(whiteEdges(sizes[i]), GetParam());
        if (HasFatalFailure())
            return;
    }
}

INSTANTIATE_TEST_CASE_P(/**/, Linespace_Backends, testing::Values(2, 3, 5, 8, 16, 64));

TEST(Linespace_Backends_Large, vga)
{
    checkBackends(randomEdges(Size(640, 480), 0.2, 1), 8);
}

TEST(Linespace_Backends_Large, odd_window)
{
    checkBackends(asWindow(randomEdges(Size(517, 311), 0.2, 2)), 16);
}

TEST(Linespace_Backends_Large, white)
{
    checkBackends(whiteEdges(Size(384, 270)), 3);
}

TEST(Linespace_Backends_Large, exact_method)
{
    checkBackends(randomEdges(Size(211, 173), 0.3, 4), METHOD_EXACT, 8);
}

} // namespace
} // namespace opencv_test
