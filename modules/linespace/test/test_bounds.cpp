// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The two bounds that doc/algorithm.md derives for the cascade: how many votes a chord of a level
// can have, which fixes the width of the counters, and how far from the true chord a pixel can be
// that is counted.

#include "test_precomp.hpp"

#include "brute_force.hpp"
#include "generators.hpp"
#include "test_support.hpp"

namespace opencv_test {
namespace {

using namespace generators;

//! Most votes of a chord of a level: the longer side, and one for every crossing of a side of a
//! level-0 cell.
int voteBound(const brute::Cascade& cascade, int level)
{
    const Size cell = cascade.cellSize(level), finest = cascade.cellSize(0);
    const int crossings = cell.width / finest.width + cell.height / finest.height - 2;
    return std::max(cell.width, cell.height) + crossings;
}

Mat levelVotes(LineSpaceDetector& detector, const Mat& edges, int level)
{
    Mat table;
    detector.computeLevel(edges, level, table);
    return table;
}

struct WhiteCase
{
    Size size;
    int cellSize;
};

void PrintTo(const WhiteCase& white, std::ostream* out)
{
    *out << white.size << ", cellSize " << white.cellSize;
}

typedef testing::TestWithParam<tuple<int, WhiteCase>> Linespace_VoteBound;

// 240 x 252 and 248 x 254 reach 256 votes, one more than 8 bits hold.
const WhiteCase whiteCases[] = {{Size(240, 252), 21}, {Size(248, 254), 43}, {Size(248, 255), 8},
                                {Size(256, 256), 2},  {Size(255, 257), 3},  {Size(512, 512), 8},
                                {Size(300, 17), 2},   {Size(17, 300), 2},   {Size(1100, 3), 2},
                                {Size(3, 1100), 5},   {Size(513, 129), 5},  {Size(700, 40), 64},
                                {Size(97, 211), 16},  {Size(640, 480), 8}};

TEST_P(Linespace_VoteBound, white_image)
{
    const int backend = get<0>(GetParam());
    const WhiteCase white = get<1>(GetParam());
    if (backend == BACKEND_REFERENCE && white.size.area() > 100000)
        return; // the same code at other sizes; the CPU path has the narrow counters
    Ptr<LineSpaceDetector> detector =
        LineSpaceDetector::create(1, 0, METHOD_CASCADED, white.cellSize, backend);
    const brute::Cascade cascade = brute::cascadeOf(white.size, white.cellSize);
    const Mat1b edges = whiteEdges(cascade.frame()); // without padding: the most votes
    Mat1b half = edges.clone();
    half.colRange(half.cols / 2, half.cols).setTo(0);
    Mat lower = half.rowRange(half.rows / 2, half.rows);
    bitwise_not(lower, lower);
    RNG rng(5);
    std::vector<brute::BinnedPixel> pixels;
    for (int level = 0; level < cascade.levelCount(); ++level)
    {
        const Mat table = levelVotes(*detector, edges, level);
        double most = 0, least = 0;
        minMaxLoc(table, &least, &most);
        EXPECT_LE(most, voteBound(cascade, level)) << "level " << level;
        EXPECT_GE(least, 0) << "level " << level;
        // A counter that is too narrow wraps and stays below the bound: the halves' votes fit.
        const Mat sum =
            levelVotes(*detector, half, level) + levelVotes(*detector, edges - half, level);
        const TableOrigin origin(backend, edges.size(), white.cellSize, level,
                                 cascade.cellSize(level));
        ASSERT_TRUE(expectSameTable(table, sum, origin));
        detector->setEdgeWeights(true);
        ASSERT_TRUE(expectSameTable(levelVotes(*detector, edges, level), 255 * table, origin))
            << "weights";
        detector->setEdgeWeights(false);
        const int points = brute::borderCount(cascade.cellSize(level));
        for (int i = 0; i < 500; ++i)
        {
            const int s = rng.uniform(0, points), e = rng.uniform(0, points);
            const Size grid = cascade.gridSize(level);
            const Point cell(rng.uniform(0, grid.width), rng.uniform(0, grid.height));
            brute::cascadePixels(cascade, level, cell, s, e, pixels);
            ASSERT_EQ((int)pixels.size(), table.at<int>(cell.y * points + s, cell.x * points + e))
                << "level " << level << ", cell " << cell << ", chord (" << s << ", " << e << "), "
                << backendName(backend);
        }
    }
}

INSTANTIATE_TEST_CASE_P(/**/, Linespace_VoteBound,
                        testing::Combine(LINESPACE_TEST_BACKENDS, testing::ValuesIn(whiteCases)));

typedef testing::TestWithParam<tuple<int, Size>> Linespace_VoteBound_Reached;

// Hardly any chord of a photograph has more votes than a byte holds, and a wrapped count is small:
// the counters must notice a single one, in each cell, along rows, columns and diagonals.
TEST_P(Linespace_VoteBound_Reached, by_one_chord_of_a_cell)
{
    const int backend = get<0>(GetParam()), cellSize = 8, side = 256;
    if (backend == BACKEND_REFERENCE)
        return; // slow, and without narrow counters
    const Size size = get<1>(GetParam());
    Ptr<LineSpaceDetector> detector =
        LineSpaceDetector::create(1, 0, METHOD_CASCADED, cellSize, backend);
    const brute::Cascade cascade = brute::cascadeOf(size, cellSize);
    RNG rng(14);
    const Mat1b few = randomEdges(size, 0.01, 14);
    int level = cascade.levelCount() - 1;
    while (cascade.cellSize(level).width > side || cascade.cellSize(level).height > side)
        --level;
    for (int pixels = 253; pixels <= side; ++pixels)
        for (int direction = 0; direction < 3; ++direction)
        {
            Mat1b all = few.clone(), firstHalf = few.clone(), secondHalf = few.clone();
            const Point corner(rng.uniform(0, size.width / side) * side,
                               rng.uniform(0, size.height / side) * side);
            const int offset = rng.uniform(0, side);
            for (int i = 0; i < pixels; ++i)
            {
                const Point at = direction == 0   ? Point(i, offset)
                                 : direction == 1 ? Point(offset, i)
                                                  : Point(i, i);
                all(corner + at) = 255;
                (i < side / 2 ? firstHalf : secondHalf)(corner + at) = 255;
            }
            EXPECT_TRUE(expectSameTable(
                levelVotes(*detector, all, level) + levelVotes(*detector, few, level),
                levelVotes(*detector, firstHalf, level) + levelVotes(*detector, secondHalf, level),
                TableOrigin(backend, size, cellSize, level, cascade.cellSize(level))))
                << pixels << " pixels, direction " << direction;
        }
}

INSTANTIATE_TEST_CASE_P(/**/, Linespace_VoteBound_Reached,
                        testing::Combine(LINESPACE_TEST_BACKENDS,
                                         testing::Values(Size(2048, 256), Size(256, 2048))));

// Where the longest polyline needs one counter more than the longer side: the widths must not
// follow from the side.
TEST(Linespace_VoteBound_Longest, exceeds_the_side)
{
    int most = 0;
    std::vector<brute::BinnedPixel> pixels;
    const brute::Cascade cascade = brute::cascadeOf(Size(512, 512), 8);
    const Size frame = cascade.frame();
    for (int s = 0; s < frame.width; s += 3)
        for (int e = frame.width + frame.height; e < 2 * frame.width + frame.height; e += 5)
        {
            brute::cascadePixels(cascade, cascade.levelCount() - 1, Point(), s, e, pixels);
            most = std::max(most, (int)pixels.size());
        }
    EXPECT_GT(most, 512);
    EXPECT_LE(most, voteBound(cascade, cascade.levelCount() - 1));
}

/** How far a counted pixel may be: with the chord P + t (dx, dy) and the pixel's centre C, all
doubled, |dx (Cy - Py) - dy (Cx - Px)| <= a |dx| + b |dy| + max(|dx|, |dy|) after a merges of
columns and b of rows: each merge of columns moves the crossing by at most half a pixel along y,
each merge of rows along x, and the raster of the part takes a pixel whose centre is at most half a
pixel away. */
class Strip
{
public:
    Strip(const brute::Cascade& cascade, int level, int s, int e)
        : p(brute::borderPoint(cascade.cellSize(level), s)),
          d(brute::borderPoint(cascade.cellSize(level), e) - p)
    {
        const int columns = cascade.columnMerges(level), rows = level - columns;
        const int64 dx = std::abs(d.x), dy = std::abs(d.y);
        bound = columns * dx + rows * dy + std::max(dx, dy);
    }

