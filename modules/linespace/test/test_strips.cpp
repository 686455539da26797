// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// METHOD_STRIPS (doc/algorithm.md, section 3b): its lines are maxima of exact votes, the same on every
// back end, and most of those that METHOD_EXACT finds.

#include "test_precomp.hpp"

#include "brute_force.hpp"
#include "generators.hpp"
#include "test_support.hpp"

#include <cfloat>
#include <climits>

namespace opencv_test {
namespace {

using namespace generators;
using namespace cv::linespace;

typedef std::vector<Vec3f> Lines;

const int hosts[] = {BACKEND_REFERENCE, BACKEND_CPU};

//! What may differ from call to call.
struct Case
{
    Size size;
    double density;
    int threshold, maxLines;
    bool weighted, oriented, masked, explained;
    double minTheta, maxTheta;
};

std::ostream& operator<<(std::ostream& out, const Case& c)
{
    return out << c.size << ", density " << c.density << ", threshold " << c.threshold
               << ", maxLines " << c.maxLines << (c.weighted ? ", weights" : "")
               << (c.oriented ? ", directions" : "") << (c.masked ? ", mask" : "")
               << (c.explained ? ", explained" : "") << ", angles " << c.minTheta << " to "
               << c.maxTheta;
}

Case randomCase(RNG& rng, int most)
{
    Case c;
    c.size = Size(rng.uniform(1, most), rng.uniform(1, most));
    c.density = rng.uniform(0., 0.5);
    const int side = std::min(c.size.width, c.size.height);
    c.threshold = rng.uniform(0, 4) == 0 ? 0 : std::max(1, cvRound(side * rng.uniform(0.2, 0.8)));
    c.maxLines = rng.uniform(0, 4) == 0 ? 0 : rng.uniform(1, 50);
    c.weighted = rng.uniform(0, 5) == 0;
    c.oriented = rng.uniform(0, 3) == 0;
    c.masked = rng.uniform(0, 4) == 0;
    c.explained = rng.uniform(0, 3) == 0;
    const bool hasAngles = rng.uniform(0, 3) == 0;
    c.minTheta = hasAngles ? rng.uniform(-2., 2.) : 0;
    c.maxTheta = hasAngles ? c.minTheta + rng.uniform(0., 2.) : CV_PI;
    return c;
}

Mat1b edgesOf(const Case& c, unsigned seed)
{
    Mat1b edges = randomEdges(c.size, c.density, seed);
    RNG rng(seed);
    for (int i = 0; i < 3; ++i)
        line(edges, Point(rng.uniform(0, c.size.width), rng.uniform(0, c.size.height)),
             Point(rng.uniform(0, c.size.width), rng.uniform(0, c.size.height)), 255);
    return edges;
}

Ptr<LineSpaceDetector> detectorFor(const Case& c, int backend)
{
    Ptr<LineSpaceDetector> detector =
        LineSpaceDetector::create(c.threshold, c.maxLines, METHOD_STRIPS, 8, backend);
    detector->setEdgeWeights(c.weighted);
    detector->setSelection(c.explained ? SELECT_EXPLAIN : SELECT_PEAKS);
    detector->setAngleRange(c.minTheta, c.maxTheta);
    if (c.masked)
        detector->setMask(randomEdges(c.size, 0.8, 5));
    return detector;
}

Lines detect(LineSpaceDetector& detector, const Case& c, const Mat& edges)
{
    Lines lines;
    if (c.oriented)
        detector.detect(edges, noArray(), noArray(), lines);
    else
        detector.detect(edges, lines);
    return lines;
}

TEST(Linespace_Strips, the_reference_gives_the_same_lines)
{
    RNG rng(1);
    size_t found = 0;
    for (int i = 0; i < 600; ++i)
    {
        const Case c = randomCase(rng, i < 300 ? 21 : i < 550 ? 90 : 290);
        const Mat1b edges = edgesOf(c, i);
        const Lines expected = detect(*detectorFor(c, BACKEND_REFERENCE), c, edges);
        const Ptr<LineSpaceDetector> detector = detectorFor(c, BACKEND_CPU);
        ASSERT_EQ(expected, detect(*detector, c, asWindow(edges))) << i << ": " << c;
        EXPECT_EQ(BACKEND_CPU, detector->getActiveBackend());
        found += expected.size();
    }
    EXPECT_GT(found, 5000u);
}

TEST(Linespace_Strips, photographs)
{
    const char* const names[] = {"building.jpg", "sudoku.png"};
    for (const char* name : names)
        for (int oriented = 0; oriented < 2; ++oriented)
        {
            const Mat1b edges = photographEdges(name, 500);
            const Case c = {edges.size(), 0, 0, 60, false, oriented == 1, false, true, 0, CV_PI};
            const Lines expected = detect(*detectorFor(c, BACKEND_REFERENCE), c, edges);
            EXPECT_GT(expected.size(), 5u);
            EXPECT_EQ(expected, detect(*detectorFor(c, BACKEND_CPU), c, edges)) << name;
        }
}

TEST(Linespace_Strips, any_number_of_threads)
{
    std::vector<Vec2d> drawn;
    const Mat1b edges = linesInNoise(Size(300, 260), 8, 0.05, 7, drawn);
    for (int oriented = 0; oriented < 2; ++oriented)
    {
        const Case c = {edges.size(), 0, 40, 60, false, oriented == 1, false, true, 0, CV_PI};
        const Lines expected = detect(*detectorFor(c, BACKEND_REFERENCE), c, edges);
        EXPECT_GT(expected.size(), 5u);
        for (int threads = 1; threads <= 5; threads += 2)
        {
            const ThreadCount count(threads);
            EXPECT_EQ(expected, detect(*detectorFor(c, BACKEND_CPU), c, edges))
                << threads << " threads";
        }
    }
}

//! One detector for images of several sizes and kinds in turns: nothing of one is left in the next.
TEST(Linespace_Strips, memory_is_used_again)
{
    RNG rng(2);
    const Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(0, 30, METHOD_STRIPS);
    for (int i = 0; i < 60; ++i)
    {
        Case c = randomCase(rng, 150);
        c.masked = c.explained = false;
        c.minTheta = 0;
        c.maxTheta = CV_PI;
        c.maxLines = 30;
        const Mat1b edges = edgesOf(c, i);
        detector->setThreshold(c.threshold);
        detector->setEdgeWeights(c.weighted);
        ASSERT_EQ(detect(*detectorFor(c, BACKEND_CPU), c, edges), detect(*detector, c, edges))
            << i << ": " << c;
        if (i % 10 == 0)
            detector->clear();
    }
}

//! The lines as chords, which have the votes of brute force and no neighbour on the ring that has more.
TEST(Linespace_Strips, lines_are_maxima_of_exact_votes)
{
    RNG rng(3);
    int checked = 0;
    for (int i = 0; i < 60; ++i)
    {
        Case c = randomCase(rng, 60);
        c.oriented = c.masked = c.explained = false;
        c.minTheta = 0;
        c.maxTheta = CV_PI;
        const Mat1b edges = edgesOf(c, 100 + i);
        const Ptr<LineSpaceDetector> detector = detectorFor(c, BACKEND_CPU);
        detector->setRefine(REFINE_NONE);
        const Lines lines = detect(*detector, c, edges);
        EXPECT_EQ(c.size, detector->getFrameSize());
        EXPECT_EQ(1, detector->getLevelCount());
        EXPECT_EQ(c.size, detector->getLevelCellSize(0));
        EXPECT_EQ(Size(1, 1), detector->getLevelGridSize(0));
        const int points = brute::borderCount(c.size), reach = std::min(2, (points - 1) / 2);
        for (size_t j = 0; j < lines.size(); ++j)
        {
            brute::Candidate own;
            ASSERT_TRUE(brute::chordOf(c.size, lines[j], own.s, own.e)) << lines[j] << ", " << c;
            own.votes = brute::chordVotes(edges, c.size, own.s, own.e, c.weighted);
            ASSERT_EQ(own.votes, (int)lines[j][2]) << c;
            EXPECT_GT(own.votes, c.threshold);
            for (int di = -reach; di <= reach; ++di)
                for (int dj = -reach; dj <= reach; ++dj)
                {
                    const int p = (own.s + di + points) % points,
                              q = (own.e + dj + points) % points;
                    brute::Candidate other = {std::min(p, q), std::max(p, q), 0};
                    if (!brute::isChord(c.size, other.s, other.e))
                        continue;
                    other.votes = brute::chordVotes(edges, c.size, other.s, other.e, c.weighted);
                    ASSERT_FALSE(brute::isStronger(other, own)) << c << ", line " << j;
                }
            ++checked;
        }
    }
    EXPECT_GT(checked, 300);
}

//! The share of the lines that have a counterpart within the suppression distance.
double shareFound(const Lines& lines, const Lines& among, Size size)
{
    int found = 0;
    for (size_t i = 0; i < lines.size(); ++i)
    {
        double nearest = DBL_MAX;
        for (size_t j = 0; j < among.size(); ++j)
            nearest = std::min(nearest, brute::endDistance(Vec2d(lines[i][0], lines[i][1]),
                                                           Vec2d(among[j][0], among[j][1]), size));
        found += nearest <= 3;
    }
    return lines.empty() ? 1 : found / (double)lines.size();
}

// All lines of photographs above an eighth of the shorter side, beside those of the exact method: most
// of these are chance, between pixels of texture.
TEST(Linespace_Strips, most_lines_of_the_exact_method_are_found)
{
    const char* const names[] = {"building.jpg", "board.jpg", "home.jpg", "sudoku.png"};
    for (const char* name : names)
    {
        const Mat1b edges = photographEdges(name, 256);
        const int threshold = std::min(edges.cols, edges.rows) / 8;
        Lines exact, strips;
        LineSpaceDetector::create(threshold, 0, METHOD_EXACT)->detect(edges, exact);
        LineSpaceDetector::create(threshold, 0, METHOD_STRIPS)->detect(edges, strips);
        EXPECT_GT(exact.size(), 100u);
        EXPECT_GE(shareFound(exact, strips, edges.size()), 0.88)
            << name << ": " << exact.size() << " and " << strips.size();
    }
}

// Of every angle and on every side, also along diagonals, edges of strips and the border.
TEST(Linespace_Strips, a_line_alone_is_found)
{
    const Size sizes[] = {Size(200, 150), Size(64, 64), Size(65, 300), Size(400, 63),
                          Size(129, 127)};
    RNG rng(4);
    for (const Size& size : sizes)
    {
        int lost = 0;
        for (int drawn = 0; drawn < 60;)
        {
            const double theta = drawn % 6 == 0   ? CV_PI / 4 * rng.uniform(0, 4)
                                 : drawn % 6 == 1 ? rng.uniform(0, 2) * CV_PI / 2
                                                  : rng.uniform(0., CV_PI);
            const Point through(rng.uniform(0, size.width), rng.uniform(0, size.height));
            const Vec2d line(through.x * std::cos(theta) + through.y * std::sin(theta), theta);
            Mat1b edges(size, (uchar)0);
            addLine(edges, line[0], line[1]);
            const int pixels = countNonZero(edges);
            if (pixels < 30)
                continue;
            ++drawn;
            Lines lines;
            LineSpaceDetector::create(pixels * 7 / 10, 0, METHOD_STRIPS)->detect(edges, lines);
            double nearest = DBL_MAX;
            for (size_t i = 0; i < lines.size(); ++i)
                nearest = std::min(nearest,
                                   brute::endDistance(line, Vec2d(lines[i][0], lines[i][1]), size));
            lost += nearest > 1.5;
        }
        // Of a line of one pixel the maxima are narrow, and where it comes to may be one beside.
        EXPECT_LE(lost, 2) << size;
    }
}

TEST(Linespace_Strips, noise_gives_nearly_nothing)
{
    const double densities[] = {0.01, 0.05, 0.2, 0.5, 0.9};
    size_t found = 0;
    for (int i = 0; i < 20; ++i)
    {
        Lines lines;
        LineSpaceDetector::create(0, 0, METHOD_STRIPS)
            ->detect(randomEdges(Size(110, 90), densities[i % 5], 50 + i), lines);
        found += lines.size();
    }
    EXPECT_LE(found, 20u);
}

TEST(Linespace_Strips, tables_are_those_of_the_cascade)
{
    const Mat1b edges = randomEdges(Size(70, 45), 0.2, 1);
    const Ptr<LineSpaceDetector> cascade = LineSpaceDetector::create(10, 5, METHOD_CASCADED, 4),
                                 strips = LineSpaceDetector::create(10, 5, METHOD_STRIPS, 4);
    Lines lines;
    strips->detect(edges, lines);
    Mat expected, actual;
    for (int level = -1; level < 3; ++level)
    {
        if (level < 0)
        {
            cascade->compute(edges, expected);
            strips->compute(edges, actual);
        }
        else
        {
            cascade->computeLevel(edges, level, expected);
            strips->computeLevel(edges, level, actual);
        }
        EXPECT_EQ(0, cvtest::norm(expected, actual, NORM_INF));
        EXPECT_EQ(cascade->getFrameSize(), strips->getFrameSize());
        EXPECT_EQ(cascade->getLevelCount(), strips->getLevelCount());
    }
    Lines again;
    strips->detect(edges, again);
    EXPECT_EQ(lines, again);
    EXPECT_EQ(edges.size(), strips->getFrameSize());
}

TEST(Linespace_Strips, what_it_cannot_do_is_refused)
{
    const Mat1b edges = randomEdges(Size(40, 30), 0.3, 1);
    const Vec3f sentinel(1, 2, 3);
    Lines lines(1, sentinel);
    const std::vector<std::string> words = {"METHOD_CASCADED"};
    const Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(8, 5, METHOD_STRIPS);
    const auto call = [&]()
    {
        detector->detect(edges, lines);
    };
    const int radii[] = {0, 3, 64};
    for (int radius : radii)
    {
        detector->setSuppressionRadius(radius);
        EXPECT_EQ("", wrongException(call, words)) << radius;
    }
    detector->setSuppressionRadius(1);
    const int rules[] = {SUPPRESS_BLOCKS, SUPPRESS_GREEDY};
    for (int rule : rules)
    {
        detector->setSuppression(rule);
        EXPECT_EQ("", wrongException(call, words)) << rule;
    }
    detector->setSuppression(SUPPRESS_RING);
    const int devices[] = {BACKEND_OPENCL, BACKEND_OPENGL};
    for (int device : devices)
    {
        detector->setBackend(device);
        EXPECT_EQ("", wrongException(call, words)) << device;
    }
    EXPECT_EQ(Lines(1, sentinel), lines);
    detector->setBackend(BACKEND_AUTO);
    EXPECT_NO_THROW(call());
    EXPECT_NE(Lines(1, sentinel), lines);
    // An image on a device is read by the host.
    Lines fromDevice;
    detector->detect(edges.getUMat(ACCESS_READ), fromDevice);
    EXPECT_EQ(lines, fromDevice);
    EXPECT_EQ(BACKEND_CPU, detector->getActiveBackend());
}

TEST(Linespace_Strips, memory_limit)
{
    const Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(200, 5, METHOD_STRIPS);
    detector->setMemoryLimit(4);
    Lines lines;
    detector->detect(Mat1b(Size(400, 400), (uchar)0), lines);
    EXPECT_EQ("",
              wrongException([&]() { detector->detect(Mat1b(Size(1000, 1000), (uchar)0), lines); },
                             {"memoryLimit", "1000 x 1000"}));
    // Places in tables are counted by int, whatever the limit.
    detector->setMemoryLimit(INT_MAX);
    EXPECT_EQ("", wrongException([&]() { detector->detect(Mat1b(1, 200000, (uchar)0), lines); },
                                 {"edges", "200000 x 1", "METHOD_CASCADED"}));
}

} // namespace
} // namespace opencv_test
