// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Oriented voting (doc/algorithm.md, section 6): detect with gradients counts the edge pixels whose
// direction fits the chord, or in the cascade its part in a cell of level 0.

#include "test_precomp.hpp"

#include "brute_force.hpp"
#include "expected_lines.hpp"
#include "generators.hpp"
#include "test_support.hpp"

namespace opencv_test {
namespace {

using namespace generators;

Lines detectOriented(LineSpaceDetector& detector, const Mat& edges, InputArray dx, InputArray dy)
{
    Lines lines;
    detector.detect(edges, dx, dy, lines);
    return lines;
}

struct Gradient
{
    Mat dx, dy;
};

//! CV_16SC1: also 0, the ends of the range, and multiples of 45 degrees. CV_32FC1: any magnitude.
//! Half of them next to where the tolerance of some bin ends.
Gradient randomGradient(const Size& size, int type, unsigned seed, double tolerance = 22.5)
{
    RNG rng(seed * 7919 + 3);
    Gradient gradient = {Mat(size, type), Mat(size, type)};
    const int special[][2] = {{0, 0},           {1, 0},          {0, -3}, {5, 5},
                              {-32768, -32768}, {32767, -32768}, {-1, 1}, {0, 32767}};
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
        {
            const int kind = rng.uniform(0, 24);
            double angle = rng.uniform(0., 2 * CV_PI);
            if (rng.uniform(0, 2))
                angle = (rng.uniform(0, 32) + 0.5) * CV_PI / 16 + CV_PI / 2 +
                        tolerance * CV_PI / 180 + rng.uniform(-5e-5, 5e-5);
            if (type == CV_16SC1)
            {
                const double length = std::exp(rng.uniform(0., 10.));
                gradient.dx.at<short>(y, x) =
                    (short)(kind < 8 ? special[kind][0] : length * std::cos(angle));
                gradient.dy.at<short>(y, x) =
                    (short)(kind < 8 ? special[kind][1] : length * std::sin(angle));
            }
            else
            {
                const double length = kind == 0 ? 0 : std::exp(rng.uniform(-80., 80.));
                gradient.dx.at<float>(y, x) = (float)(length * std::cos(angle));
                gradient.dy.at<float>(y, x) = (float)(length * std::sin(angle));
            }
        }
    return gradient;
}

//! The structure tensor of doc/algorithm.md, 6, pixel by pixel.
Gradient structureTensor(const Mat& edges)
{
    const auto at = [&](int x, int y)
    {
        return brute::pixelValue(edges, Point(x, y));
    };
    Gradient gradient = {Mat::zeros(edges.size(), CV_32FC1), Mat::zeros(edges.size(), CV_32FC1)};
    for (int y = 0; y < edges.rows; ++y)
        for (int x = 0; x < edges.cols; ++x)
        {
            double xx = 0, xy = 0, yy = 0;
            for (int v = y - 3; v <= y + 3; ++v)
                for (int u = x - 3; u <= x + 3; ++u)
                {
                    double gx = 0, gy = 0;
                    for (int i = -1; i <= 1; ++i)
                        for (int j = -1; j <= 1; ++j)
                        {
                            gx += i * (2 - std::abs(j)) * at(u + i, v + j);
                            gy += j * (2 - std::abs(i)) * at(u + i, v + j);
                        }
                    xx += gx * gx;
                    xy += gx * gy;
                    yy += gy * gy;
                }
            const double length = std::sqrt((xx - yy) * (xx - yy) + 4 * xy * xy);
            gradient.dx.at<float>(y, x) = (float)(xx >= yy ? length + (xx - yy) : 2 * xy);
            gradient.dy.at<float>(y, x) = (float)(xx >= yy ? 2 * xy : length - (xx - yy));
        }
    return gradient;
}

//! Gradients across drawn lines; any direction elsewhere.
Mat1b orientedScene(const Size& size, int count, double noise, unsigned seed,
                    std::vector<Vec2d>& lines, Gradient& gradient)
{
    const Mat1b edges = linesInNoise(size, count, noise, seed, lines);
    gradient = randomGradient(size, CV_32FC1, seed);
    for (size_t i = 0; i < lines.size(); ++i)
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                if (std::abs(x * std::cos(lines[i][1]) + y * std::sin(lines[i][1]) - lines[i][0]) <
                    1)
                {
                    gradient.dx.at<float>(y, x) = (float)std::cos(lines[i][1]);
                    gradient.dy.at<float>(y, x) = (float)std::sin(lines[i][1]);
                }
    return edges;
}

TEST(Linespace_BruteForce, direction_is_the_angle_but_for_rounded_constants)
{
    RNG rng(1);
    for (int i = 0; i < 20000; ++i)
    {
        const Point2d gradient(rng.uniform(-2000, 2001), rng.uniform(-2000, 2001));
        if (gradient.x == 0 && gradient.y == 0)
            continue;
        const double edge = std::atan2(gradient.x, -gradient.y); // along the edge
        const double tolerance = rng.uniform(1., 75.);
        for (int bin = 0; bin < 16; ++bin)
        {
            const double turn = std::abs(std::remainder(edge - (bin + 0.5) * CV_PI / 16, CV_PI));
            const double margin = turn - tolerance * CV_PI / 180;
            if (std::abs(margin) < 3e-4)
                continue;
            ASSERT_EQ(margin < 0, brute::votesForBin(gradient, bin, tolerance))
                << gradient << ", bin " << bin << ", tolerance " << tolerance;
        }
        const int bin = brute::directionBin(brute::Doubled((int64)gradient.x, (int64)gradient.y));
        double angle = std::atan2(gradient.y, gradient.x);
        if (angle < 0)
            angle += CV_PI;
        const double place = angle / (CV_PI / 16);
        ASSERT_TRUE((int)place == bin || std::abs(place - cvRound(place)) < 1e-3) << gradient;
    }
}

class Linespace_Oriented : public testing::TestWithParam<tuple<int, int>> // back end, method
{
protected:
    int backend() const { return get<0>(GetParam()); }
    int method() const { return get<1>(GetParam()); }
};

// Neighbours of a chord may be in the next bin, whose bits are in the other byte.
TEST_P(Linespace_Oriented, candidates_climb)
{
    const Size sizes[] = {Size(46, 37), Size(270, 12), Size(12, 270)};
    for (int i = 0; i < 6; ++i)
    {
        const Size size = sizes[i % 3];
        const bool weighted = i >= 3;
        const double tolerance = 61.5;
        const Mat1b edges = randomEdges(size, 0.8, i);
        const Gradient gradient = randomGradient(size, CV_16SC1, i, tolerance);
        const Selection selection(edges, method(), 4, weighted,
                                  brute::directions(gradient.dx, gradient.dy, tolerance));
        Ptr<LineSpaceDetector> detector = createPlain(method(), 4, backend());
        detector->setOrientationTolerance(tolerance);
        detector->setEdgeWeights(weighted);
        for (int radius = 1; radius <= 2; ++radius)
        {
            detector->setSuppressionRadius(radius);
            detector->setThreshold(std::max(size.width, size.height) / 4 * (weighted ? 128 : 1));
            expectChords(detectOriented(*detector, edges, gradient.dx, gradient.dy),
                         selection.select(detector->getThreshold(),
                                          method() == METHOD_EXACT ? 1 : 0, THIN_RING, radius),
                         selection.frame, format("case %d, radius %d", i, radius));
            if (HasFatalFailure())
                return;
        }
    }
}

TEST_P(Linespace_Oriented, every_chord_above_the_threshold)
{
    const double tolerances[] = {2, 22.5, 61.5, 90};
    const Size sizes[] = {Size(1, 1), Size(7, 2), Size(46, 37), Size(24, 31)};
    for (int i = 0; i < 16; ++i)
    {
        const double tolerance = tolerances[i % 4];
        const Size size = sizes[i / 4];
        const bool weighted = i % 3 == 2;
        const Mat1b edges = i / 4 == 2 ? smallScene(i) : randomEdges(size, 0.7, i);
        const Gradient gradient =
            randomGradient(size, (i + i / 4) % 2 ? CV_32FC1 : CV_16SC1, i, tolerance);
        const Selection selection(edges, method(), 4, weighted,
                                  brute::directions(gradient.dx, gradient.dy, tolerance));
        Ptr<LineSpaceDetector> detector = createPlain(method(), 4, backend());
        detector->setOrientationTolerance(tolerance);
        detector->setEdgeWeights(weighted);
        // With the ratio 1 a chord needs as many votes in the cascade: shows the cascade's own.
        const double ratios[] = {0, 1};
        const int thresholds[] = {1, 3, 6, 11};
        for (int j = 0; j < 8; ++j)
        {
            const int threshold = thresholds[j / 2] * (weighted ? 128 : 1);
            detector->setThreshold(threshold);
            detector->setCandidateRatio(ratios[j % 2]);
            expectChords(detectOriented(*detector, edges, gradient.dx, gradient.dy),
                         selection.select(threshold, method() == METHOD_EXACT ? 1 : ratios[j % 2],
                                          THIN_NOT, 0),
                         selection.frame, format("case %d, threshold %d", i, threshold));
            if (HasFatalFailure())
                return;
        }
    }
}

TEST_P(Linespace_Oriented, kinds_of_arrays)
{
    const Mat1b edges = smallScene(3);
    const Gradient gradient = randomGradient(edges.size(), CV_16SC1, 3);
    Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(5, 0, method(), 4, backend());
    const Lines expected = detectOriented(*detector, edges, gradient.dx, gradient.dy);
    ASSERT_GE(expected.size(), 2u);
    Mat wide(edges.rows + 2, edges.cols + 5, CV_16SC1, Scalar(7));
    Mat window = wide(Rect(3, 1, edges.cols, edges.rows));
    gradient.dx.copyTo(window);
    expectSameLines(detectOriented(*detector, asWindow(edges), window, gradient.dy), expected,
                    "window");
    UMat dx, dy;
    gradient.dx.copyTo(dx);
    gradient.dy.copyTo(dy);
    expectSameLines(detectOriented(*detector, edges, dx, dy), expected, "UMat");
}

TEST_P(Linespace_Oriented, zero_gradients_and_a_right_angle_vote_for_all)
{
    const Mat1b edges = smallScene(5);
    Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(9, 0, method(), 4, backend());
    detector->setRefine(REFINE_NONE); // the position follows the gradients at any tolerance
    const Lines expected = detectLines(*detector, edges);
    ASSERT_GT(expected.size(), 3u);
    const Mat zero = Mat::zeros(edges.size(), CV_32FC1);
    expectSameLines(detectOriented(*detector, edges, zero, zero), expected, "zero");
    const Gradient gradient = randomGradient(edges.size(), CV_16SC1, 5);
    ASSERT_NE(expected, detectOriented(*detector, edges, gradient.dx, gradient.dy));
    detector->setOrientationTolerance(90);
    expectSameLines(detectOriented(*detector, edges, gradient.dx, gradient.dy), expected, "90");
    expectSameLines(detectLines(*detector, edges), expected, "without gradients afterwards");
}

TEST_P(Linespace_Oriented, estimated_from_the_edge_map)
{
    std::vector<Vec2d> drawn;
    for (unsigned seed = 1; seed <= 4; ++seed)
    {
        const Mat1b edges = linesInNoise(Size(120, 90), 5, 0.03, seed, drawn);
        Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(15, 0, method(), 8, backend());
        detector->setRefine(REFINE_NONE); // estimated gradients do not tell the position
        const Gradient gradient = structureTensor(edges);
        const Lines expected = detectOriented(*detector, edges, gradient.dx, gradient.dy);
        ASSERT_GE(expected.size(), 5u);
        expectSameLines(detectOriented(*detector, edges, noArray(), noArray()), expected,
                        format("seed %d", seed));
    }
}

TEST_P(Linespace_Oriented, lines_in_clutter)
{
    const Size size(160, 120);
    size_t plain = 0, oriented = 0;
    for (unsigned seed = 1; seed <= 4; ++seed)
    {
        std::vector<Vec2d> drawn;
        Gradient gradient;
        const Mat1b edges = orientedScene(size, 6, 0.2, seed, drawn, gradient);
        Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(45, 0, method(), 8, backend());
        const Lines lines = detectOriented(*detector, edges, gradient.dx, gradient.dy);
        for (size_t i = 0; i < drawn.size(); ++i)
        {
            double nearest = DBL_MAX;
            for (size_t j = 0; j < lines.size(); ++j)
                nearest = std::min(
                    nearest, brute::endDistance(drawn[i], Vec2d(lines[j][0], lines[j][1]), size));
            EXPECT_LT(nearest, 1.5) << "seed " << seed << ", line " << drawn[i];
        }
        oriented += lines.size();
        plain += detectLines(*detector, edges).size();
    }
    EXPECT_LT(oriented, 60u); // 24 are there
    EXPECT_GT(plain, 2 * oriented);
}

// The rule takes the density of the pixels that vote for the chord's bin.
TEST_P(Linespace_Oriented, noise_gives_nearly_nothing)
{
    const double densities[] = {0.01, 0.05, 0.2, 0.5, 0.9};
    size_t lines = 0, found = 0;
    for (int i = 0; i < 20; ++i)
    {
        const Size size(110, 90);
        Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(0, 0, method(), 8, backend());
        Mat1b edges = randomEdges(size, densities[i % 5], 50 + i);
        Gradient gradient = randomGradient(size, CV_16SC1, i);
        lines += detectOriented(*detector, edges, gradient.dx, gradient.dy).size();
        edges.row(40).setTo(255);
        for (int x = 0; x < size.width; x += 5)
            edges(40, x) = 0;
        gradient.dx.row(40).setTo(0);
        gradient.dy.row(40).setTo(-9);
        const Lines strongest = detectOriented(*detector, edges, gradient.dx, gradient.dy);
        found += !strongest.empty() &&
                 brute::endDistance(Vec2d(40, CV_PI / 2), Vec2d(strongest[0][0], strongest[0][1]),
                                    size) < 1.5;
    }
    EXPECT_LE(lines, 20u); // expected: less than 1 for each image
    EXPECT_EQ(20u, found); // also at 0.9 of the pixels, where no line is significant without
}

// Directions that were estimated follow the pixels on the chord: no evidence against chance.
TEST_P(Linespace_Oriented, noise_gives_nearly_nothing_by_estimated_directions)
{
    const double densities[] = {0.01, 0.05, 0.2, 0.5, 0.9};
    size_t lines = 0;
    for (int i = 0; i < 20; ++i)
    {
        Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(0, 0, method(), 8, backend());
        const Mat1b edges = randomEdges(Size(110, 90), densities[i % 5], 50 + i);
        lines += detectOriented(*detector, edges, noArray(), noArray()).size();
    }
    EXPECT_LE(lines, 20u);
}

// A line takes away the pixels of its own direction, not those of the line that it crosses: with
// them the other one has just the votes that it needs. A chord next to the end of its bin, whose
// refined line may lie in the next one, takes its own pixels all the same.
TEST_P(Linespace_Oriented, explained_pixels_are_those_of_the_direction)
{
    const Size size(90, 70);
    Mat1b edges(size, (uchar)0);
    Gradient gradient = {Mat::zeros(size, CV_32FC1), Mat::zeros(size, CV_32FC1)};
    edges.row(30).setTo(255);
    gradient.dy.row(30).setTo(1);
    edges.col(50).setTo(255);
    gradient.dx.col(50).setTo(1);
    gradient.dy.col(50).setTo(0);
    Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(69, 0, method(), 8, backend());
    detector->setSelection(SELECT_EXPLAIN);
    Lines lines = detectOriented(*detector, edges, gradient.dx, gradient.dy);
    ASSERT_EQ(2u, lines.size());
    EXPECT_EQ(89, lines[0][2]); // all but the pixel of the crossing
    EXPECT_EQ(70, lines[1][2]);

    for (double tilt = -0.03; tilt < 0.031; tilt += 0.002)
    {
        const double theta = CV_PI / 2 + tilt;
        Mat1b one(size, (uchar)0);
        addLine(one, 30 * std::sin(theta) + 45 * std::cos(theta), theta);
        // Of one bin alone: at 6 degrees the next one's chords do not see them.
        const double middle = tilt < 0 ? CV_PI / 2 - CV_PI / 32 : CV_PI / 2 + CV_PI / 32;
        gradient.dx.setTo(std::cos(middle));
        gradient.dy.setTo(std::sin(middle));
        detector->setOrientationTolerance(6);
        detector->setThreshold(20);
        detector->setSuppressionDistance(0);
        lines = detectOriented(*detector, one, gradient.dx, gradient.dy);
        EXPECT_EQ(1u, lines.size()) << "tilt " << tilt;
    }
}

// Pixels beside a line that have another direction do not pull at it.
TEST_P(Linespace_Oriented, refinement_looks_at_the_same_pixels)
{
    const Size size(90, 70);
    const double rho = 47.3, theta = 1.1;
    Mat1b edges(size, (uchar)0);
    addLine(edges, rho, theta);
    Gradient gradient = {Mat(size, CV_32FC1, Scalar(std::cos(theta))),
                         Mat(size, CV_32FC1, Scalar(std::sin(theta)))};
    Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(20, 1, method(), 8, backend());
    const Lines expected = detectOriented(*detector, edges, gradient.dx, gradient.dy);
    ASSERT_EQ(1u, expected.size());
    Mat1b beside(size, (uchar)0);
    addLine(beside, rho + 0.9, theta);
    beside.setTo(0, edges);
    beside.colRange(size.width / 2, size.width).setTo(0);
    gradient.dx.setTo(-std::sin(theta), beside);
    gradient.dy.setTo(std::cos(theta), beside);
    const Mat1b both = edges | beside;
    expectSameLines(detectOriented(*detector, both, gradient.dx, gradient.dy), expected, "beside");
    EXPECT_NE(expected, detectLines(*detector, both));
}

TEST_P(Linespace_Oriented, the_same_on_every_thread_count_and_back_end)
{
    std::vector<Vec2d> drawn;
    Gradient gradient;
    const Mat1b edges = orientedScene(Size(230, 170), 7, 0.1, 3, drawn, gradient);
    for (int threshold = 0; threshold <= 30; threshold += 30)
        for (int selection = SELECT_PEAKS; selection <= SELECT_EXPLAIN; ++selection)
        {
            Ptr<LineSpaceDetector> reference =
                LineSpaceDetector::create(threshold, 0, method(), 8, BACKEND_REFERENCE);
            Ptr<LineSpaceDetector> detector =
                LineSpaceDetector::create(threshold, 0, method(), 8, backend());
            reference->setSelection(selection);
            detector->setSelection(selection);
            const Lines expected = detectOriented(*reference, edges, gradient.dx, gradient.dy);
            ASSERT_GE(expected.size(), 5u);
            const int threads[] = {1, 2, 5};
            for (int j = 0; j < 3; ++j)
            {
                ThreadCount count(threads[j]);
                expectSameLines(detectOriented(*detector, edges, gradient.dx, gradient.dy),
                                expected,
                                format("%d threads, threshold %d", threads[j], threshold));
            }
        }
}

// The lines of a bad input are those from before it, and so is the detector.
TEST_P(Linespace_Oriented, bad_gradients)
{
    const Mat1b edges = smallScene(6);
    const Size size = edges.size();
    Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(9, 0, method(), 4, backend());
    const Gradient good = randomGradient(size, CV_32FC1, 6);
    const Lines expected = detectOriented(*detector, edges, good.dx, good.dy);
    const auto refused = [&](const Mat& dx, const Mat& dy, const std::vector<std::string>& words)
    {
        Lines lines(2, Vec3f(1, 2, 3));
        EXPECT_EQ("", wrongException([&]() { detector->detect(edges, dx, dy, lines); }, words));
        EXPECT_EQ(Lines(2, Vec3f(1, 2, 3)), lines);
        expectSameLines(detectOriented(*detector, edges, good.dx, good.dy), expected, "afterwards");
    };
    refused(Mat(), good.dy, {"dx", "empty"});
    refused(good.dx, Mat(), {"dy", "empty"});
    const int types[] = {CV_8UC1, CV_8SC1, CV_16UC1, CV_32SC1, CV_64FC1, CV_32FC2, CV_16SC3};
    for (size_t i = 0; i < sizeof(types) / sizeof(types[0]); ++i)
    {
        const Mat wrong(size, types[i], Scalar::all(1));
        refused(wrong, good.dy, {"dx", typeToString(types[i])});
        refused(good.dx, wrong, {"dy", typeToString(types[i])});
    }
    refused(good.dx, Mat(size, CV_16SC1, Scalar(1)), {"dx", "dy", "CV_16SC1", "CV_32FC1"});
    refused(Mat(size.width, size.height, CV_32FC1, Scalar(1)), good.dy, {"dx", "37", "46"});
    refused(good.dx, Mat(size.height + 1, size.width, CV_32FC1, Scalar(1)), {"dy", "46", "38"});
    const float bad[] = {std::numeric_limits<float>::quiet_NaN(),
                         std::numeric_limits<float>::infinity(),
                         -std::numeric_limits<float>::infinity()};
    std::vector<Point> voting;
    for (int i = 0; i < size.area(); ++i)
        if (edges(i / size.width, i % size.width))
            voting.push_back(Point(i % size.width, i / size.width));
    for (int i = 0; i < 3; ++i)
    {
        Mat dx = good.dx.clone(), dy = good.dy.clone();
        dx.at<float>(voting[17]) = bad[i];
        refused(dx, good.dy, {"dx", "finite"});
        dy.at<float>(voting.back()) = bad[i];
        refused(good.dx, dy, {"dy", "finite"});
        // Also where there is no edge: the gradients around a line tell its position.
        dx = good.dx.clone();
        dx.setTo(bad[i], edges == 0);
        refused(dx, good.dy, {"dx", "finite"});
    }
}

INSTANTIATE_TEST_CASE_P(/**/, Linespace_Oriented,
                        testing::Combine(LINESPACE_TEST_BACKENDS,
                                         testing::Values((int)METHOD_EXACT, (int)METHOD_CASCADED)));

} // namespace
} // namespace opencv_test