    bool contains(int x, int y) const
    {
        return std::abs(d.x * (2 * y + 1 - p.y) - d.y * (2 * x + 1 - p.x)) <= bound;
    }

private:
    brute::Doubled p, d;
    int64 bound;
};

typedef testing::TestWithParam<int> Linespace_Deviation;

TEST_P(Linespace_Deviation, every_single_pixel)
{
    const struct
    {
        Size size;
        int cellSize;
    } cases[] = {
        {Size(12, 12), 2}, {Size(16, 9), 2}, {Size(7, 14), 2}, {Size(20, 13), 3}, {Size(19, 3), 2}};
    for (int i = 0; i < 5; ++i)
    {
        const Size size = cases[i].size;
        const brute::Cascade cascade = brute::cascadeOf(size, cases[i].cellSize);
        const int last = cascade.levelCount() - 1, points = brute::borderCount(cascade.frame());
        ASSERT_GT(last, 0);
        Ptr<LineSpaceDetector> detector =
            LineSpaceDetector::create(1, 0, METHOD_CASCADED, cases[i].cellSize, GetParam());
        Mat sum(points, points, CV_32SC1, Scalar(0)), table;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
            {
                detector->compute(onePixel(size, Point(x, y)), table);
                sum += table;
                for (int s = 0; s < points; ++s)
                    for (int e = 0; e < points; ++e)
                    {
                        const int votes = table.at<int>(s, e);
                        ASSERT_TRUE(votes == 0 || votes == 1);
                        const bool mayVote = brute::isChord(cascade.frame(), s, e) &&
                                             Strip(cascade, last, s, e).contains(x, y);
                        ASSERT_TRUE(votes == 0 || mayVote) << size << ", pixel " << Point(x, y)
                                                           << ", chord (" << s << ", " << e << ")";
                    }
            }
        detector->compute(whiteEdges(size), table);
        ASSERT_TRUE(expectSameTable(
            table, sum, TableOrigin(GetParam(), size, cases[i].cellSize, last, cascade.frame())));
    }
}

// Every chord of the last level, or every step-th one of each end.
void checkStrips(const Mat1b& edges, int cellSize, int backend, int step)
{
    const brute::Cascade cascade = brute::cascadeOf(edges.size(), cellSize);
    const int last = cascade.levelCount() - 1;
    ASSERT_GT(last, 0);
    std::vector<Point> pixels;
    findNonZero(edges, pixels);
    Mat table;
    LineSpaceDetector::create(1, 0, METHOD_CASCADED, cellSize, backend)->compute(edges, table);
    for (int s = 0; s < table.rows; s += step)
        for (int e = s + 1; e < table.cols; e += step)
        {
            if (table.at<int>(s, e) == 0)
                continue;
            const Strip strip(cascade, last, s, e);
            int inside = 0;
            for (size_t i = 0; i < pixels.size(); ++i)
                inside += strip.contains(pixels[i].x, pixels[i].y);
            ASSERT_LE(table.at<int>(s, e), inside) << edges.size() << ", cellSize " << cellSize
                                                   << ", chord (" << s << ", " << e << ")";
        }
}

TEST_P(Linespace_Deviation, random_maps)
{
    checkStrips(randomEdges(Size(40, 31), 0.05, 1), 2, GetParam(), 1);
    checkStrips(randomEdges(Size(33, 64), 0.02, 2), 3, GetParam(), 1);
    checkStrips(randomEdges(Size(120, 90), 0.02, 3), 8, GetParam(), 3);
}

TEST_P(Linespace_Deviation, photographs)
{
    checkStrips(photographEdges("building.jpg", 256), 8, GetParam(), 23);
    checkStrips(photographEdges("sudoku.png", 200), 4, GetParam(), 19);
    checkStrips(photographEdges("home.jpg", 256), 16, GetParam(), 23);
}

INSTANTIATE_TEST_CASE_P(/**/, Linespace_Deviation, LINESPACE_TEST_BACKENDS);

} // namespace
} // namespace opencv_test
