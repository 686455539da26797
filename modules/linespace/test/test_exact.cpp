// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// METHOD_EXACT against the definition of a chord's raster (doc/algorithm.md, section 2), tolerance
// 0.

#include "test_precomp.hpp"

#include "brute_force.hpp"
#include "generators.hpp"
#include "test_support.hpp"

namespace opencv_test {
namespace {

using namespace generators;

class Linespace_Exact : public testing::TestWithParam<int>
{
protected:
    Mat table(const Mat& edges, bool weighted = false)
    {
        if (!detector)
            detector = LineSpaceDetector::create(1, 0, METHOD_EXACT, 8, GetParam());
        detector->setEdgeWeights(weighted);
        Mat out;
        detector->compute(edges, out);
        EXPECT_EQ(GetParam(), detector->getActiveBackend());
        return out;
    }

    TableOrigin origin(const Size& size) { return TableOrigin(GetParam(), size, 0, 0, size); }

    Ptr<LineSpaceDetector> detector;
};

TEST_P(Linespace_Exact, all_small_sizes)
{
    const double densities[] = {0.15, 0.6};
    for (int height = 1; height <= 20; ++height)
        for (int width = 1; width <= 20; ++width)
            for (int i = 0; i < 2; ++i)
            {
                const Size size(width, height);
                const Mat1b edges = randomEdges(size, densities[i], 1000 * height + 10 * width + i);
                const Mat expected = brute::exactTable(edges, size);
                ASSERT_TRUE(expectSameTable(table(edges), expected, origin(size)));
                ASSERT_TRUE(expectSameTable(table(asWindow(edges)), expected, origin(size)))
                    << "window";
            }
}

TEST_P(Linespace_Exact, odd_prime_and_narrow_sizes)
{
    const Size sizes[] = {Size(31, 17), Size(37, 53), Size(64, 48), Size(101, 7), Size(3, 97),
                          Size(1, 113), Size(127, 1), Size(2, 61),  Size(71, 2)};
    for (size_t i = 0; i < sizeof(sizes) / sizeof(sizes[0]); ++i)
    {
        const Mat1b edges = randomEdges(sizes[i], 0.3, (unsigned)i);
        const Mat expected = brute::exactTable(edges, sizes[i]);
        ASSERT_TRUE(expectSameTable(table(edges), expected, origin(sizes[i])));
        ASSERT_TRUE(expectSameTable(table(asWindow(edges)), expected, origin(sizes[i])))
            << "window";
    }
}

TEST_P(Linespace_Exact, weights)
{
    for (int side = 1; side <= 20; ++side)
    {
        const Size size(side, 21 - side);
        const Mat1b edges = randomEdges(size, 0.5, side);
        const Mat expected = brute::exactTable(edges, size, true);
        ASSERT_TRUE(expectSameTable(table(edges, true), expected, origin(size)));
        ASSERT_TRUE(expectSameTable(table(asWindow(edges), true), expected, origin(size)));
    }
}

TEST_P(Linespace_Exact, umat_and_level_zero)
{
    const Size size(23, 19);
    const Mat1b edges = randomEdges(size, 0.4, 3);
    const Mat expected = brute::exactTable(edges, size);
    UMat device, out;
    edges.copyTo(device);
    table(edges); // creates the detector
    detector->compute(device, out);
    ASSERT_TRUE(expectSameTable(out.getMat(ACCESS_READ), expected, origin(size)));
    Mat level;
    detector->computeLevel(edges, 0, level);
    ASSERT_TRUE(expectSameTable(level, expected, origin(size)));
    EXPECT_EQ(size, detector->getFrameSize());
    EXPECT_EQ(1, detector->getLevelCount());
    EXPECT_EQ(size, detector->getLevelCellSize(0));
    EXPECT_EQ(Size(1, 1), detector->getLevelGridSize(0));
}

// By inequalities, without a raster: the chord passes the pixel's middle column (row) within the
// pixel.
bool passesThrough(const Size& frame, int s, int e, const Point& pixel)
{
    brute::Doubled p = brute::borderPoint(frame, s), q = brute::borderPoint(frame, e);
    int64 major = 2 * pixel.x + 1, minor = 2 * pixel.y;
    if (!brute::stepsAlongX(p, q))
    {
        std::swap(p.x, p.y);
        std::swap(q.x, q.y);
        major = 2 * pixel.y + 1;
        minor = 2 * pixel.x;
    }
    if (p.x > q.x)
        std::swap(p, q);
    const int64 length = q.x - p.x, height = p.y * length + (q.y - p.y) * (major - p.x);
    return p.x <= major && major <= q.x && minor * length <= height &&
           height < (minor + 2) * length;
}

TEST_P(Linespace_Exact, one_pixel_votes_for_the_chords_through_it)
{
    const Size sizes[] = {Size(1, 1), Size(5, 4), Size(7, 7), Size(4, 11), Size(12, 3)};
    for (size_t i = 0; i < sizeof(sizes) / sizeof(sizes[0]); ++i)
        for (int y = 0; y < sizes[i].height; ++y)
            for (int x = 0; x < sizes[i].width; ++x)
            {
                const int points = brute::borderCount(sizes[i]);
                Mat1i expected(points, points, 0);
                for (int s = 0; s < points; ++s)
                    for (int e = 0; e < points; ++e)
                        if (brute::isChord(sizes[i], s, e))
                            expected(s, e) = passesThrough(sizes[i], s, e, Point(x, y));
                ASSERT_TRUE(expectSameTable(table(onePixel(sizes[i], Point(x, y))), expected,
                                            origin(sizes[i])))
                    << "pixel " << Point(x, y);
            }
}

TEST_P(Linespace_Exact, votes_are_additive)
{
    const Size size(43, 29);
    const Mat1b edges = randomEdges(size, 0.5, 8), part = randomEdges(size, 0.5, 9);
    Mat1b inside = edges.clone(), outside = edges.clone();
    inside.setTo(0, part == 0);
    outside.setTo(0, part != 0);
    const Mat sum = table(inside) + table(outside);
    ASSERT_TRUE(expectSameTable(table(edges), sum, origin(size)));
}

// An image cut in two: what a chord has in the parts, where it crosses the cut at a border point or
// not at all.
void checkCut(const Mat& whole, const Mat& first, const Mat& second, const Size& size, int cut,
              bool columns, int& crossings)
{
    const Size firstSize = columns ? Size(cut, size.height) : Size(size.width, cut);
    const Size secondSize =
        columns ? Size(size.width - cut, size.height) : Size(size.width, size.height - cut);
    const brute::Doubled shift = columns ? brute::Doubled(2 * cut, 0) : brute::Doubled(0, 2 * cut);
    for (int s = 0; s < whole.rows; ++s)
        for (int e = 0; e < whole.cols; ++e)
        {
            if (!brute::isChord(size, s, e))
                continue;
            const brute::Doubled p = brute::borderPoint(size, s), q = brute::borderPoint(size, e);
            const bool pFirst = (columns ? p.x : p.y) < 2 * cut,
                       qFirst = (columns ? q.x : q.y) < 2 * cut;
            if (!pFirst || (!qFirst && (columns ? p.x > q.x : p.y > q.y)))
                continue;
            int expected;
            if (qFirst)
                expected = first.at<int>(brute::borderIndex(firstSize, p),
                                         brute::borderIndex(firstSize, q));
            else
            {
                const int64 dMajor = columns ? q.x - p.x : q.y - p.y,
                            dMinor = columns ? q.y - p.y : q.x - p.x;
                const int64 way = dMinor * (2 * cut - (columns ? p.x : p.y));
                const int64 minor = (columns ? p.y : p.x) + way / dMajor;
                if (way % dMajor != 0 || minor % 2 == 0)
                    continue; // not a border point
                const brute::Doubled m =
                    columns ? brute::Doubled(2 * cut, minor) : brute::Doubled(minor, 2 * cut);
                expected = first.at<int>(brute::borderIndex(firstSize, p),
                                         brute::borderIndex(firstSize, m)) +
                           second.at<int>(brute::borderIndex(secondSize, m - shift),
                                          brute::borderIndex(secondSize, q - shift));
                ++crossings;
            }
            ASSERT_EQ(expected, whole.at<int>(s, e))
                << "chord (" << s << ", " << e << ") of " << size << ", cut at " << cut;
        }
}

TEST_P(Linespace_Exact, votes_add_up_over_a_cut_at_a_border_point)
{
    const Size sizes[] = {Size(2, 1), Size(6, 6), Size(10, 7), Size(9, 14), Size(16, 16)};
    int crossings = 0;
    for (size_t i = 0; i < sizeof(sizes) / sizeof(sizes[0]); ++i)
    {
        const Size size = sizes[i];
        const Mat images[] = {randomEdges(size, 0.5, (unsigned)i), whiteEdges(size)};
        for (int image = 0; image < 2; ++image)
        {
            const Mat& edges = images[image];
            const Mat whole = table(edges);
            for (int cut = 1; cut < size.width; ++cut)
                checkCut(whole, table(edges.colRange(0, cut)),
                         table(edges.colRange(cut, size.width)), size, cut, true, crossings);
            for (int cut = 1; cut < size.height; ++cut)
                checkCut(whole, table(edges.rowRange(0, cut)),
                         table(edges.rowRange(cut, size.height)), size, cut, false, crossings);
            if (HasFatalFailure())
                return;
        }
    }
    EXPECT_GT(crossings, 5000); // the condition is met often enough to mean something
}

INSTANTIATE_TEST_CASE_P(/**/, Linespace_Exact, LINESPACE_TEST_BACKENDS);

// The brute force must itself be worth comparing with.

TEST(Linespace_BruteForce, border_points_are_a_ring)
{
    for (int height = 1; height <= 6; ++height)
        for (int width = 1; width <= 6; ++width)
        {
            const Size cell(width, height);
            const int points = brute::borderCount(cell);
            for (int i = 0; i < points; ++i)
            {
                ASSERT_EQ(i, brute::borderIndex(cell, brute::borderPoint(cell, i)));
                // Neighbours are one pixel apart, over a corner half a pixel in each direction.
                const brute::Doubled step =
                    brute::borderPoint(cell, (i + 1) % points) - brute::borderPoint(cell, i);
                ASSERT_EQ(2, std::abs(step.x) + std::abs(step.y));
            }
        }
}

TEST(Linespace_BruteForce, raster_does_not_depend_on_the_direction)
{
    const Size cell(9, 7);
    const int points = brute::borderCount(cell);
    for (int s = 0; s < points; ++s)
        for (int e = 0; e < points; ++e)
        {
            if (!brute::isChord(cell, s, e))
                continue;
            const brute::Doubled p = brute::borderPoint(cell, s), q = brute::borderPoint(cell, e);
            const std::vector<brute::Step> there = brute::raster(p, q), back = brute::raster(q, p);
            ASSERT_EQ(there.size(), back.size());
            for (size_t i = 0; i < there.size(); ++i)
                ASSERT_EQ(there[i].pixel, back[i].pixel);
        }
}

} // namespace
} // namespace opencv_test
