// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Sizes at the ends of what is allowed: from 1 x 1 over extreme aspect ratios to what does not fit
// in memory.

#include "test_precomp.hpp"

#include "brute_force.hpp"
#include "generators.hpp"
#include "test_support.hpp"

namespace opencv_test {
namespace {

using namespace generators;

struct LimitCase
{
    Size size;
    int cellSize;
};

void PrintTo(const LimitCase& limit, std::ostream* out)
{
    *out << limit.size << ", cellSize " << limit.cellSize;
}

const LimitCase limitCases[] = {{Size(1, 1), 8},     {Size(1, 2), 2},    {Size(2, 1), 64},
                                {Size(1, 2000), 8},  {Size(2000, 1), 8}, {Size(2000, 1), 2},
                                {Size(1, 2000), 2},  {Size(3, 997), 5},  {Size(997, 3), 8},
                                {Size(13, 1021), 3}, {Size(1, 251), 8},  {Size(293, 2), 3},
                                {Size(1021, 16), 2}, {Size(521, 517), 8}};

typedef testing::TestWithParam<tuple<int, LimitCase>> Linespace_Limits;

// Too many chords for all of them: a sample of each level.
TEST_P(Linespace_Limits, sampled_chords_of_every_level)
{
    const int backend = get<0>(GetParam());
    const LimitCase limit = get<1>(GetParam());
    if (backend == BACKEND_REFERENCE && limit.size.area() > 100000)
        return; // the same scalar code as at the other sizes
    const Mat1b edges = randomEdges(limit.size, 0.5, 21);
    Ptr<LineSpaceDetector> detector =
        LineSpaceDetector::create(1, 0, METHOD_CASCADED, limit.cellSize, backend);
    const brute::Cascade cascade = brute::cascadeOf(limit.size, limit.cellSize);
    RNG rng(6);
    std::vector<brute::BinnedPixel> pixels;
    for (int level = 0; level < cascade.levelCount(); ++level)
    {
        Mat table;
        detector->computeLevel(edges, level, table);
        const int points = brute::borderCount(cascade.cellSize(level));
        const Size grid = cascade.gridSize(level);
        ASSERT_EQ(Size(grid.width * points, grid.height * points), table.size());
        for (int i = 0; i < 2000; ++i)
        {
            const Point cell(rng.uniform(0, grid.width), rng.uniform(0, grid.height));
            const int s = rng.uniform(0, points), e = rng.uniform(0, points);
            brute::cascadePixels(cascade, level, cell, s, e, pixels);
            int expected = 0;
            for (size_t j = 0; j < pixels.size(); ++j)
                expected += brute::pixelValue(edges, pixels[j].pixel);
            ASSERT_EQ(expected, table.at<int>(cell.y * points + s, cell.x * points + e))
                << "level " << level << ", cell " << cell << ", chord (" << s << ", " << e << "), "
                << backendName(backend);
        }
    }
}

TEST_P(Linespace_Limits, lines_are_chords_with_their_votes)
{
    const int backend = get<0>(GetParam());
    const LimitCase limit = get<1>(GetParam());
    Mat1b edges = randomEdges(limit.size, 0.2, 22);
    edges.row(limit.size.height / 2).setTo(255);
    edges.col(limit.size.width / 2).setTo(255);
    const int methods[] = {METHOD_EXACT, METHOD_CASCADED};
    for (int i = 0; i < 2; ++i)
    {
        const int longest = methods[i] == METHOD_EXACT ? 300 : 1100; // O(n^3)
        if (std::max(limit.size.width, limit.size.height) > longest)
            continue;
        const int threshold = std::max(1, std::max(limit.size.width, limit.size.height) / 2);
        Ptr<LineSpaceDetector> detector =
            LineSpaceDetector::create(threshold, 20, methods[i], limit.cellSize, backend);
        detector->setRefine(REFINE_NONE);
        std::vector<Vec3f> lines;
        detector->detect(edges, lines);
        EXPECT_EQ(limit.size.area() == 1, lines.empty());
        for (size_t j = 0; j < lines.size(); ++j)
        {
            int s = 0, e = 0;
            ASSERT_TRUE(brute::chordOf(detector->getFrameSize(), lines[j], s, e)) << lines[j];
            ASSERT_EQ(brute::chordVotes(edges, detector->getFrameSize(), s, e), (int)lines[j][2])
                << lines[j];
            ASSERT_GT(lines[j][2], threshold);
        }
    }
}

INSTANTIATE_TEST_CASE_P(/**/, Linespace_Limits,
                        testing::Combine(LINESPACE_TEST_BACKENDS, testing::ValuesIn(limitCases)));

typedef testing::TestWithParam<tuple<int, int>> Linespace_Memory; // back end, method

TEST_P(Linespace_Memory, table_that_does_not_fit)
{
    Ptr<LineSpaceDetector> detector =
        LineSpaceDetector::create(1, 0, get<1>(GetParam()), 8, get<0>(GetParam()));
    const Mat1b edges(8192, 8192, (uchar)0); // a table of 4 GiB
    Mat1i out(2, 3, 77);
    const Mat before = out.clone();
    const uchar* const data = out.data;
    const std::vector<std::string> words = {"edges", "8192", "MiB"};
    EXPECT_EQ("", wrongException([&]() { detector->compute(edges, out); }, words));
    EXPECT_EQ("", wrongException([&]() { detector->computeLevel(edges, 0, out); }, words));
    EXPECT_EQ(data, out.data);
    EXPECT_EQ(0, cvtest::norm(out, before, NORM_INF));
    // It works on.
    const Mat1b small = randomEdges(Size(9, 8), 0.5, 1);
    Mat table;
    detector->compute(small, table);
    EXPECT_EQ(0, cvtest::norm(table, brute::exactTable(small, small.size()), NORM_INF));
}

// A table of B x B votes of 4 bytes may have 2^31 - 1 bytes: B = 2 (width + height) <= 23170.
TEST_P(Linespace_Memory, table_one_border_point_too_large)
{
    const Size sizes[] = {Size(11585, 1), Size(1, 11585)};
    for (int i = 0; i < 2; ++i)
    {
        Ptr<LineSpaceDetector> detector =
            LineSpaceDetector::create(1, 0, METHOD_EXACT, 8, get<0>(GetParam()));
        Mat out;
        EXPECT_EQ("", wrongException([&]() { detector->compute(Mat1b(sizes[i], (uchar)0), out); },
                                     {"edges", "11585"}));
        EXPECT_TRUE(out.empty());
    }
}

TEST_P(Linespace_Memory, limit_is_kept)
{
    Ptr<LineSpaceDetector> detector =
        LineSpaceDetector::create(50, 0, get<1>(GetParam()), 8, get<0>(GetParam()));
    const Mat1b edges = randomEdges(Size(900, 800), 0.05, 2);
    detector->setMemoryLimit(1);
    std::vector<Vec3f> lines(3, Vec3f(1, 2, 3));
    EXPECT_EQ("", wrongException([&]() { detector->detect(edges, lines); }, {"emory"}));
    ASSERT_EQ(3u, lines.size());
    EXPECT_EQ(Vec3f(1, 2, 3), lines[2]);
    const Mat1b small = randomEdges(Size(16, 16), 0.5, 3);
    Mat table;
    detector->compute(small, table); // a small image still fits
    EXPECT_EQ(64, table.rows);
}

INSTANTIATE_TEST_CASE_P(/**/, Linespace_Memory,
                        testing::Combine(LINESPACE_TEST_BACKENDS,
                                         testing::Values((int)METHOD_EXACT, (int)METHOD_CASCADED)));

} // namespace
} // namespace opencv_test
