// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The eight symmetries of the square against METHOD_EXACT (doc/algorithm.md, section 2). A raster
// takes the floor, so it is not symmetric where the exact coordinate is an integer: a tie. What a
// symmetry changes follows from the list of a chord's ties alone, and nothing else may change.

#include "test_precomp.hpp"

#include "brute_force.hpp"
#include "generators.hpp"
#include "test_support.hpp"

namespace opencv_test {
namespace {

using namespace generators;

//! First the flips, then the transposition.
struct Symmetry
{
    const char* name;
    bool flipsX, flipsY, transposes;

    Mat apply(const Mat& edges) const
    {
        Mat out = edges.clone();
        if (flipsX)
            flip(out, out, 1);
        if (flipsY)
            flip(out, out, 0);
        if (transposes)
            cv::transpose(out, out);
        return out;
    }

    brute::Doubled apply(const brute::Doubled& point, const Size& size) const
    {
        const int64 x = flipsX ? 2 * size.width - point.x : point.x;
        const int64 y = flipsY ? 2 * size.height - point.y : point.y;
        return transposes ? brute::Doubled(y, x) : brute::Doubled(x, y);
    }
};

void PrintTo(const Symmetry& symmetry, std::ostream* out)
{
    *out << symmetry.name;
}

const Symmetry symmetries[] = {
    {"transposition", false, false, true},     {"flip of x", true, false, false},
    {"flip of y", false, true, false},         {"half turn", true, true, false},
    {"quarter turn right", false, true, true}, {"quarter turn left", true, false, true},
    {"other transposition", true, true, true}};

typedef testing::TestWithParam<tuple<int, Symmetry>> Linespace_Symmetry;

// Votes of the image of a chord under a symmetry, from its votes and its ties.
int expectedVotes(const Mat& edges, const brute::Doubled& p, const brute::Doubled& q, int votes,
                  const Symmetry& symmetry)
{
    const bool diagonal = std::abs(q.x - p.x) == std::abs(q.y - p.y);
    const bool changesAxis = diagonal && symmetry.transposes;
    const brute::DiagonalRule rule =
        changesAxis ? brute::DIAGONAL_STEPS_Y : brute::DIAGONAL_STEPS_X;
    const bool alongX = brute::stepsAlongX(p, q, rule);
    const bool flipsMinor = alongX ? symmetry.flipsY : symmetry.flipsX;
    // The flipped raster takes the pixel on the other side of a tie.
    const Point otherSide = alongX ? Point(0, -1) : Point(-1, 0);
    const std::vector<brute::Step> steps = brute::raster(p, q, rule);
    int expected = changesAxis ? 0 : votes;
    for (size_t i = 0; i < steps.size(); ++i)
    {
        const Point pixel = steps[i].pixel;
        if (changesAxis)
            expected += brute::pixelValue(edges, pixel);
        if (flipsMinor && steps[i].tie)
            expected +=
                brute::pixelValue(edges, pixel + otherSide) - brute::pixelValue(edges, pixel);
    }
    return expected;
}

TEST_P(Linespace_Symmetry, changes_ties_alone)
{
    const int backend = get<0>(GetParam());
    const Symmetry symmetry = get<1>(GetParam());
    const Size sizes[] = {Size(1, 1),  Size(2, 2),   Size(6, 6),   Size(5, 9),
                          Size(12, 7), Size(13, 13), Size(20, 11), Size(16, 24)};
    int changed = 0, same = 0;
    for (size_t i = 0; i < sizeof(sizes) / sizeof(sizes[0]); ++i)
    {
        const Size size = sizes[i];
        const Mat images[] = {randomEdges(size, 0.3, (unsigned)i), whiteEdges(size)};
        for (int image = 0; image < 2; ++image)
        {
            Ptr<LineSpaceDetector> detector =
                LineSpaceDetector::create(1, 0, METHOD_EXACT, 8, backend);
            Mat before, after;
            detector->compute(images[image], before);
            detector->compute(symmetry.apply(images[image]), after);
            const Size turned = symmetry.transposes ? Size(size.height, size.width) : size;
            ASSERT_EQ(turned, detector->getFrameSize());
            for (int s = 0; s < before.rows; ++s)
                for (int e = 0; e < before.cols; ++e)
                {
                    const brute::Doubled p = brute::borderPoint(size, s),
                                         q = brute::borderPoint(size, e);
                    const int turnedS = brute::borderIndex(turned, symmetry.apply(p, size));
                    const int turnedE = brute::borderIndex(turned, symmetry.apply(q, size));
                    const int votes = before.at<int>(s, e);
                    const int expected = brute::isChord(size, s, e)
                                             ? expectedVotes(images[image], p, q, votes, symmetry)
                                             : 0;
                    ASSERT_EQ(expected, after.at<int>(turnedS, turnedE))
                        << symmetry.name << " of " << size << ", chord (" << s << ", " << e << "), "
                        << backendName(backend);
                    (expected == votes ? same : changed)++;
                }
        }
    }
    EXPECT_GT(same, changed); // most chords have no tie that matters,
    EXPECT_GT(changed, 0);    // but some do
}

INSTANTIATE_TEST_CASE_P(/**/, Linespace_Symmetry,
                        testing::Combine(LINESPACE_TEST_BACKENDS, testing::ValuesIn(symmetries)));

// Transposition alone leaves every chord as it is but the rising and falling diagonals; of these
// the chords with dx = dy land on the neighbouring diagonal, those with dx = -dy on the same
// pixels.
TEST(Linespace_Symmetry_Diagonals, land_on_the_neighbour)
{
    const Size size(9, 7);
    const int points = brute::borderCount(size);
    int neighbours = 0;
    for (int s = 0; s < points; ++s)
        for (int e = 0; e < points; ++e)
        {
            const brute::Doubled p = brute::borderPoint(size, s), q = brute::borderPoint(size, e);
            const int64 dx = q.x - p.x, dy = q.y - p.y;
            if (!brute::isChord(size, s, e) || std::abs(dx) != std::abs(dy))
                continue;
            const std::vector<brute::Step> here = brute::raster(p, q);
            const std::vector<brute::Step> there = brute::raster(p, q, brute::DIAGONAL_STEPS_Y);
            std::set<std::pair<int, int>> herePixels, therePixels;
            for (size_t i = 0; i < here.size(); ++i)
                if (brute::pixelValue(whiteEdges(size), here[i].pixel))
                    herePixels.insert(std::make_pair(here[i].pixel.x, here[i].pixel.y));
            for (size_t i = 0; i < there.size(); ++i)
                if (brute::pixelValue(whiteEdges(size), there[i].pixel))
                    therePixels.insert(std::make_pair(there[i].pixel.x, there[i].pixel.y));
            if (dx == -dy)
            {
                ASSERT_TRUE(herePixels == therePixels) << "chord (" << s << ", " << e << ")";
                continue;
            }
            ++neighbours;
            for (size_t i = 0; i < here.size(); ++i)
                for (size_t j = 0; j < there.size(); ++j)
                    ASSERT_EQ(here[i].pixel.x - here[i].pixel.y + 1,
                              there[j].pixel.x - there[j].pixel.y)
                        << "chord (" << s << ", " << e << ")";
        }
    EXPECT_GT(neighbours, 10);
}

} // namespace
} // namespace opencv_test
