// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The drop-in cv::linespace::HoughLines (doc/algorithm.md, section 8): what a reported line is, and
// that it can stand where cv::HoughLines stood. How many of cv::HoughLines' lines it finds is
// measured in the conformance test.

#include "test_precomp.hpp"

#include "brute_force.hpp"
#include "generators.hpp"
#include "test_support.hpp"

#include <limits>

namespace opencv_test {
namespace {

using namespace generators;

typedef std::vector<Vec3f> Lines;

const double degree = CV_PI / 180;

struct Arguments
{
    Arguments(double rho_, double theta_, int threshold_)
        : rho(rho_), theta(theta_), threshold(threshold_), minTheta(0), maxTheta(CV_PI),
          edgeValue(false)
    {
    }
    double rho, theta;
    int threshold;
    double minTheta, maxTheta;
    bool edgeValue;
};

Lines houghLines(const Mat& edges, const Arguments& a)
{
    Lines lines;
    cv::linespace::HoughLines(edges, lines, a.rho, a.theta, a.threshold, 0, 0, a.minTheta,
                              a.maxTheta, a.edgeValue);
    return lines;
}

// Votes by the definition: pixels at most `distance` from the line. The line is rounded to float,
// and a pixel on the boundary may fall on either side of it: the fewest and the most votes that
// this allows.
void countAround(const std::vector<Point>& pixels, const Mat1b& edges, const Vec3f& line,
                 double distance, bool weighted, double& fewest, double& most)
{
    const double c = std::cos((double)line[1]), s = std::sin((double)line[1]);
    const double rounding =
        1.2e-7 * (edges.cols + edges.rows) * std::max(1.0f, std::abs(line[1])) + 1e-6;
    fewest = most = 0;
    for (size_t i = 0; i < pixels.size(); ++i)
    {
        const double away = std::abs(pixels[i].x * c + pixels[i].y * s - line[0]) - distance;
        const int value = weighted ? edges(pixels[i]) : 1;
        fewest += away < -rounding ? value : 0;
        most += away <= rounding ? value : 0;
    }
}

double nearestLine(const Vec2d& line, const Lines& lines, const Size& size)
{
    double nearest = DBL_MAX;
    for (size_t i = 0; i < lines.size(); ++i)
        nearest =
            std::min(nearest, brute::endDistance(line, Vec2d(lines[i][0], lines[i][1]), size));
    return nearest;
}

// Same cell, over the end of the range too: (rho, theta) and (-rho, theta + pi) are one line.
bool isSameCell(const Vec3f& a, const Vec3f& b, const Arguments& arguments, double near)
{
    for (int halfTurns = -1; halfTurns <= 1; ++halfTurns)
    {
        const double theta = b[1] + halfTurns * CV_PI, rho = halfTurns ? -b[0] : b[0];
        if (std::abs(a[1] - theta) < near * arguments.theta &&
            std::abs(a[0] - rho) < near * arguments.rho)
            return true;
    }
    return false;
}

bool isOrdered(const Vec3f& a, const Vec3f& b)
{
    if (a[2] != b[2])
        return a[2] > b[2];
    return a[1] != b[1] ? a[1] < b[1] : a[0] < b[0];
}

//! Everything that holds for every list of lines.
void checkLines(const Mat1b& edges, const Lines& lines, const Arguments& arguments)
{
    std::vector<Point> pixels;
    findNonZero(edges, pixels);
    const double open =
        arguments.maxTheta - arguments.minTheta >= CV_PI ? arguments.minTheta + CV_PI : DBL_MAX;
    for (size_t i = 0; i < lines.size(); ++i)
    {
        double fewest = 0, most = 0;
        countAround(pixels, edges, lines[i], 0.5 * arguments.rho, arguments.edgeValue, fewest,
                    most);
        ASSERT_GE(lines[i][2], fewest) << "line " << i << " " << lines[i];
        ASSERT_LE(lines[i][2], most) << "line " << i << " " << lines[i];
        ASSERT_GT(lines[i][2], arguments.threshold) << "line " << i;
        ASSERT_GE((double)lines[i][1], arguments.minTheta) << "line " << i;
        ASSERT_LE((double)lines[i][1], arguments.maxTheta) << "line " << i;
        ASSERT_LT((double)lines[i][1], open) << "line " << i;
        ASSERT_TRUE(i == 0 || isOrdered(lines[i - 1], lines[i])) << "line " << i << " " << lines[i];
        for (size_t j = 0; j < i; ++j)
            ASSERT_FALSE(isSameCell(lines[j], lines[i], arguments, 1 + 1e-4))
                << lines[j] << " and " << lines[i];
    }
}

Mat1b scene(unsigned seed = 1)
{
    std::vector<Vec2d> drawn;
    return linesInNoise(Size(150, 110), 6, 0.03, seed, drawn);
}

const double rhos[] = {0.5, 1, 2};
const double thetas[] = {0.25 * degree, 0.5 * degree, degree, 2 * degree};

typedef testing::TestWithParam<tuple<double, double>> Linespace_HoughLines; // rho, theta

TEST_P(Linespace_HoughLines, lines_are_what_they_say)
{
    for (unsigned seed = 1; seed <= 2; ++seed)
        for (int threshold = 30; threshold <= 90; threshold += 30)
        {
            const Mat1b edges = scene(seed);
            const Arguments arguments(get<0>(GetParam()), get<1>(GetParam()), threshold);
            const Lines lines = houghLines(edges, arguments);
            EXPECT_FALSE(lines.empty() && threshold == 30);
            checkLines(edges, lines, arguments);
        }
}

TEST_P(Linespace_HoughLines, photographs)
{
    const char* names[] = {"building.jpg", "sudoku.png"};
    for (int i = 0; i < 2; ++i)
    {
        const Mat1b edges = photographEdges(names[i], 300);
        const Arguments arguments(get<0>(GetParam()), get<1>(GetParam()), 80);
        const Lines lines = houghLines(edges, arguments);
        EXPECT_FALSE(lines.empty()) << names[i];
        checkLines(edges, lines, arguments);
    }
}

TEST_P(Linespace_HoughLines, drawn_lines_are_found)
{
    const double rho = get<0>(GetParam()), theta = get<1>(GetParam());
    for (unsigned seed = 1; seed <= 4; ++seed)
    {
        std::vector<Vec2d> drawn;
        const Mat1b edges = linesInNoise(Size(200, 160), 8, 0.01, seed, drawn);
        // A grid as coarse as 2 degrees leaves less than half of a line's pixels in a band of 0.5.
        const Lines lines =
            houghLines(edges, Arguments(rho, theta, rho < 1 && theta > degree ? 20 : 45));
        for (size_t i = 0; i < drawn.size(); ++i)
        {
            // A drawn line is rounded to pixels: as near as that, and at most a cell away.
            const double allowed = std::max(1.0, rho) + 100 * theta;
            EXPECT_LE(nearestLine(drawn[i], lines, edges.size()), allowed)
                << "seed " << seed << ", line " << drawn[i];
        }
    }
}

// All lines of cv::HoughLines' grid by the definition, (i rho, j theta): each one above the
// threshold is reported or within a cell of a reported one that has at least as many votes.
TEST_P(Linespace_HoughLines, every_line_of_the_grid_is_represented)
{
    const double rho = get<0>(GetParam()), theta = get<1>(GetParam());
    int all = 0, represented = 0;
    for (unsigned seed = 1; seed <= 3; ++seed)
    {
        const Mat1b edges = scene(seed);
        std::vector<Point> pixels;
        findNonZero(edges, pixels);
        const Arguments arguments(rho, theta, 35);
        const Lines lines = houghLines(edges, arguments);
        const int rhoCount = cvCeil((edges.cols + edges.rows) / rho);
        std::vector<int> votes(2 * rhoCount + 1);
        for (int j = 0; j * theta < CV_PI - 0.5 * theta; ++j)
        {
            std::fill(votes.begin(), votes.end(), 0);
            for (size_t i = 0; i < pixels.size(); ++i)
                ++votes[rhoCount + cvRound((pixels[i].x * std::cos(j * theta) +
                                            pixels[i].y * std::sin(j * theta)) /
                                           rho)];
            for (int i = -rhoCount; i <= rhoCount; ++i)
            {
                // Some pixels of the boundary may be counted on its other side.
                if (votes[rhoCount + i] <= arguments.threshold + 3)
                    continue;
                const Vec3f line((float)(i * rho), (float)(j * theta), (float)votes[rhoCount + i]);
                bool isRepresented = false;
                for (size_t k = 0; k < lines.size() && !isRepresented; ++k)
                    isRepresented = isSameCell(lines[k], line, arguments, 1 + 1e-4) &&
                                    lines[k][2] >= line[2] - 3;
                ++all;
                represented += isRepresented;
            }
        }
    }
    ASSERT_GT(all, 20);
    EXPECT_GE(represented, 0.99 * all) << represented << " of " << all;
}

INSTANTIATE_TEST_CASE_P(/**/, Linespace_HoughLines,
                        testing::Combine(testing::ValuesIn(rhos), testing::ValuesIn(thetas)));

// On a map with so many edge pixels the Line Space tells which lines to count: none is lost.
TEST(Linespace_HoughLines_Dense, lines_of_a_dense_map)
{
    const Mat1b edges = randomEdges(Size(160, 160), 0.85, 3);
    std::vector<Point> pixels;
    findNonZero(edges, pixels);
    const Arguments arguments(1, degree, 150);
    const Lines lines = houghLines(edges, arguments);
    checkLines(edges, lines, arguments);
    int all = 0, represented = 0;
    for (int j = 0; j < 180; ++j)
    {
        std::map<int, int> votes;
        for (size_t i = 0; i < pixels.size(); ++i)
            ++votes[cvRound(pixels[i].x * std::cos(j * degree) +
                            pixels[i].y * std::sin(j * degree))];
        for (std::map<int, int>::const_iterator it = votes.begin(); it != votes.end(); ++it)
        {
            if (it->second <= arguments.threshold + 3)
                continue;
            const Vec3f line((float)it->first, (float)(j * degree), (float)it->second);
            bool isRepresented = false;
            for (size_t k = 0; k < lines.size() && !isRepresented; ++k)
                isRepresented =
                    isSameCell(lines[k], line, arguments, 1 + 1e-4) && lines[k][2] >= line[2] - 3;
            ++all;
            represented += isRepresented;
        }
    }
    ASSERT_GT(all, 20);
    EXPECT_EQ(all, represented);
}

TEST(Linespace_HoughLines_Arguments, angle_ranges)
{
    const Mat1b edges = scene(3);
    const double ranges[][2] = {
        {0, 0.5},       {-0.3, 0.4}, {2.8, 3.5}, {-CV_PI / 2, CV_PI / 2}, {1, 6}, {-7, -6.2},
        {0, 2 * CV_PI}, {1, 1},      {20, 21},   {CV_PI / 4, CV_PI / 2}};
    const Lines all = houghLines(edges, Arguments(1, degree, 40));
    for (size_t i = 0; i < sizeof(ranges) / sizeof(ranges[0]); ++i)
    {
        Arguments arguments(1, degree, 40);
        arguments.minTheta = ranges[i][0];
        arguments.maxTheta = ranges[i][1];
        const Lines lines = houghLines(edges, arguments);
        checkLines(edges, lines, arguments);
        if (HasFatalFailure())
            return;
        // A strong line inside the range is there, with the sign of rho that goes with its angle.
        for (size_t j = 0; j < all.size(); ++j)
        {
            const double halfTurns = std::ceil((ranges[i][0] + 2 * degree - all[j][1]) / CV_PI);
            const double theta = all[j][1] + halfTurns * CV_PI;
            const double rho = std::fmod(std::abs(halfTurns), 2) == 1 ? -all[j][0] : all[j][0];
            if (all[j][2] < 90 || theta > std::min(ranges[i][1], ranges[i][0] + CV_PI) - 2 * degree)
                continue;
            bool isFound = false;
            for (size_t k = 0; k < lines.size(); ++k)
                isFound |=
                    std::abs(lines[k][0] - rho) <= 2 && std::abs(lines[k][1] - theta) <= 2 * degree;
            EXPECT_TRUE(isFound) << "range " << i << ", line " << all[j];
        }
    }
}

// The last angle of a coarse grid is next to the end of the range, on either side of it.
TEST(Linespace_HoughLines_Arguments, ranges_that_end_at_an_angle_of_the_grid)
{
    const Mat1b edges = scene(5);
    const double ends[] = {1, 1 - 1e-7, 1 - 4e-7, 1 - 1e-6, 1 + 1e-7};
    for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 2; ++j)
        {
            Arguments arguments(1, j ? 0.5 : 0.01, 20);
            arguments.minTheta = -1;
            arguments.maxTheta = ends[i];
            const Lines lines = houghLines(edges, arguments);
            EXPECT_FALSE(lines.empty());
            checkLines(edges, lines, arguments);
        }
}

TEST(Linespace_HoughLines_Arguments, upright_line_in_every_range)
{
    Mat1b edges(60, 50, (uchar)0);
    edges.col(17).setTo(255);
    const double ranges[][2] = {{0, CV_PI}, {-0.2, 0.2}, {3, 3.3}, {-3.3, -3}, {6.2, 6.4}};
    const double signs[] = {1, 1, -1, -1, 1};
    for (int i = 0; i < 5; ++i)
    {
        Arguments arguments(1, degree, 55);
        arguments.minTheta = ranges[i][0];
        arguments.maxTheta = ranges[i][1];
        const Lines lines = houghLines(edges, arguments);
        ASSERT_FALSE(lines.empty()) << i;
        EXPECT_NEAR(17 * signs[i], lines[0][0], 0.5) << i;
        EXPECT_NEAR(0, std::sin(lines[0][1]), degree) << i;
        EXPECT_EQ(60, lines[0][2]) << i;
    }
}

TEST(Linespace_HoughLines_Arguments, threshold_is_strict_and_never_a_rule)
{
    Mat1b edges(20, 30, (uchar)0);
    edges.row(11).setTo(1);
    EXPECT_FALSE(houghLines(edges, Arguments(1, degree, 29)).empty());
    EXPECT_TRUE(houghLines(edges, Arguments(1, degree, 30)).empty());
    EXPECT_TRUE(houghLines(edges, Arguments(1, degree, INT_MAX)).empty());
    // 0 and below are numbers of votes: lines with a single pixel are reported, which no rule would
    // do.
    Mat1b few(9, 12, (uchar)0);
    few(3, 4) = few(7, 9) = 255;
    const int thresholds[] = {0, -1, -1000, INT_MIN};
    for (int i = 0; i < 4 && thresholds[i] >= leastThreshold(); ++i)
    {
        const Arguments arguments(1, 10 * degree, thresholds[i]);
        const Lines lines = houghLines(few, arguments);
        checkLines(few, lines, arguments);
        ASSERT_FALSE(lines.empty()) << thresholds[i];
        EXPECT_EQ(2, lines[0][2]);
        int single = 0;
        for (size_t j = 0; j < lines.size(); ++j)
            single += lines[j][2] == 1;
        EXPECT_GT(single, 0) << thresholds[i];
    }
}

TEST(Linespace_HoughLines_Arguments, edge_values)
{
    Mat1b edges = scene(4);
    const Mat1b values = randomEdges(edges.size(), 1, 5);
    values.copyTo(edges, edges != 0);
    Arguments arguments(1, degree, 9000);
    arguments.edgeValue = true;
    const Lines lines = houghLines(edges, arguments);
    EXPECT_FALSE(lines.empty());
    checkLines(edges, lines, arguments);
    // Values are not looked at without it.
    const Lines plain = houghLines(edges, Arguments(1, degree, 40));
    const Lines white = houghLines(Mat1b(edges != 0), Arguments(1, degree, 40));
    EXPECT_EQ(white, plain);
}

// The result is at least as fine as rho / srn, theta / stn.
TEST(Linespace_HoughLines_Arguments, multi_scale)
{
    std::vector<Vec2d> drawn;
    const Mat1b edges = linesInNoise(Size(200, 160), 5, 0.01, 6, drawn);
    const double divisors[][2] = {{2, 2}, {4, 1}, {1, 4}, {3, 0}, {0, 3}};
    for (int i = 0; i < 5; ++i)
    {
        Lines lines;
        cv::linespace::HoughLines(edges, lines, 2, 2 * degree, 25, divisors[i][0], divisors[i][1]);
        Arguments fine(2 / std::max(1.0, divisors[i][0]),
                       2 * degree / std::max(1.0, divisors[i][1]), 25);
        checkLines(edges, lines, fine);
        for (size_t j = 0; j < drawn.size(); ++j)
        {
            const double nearest = nearestLine(drawn[j], lines, edges.size());
            EXPECT_LE(nearest, std::max(1.0, fine.rho) + 100 * fine.theta)
                << "divisors " << i << ", " << drawn[j];
        }
    }
}

TEST(Linespace_HoughLines_Arrays, inputs_and_outputs)
{
    const Mat1b edges = scene(7);
    const Lines expected = houghLines(edges, Arguments(1, degree, 50));
    ASSERT_GT(expected.size(), 5u);
    std::vector<Vec2f> pairs;
    cv::linespace::HoughLines(edges, pairs, 1, degree, 50);
    ASSERT_EQ(expected.size(), pairs.size());
    for (size_t i = 0; i < pairs.size(); ++i)
        EXPECT_EQ(Vec2f(expected[i][0], expected[i][1]), pairs[i]);

    EXPECT_EQ(expected, houghLines(asWindow(edges), Arguments(1, degree, 50))) << "window";
    UMat device, deviceLines;
    edges.copyTo(device);
    Lines fromDevice;
    cv::linespace::HoughLines(device, fromDevice, 1, degree, 50);
    EXPECT_EQ(expected, fromDevice) << "UMat";
    cv::linespace::HoughLines(device, deviceLines, 1, degree, 50);
    ASSERT_EQ(CV_32FC2, deviceLines.type());
    EXPECT_EQ(pairs, std::vector<Vec2f>(deviceLines.getMat(ACCESS_READ)));

    // The type and shape that cv::HoughLines gives to the same array.
    Mat_<Vec3f> typed;
    Mat_<Vec2f> typedPairs;
    Mat untyped, ofThree(2, 2, CV_32FC3, Scalar::all(1)), bytes(2, 2, CV_8UC1, Scalar(1));
    Mat* const outputs[] = {&typed, &typedPairs, &untyped, &ofThree, &bytes};
    for (int i = 0; i < 5; ++i)
    {
        Mat theirs = outputs[i]->clone();
        if (i == 0)
        {
            Mat_<Vec3f> theirTyped;
            cv::HoughLines(edges, theirTyped, 1, degree, 50);
            cv::linespace::HoughLines(edges, typed, 1, degree, 50);
            theirs = theirTyped;
        }
        else if (i == 1)
        {
            Mat_<Vec2f> theirTyped;
            cv::HoughLines(edges, theirTyped, 1, degree, 50);
            cv::linespace::HoughLines(edges, typedPairs, 1, degree, 50);
            theirs = theirTyped;
        }
        else
        {
            cv::HoughLines(edges, theirs, 1, degree, 50);
            cv::linespace::HoughLines(edges, *outputs[i], 1, degree, 50);
        }
        EXPECT_EQ(theirs.type(), outputs[i]->type()) << i;
        EXPECT_EQ(Size(1, (int)expected.size()), outputs[i]->size()) << i;
    }
    EXPECT_EQ(expected, Lines(typed));
    EXPECT_EQ(pairs, std::vector<Vec2f>(untyped));
}

TEST(Linespace_HoughLines_Arrays, empty_results)
{
    const Mat images[] = {Mat(), Mat(0, 7, CV_8UC1), Mat1b(20, 20, (uchar)0),
                          Mat1b(1, 1, (uchar)0)};
    for (int i = 0; i < 4; ++i)
    {
        std::vector<Vec2f> pairs(3);
        Lines lines(3);
        Mat untyped(2, 2, CV_8UC1, Scalar(1));
        UMat device;
        cv::linespace::HoughLines(images[i], pairs, 1, degree, 5);
        cv::linespace::HoughLines(images[i], lines, 1, degree, 5);
        cv::linespace::HoughLines(images[i], untyped, 1, degree, 5);
        cv::linespace::HoughLines(images[i], device, 1, degree, 5);
        EXPECT_TRUE(pairs.empty()) << i;
        EXPECT_TRUE(lines.empty()) << i;
        EXPECT_TRUE(untyped.empty()) << i;
        EXPECT_TRUE(device.empty()) << i;
    }
}

TEST(Linespace_HoughLines_Arrays, the_same_on_every_back_end_and_thread_count)
{
    const Mat1b edges = scene(8);
    const Arguments arguments(1, 0.5 * degree, 40);
    setDefaultBackend(BACKEND_REFERENCE);
    const Lines expected = houghLines(edges, arguments);
    setDefaultBackend(BACKEND_AUTO);
    ASSERT_FALSE(expected.empty());
    const int threads[] = {1, 2, 5, 1};
    for (int i = 0; i < 4; ++i)
    {
        ThreadCount count(threads[i]);
        EXPECT_EQ(expected, houghLines(edges, arguments)) << threads[i] << " threads";
    }
}

TEST(Linespace_HoughLines_Arrays, sizes_and_densities)
{
    const Size sizes[] = {Size(1, 1),   Size(1, 60),  Size(60, 1), Size(7, 5),
                          Size(64, 64), Size(300, 3), Size(5, 222)};
    for (size_t i = 0; i < sizeof(sizes) / sizeof(sizes[0]); ++i)
    {
        const Mat1b images[] = {randomEdges(sizes[i], 0.3, (unsigned)i), whiteEdges(sizes[i])};
        for (int j = 0; j < 2; ++j)
        {
            const Arguments arguments(1, 2 * degree, std::max(sizes[i].width, sizes[i].height) / 2);
            const Lines lines = houghLines(images[j], arguments);
            EXPECT_TRUE(j == 0 || !lines.empty()) << sizes[i];
            checkLines(images[j], lines, arguments);
            if (HasFatalFailure())
                return;
        }
    }
}

// It throws where cv::HoughLines throws and nowhere else: whatever version of OpenCV this is built
// with is asked.

//! On x86 a number that no int holds becomes INT_MIN before OpenCV 5.1, and cv::HoughLines refuses the
//! negative size that follows. Elsewhere (ARM, later versions: INT_MAX or 0) it may go on with whatever
//! comes out of it.
bool conversionsOverflowToIntMin()
{
    volatile double large = 1e30, notANumber = std::numeric_limits<double>::quiet_NaN();
    return cvRound(large) == INT_MIN && cvRound(notANumber) == INT_MIN;
}

template<typename Output>
bool bothThrow(const std::string& what, InputArray image, const Output& output, double rho,
               double theta, int threshold = 5, double minTheta = 0, double maxTheta = CV_PI)
{
    Output theirs = output, ours = output;
    bool theyThrow = false;
    try
    {
        cv::HoughLines(image, theirs, rho, theta, threshold, 0, 0, minTheta, maxTheta);
    }
    catch (const std::exception&)
    {
        theyThrow = true;
    }
    const std::string wrong = wrongException(
        [&]() {
            cv::linespace::HoughLines(image, ours, rho, theta, threshold, 0, 0, minTheta, maxTheta);
        },
        std::vector<std::string>());
    // Where a number of steps is no int, it is theirs to throw or not.
    const double most = std::max(std::abs(rho), std::abs(theta)),
                 least = std::min(std::abs(rho), std::abs(theta));
    const bool overflows =
        !(most < 1e9 && least > 1e-8 && std::abs(minTheta) < 1e6 && std::abs(maxTheta) < 1e6);
    if (theyThrow || !overflows || conversionsOverflowToIntMin() || !wrong.empty())
    {
        EXPECT_EQ(theyThrow ? "" : "no exception", wrong) << what;
    }
    EXPECT_TRUE(!theyThrow || output == ours) << what << ": the output was touched";
    return theyThrow;
}

TEST(Linespace_HoughLines_Throws, where_cv_does)
{
    const double notANumber = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    const Mat1b edges = randomEdges(Size(24, 17), 0.3, 1);
    const std::vector<Vec2f> out(2, Vec2f(1, 2));
    int throwing = 0;

    const double steps[] = {1,          0,        -0.0,      -1,   -0.01, -2,    -10,
                            notANumber, infinity, -infinity, 1e10, 1e-9,  1e-30, 1e-50};
    for (size_t i = 0; i < sizeof(steps) / sizeof(steps[0]); ++i)
    {
        throwing += bothThrow(format("rho %g", steps[i]), edges, out, steps[i], degree);
        throwing += bothThrow(format("theta %g", steps[i]), edges, out, 1, steps[i]);
    }
    const double ranges[][2] = {{0, 0},
                                {2, 1},
                                {1, 0},
                                {0, -1},
                                {-1, 0},
                                {-2, 2},
                                {0, 100},
                                {notANumber, 1},
                                {0, notANumber},
                                {notANumber, notANumber},
                                {0, infinity},
                                {-infinity, 0},
                                {infinity, infinity},
                                {-infinity, infinity}};
    for (size_t i = 0; i < sizeof(ranges) / sizeof(ranges[0]); ++i)
        throwing += bothThrow(format("min_theta %g, max_theta %g", ranges[i][0], ranges[i][1]),
                              edges, out, 1, degree, 5, ranges[i][0], ranges[i][1]);
    const int thresholds[] = {-1, 0, INT_MAX, INT_MIN};
    for (int i = 0; i < 4; ++i)
        throwing +=
            bothThrow(format("threshold %d", thresholds[i]), edges, out, 1, degree, thresholds[i]);
    const int types[] = {CV_8SC1,  CV_16UC1, CV_32SC1, CV_32FC1,
                         CV_64FC1, CV_8UC2,  CV_8UC3,  CV_8UC4};
    for (int i = 0; i < 8; ++i)
    {
        const std::string name = typeToString(types[i]);
        throwing +=
            bothThrow("image of " + name, Mat(9, 9, types[i], Scalar::all(1)), out, 1, degree);
        throwing += bothThrow("empty image of " + name, Mat(0, 0, types[i]), out, 1, degree);
    }
    throwing += bothThrow("empty image", Mat(), out, 1, degree);
    throwing += bothThrow("no image", noArray(), out, 1, degree);
    throwing += bothThrow("image of one pixel", Mat1b(1, 1, (uchar)1), out, 1, degree);
    const int sizes[] = {4, 5, 6};
    throwing += bothThrow("three dimensions", Mat(3, sizes, CV_8UC1, Scalar(1)), out, 1, degree);
    throwing += bothThrow("Vec4f of an empty image", Mat(), std::vector<Vec4f>(2), 1, degree);
    throwing += bothThrow("Vec4f", edges, std::vector<Vec4f>(2), 1, degree);
    throwing += bothThrow("Vec2i", edges, std::vector<Vec2i>(2), 1, degree);
    throwing += bothThrow("Vec2d", edges, std::vector<Vec2d>(2), 1, degree);
    throwing += bothThrow("float", edges, std::vector<float>(2), 1, degree);
    EXPECT_GT(throwing, 30);
}

// Where it throws, it says why.
TEST(Linespace_HoughLines_Throws, and_names_the_argument)
{
    const Mat1b edges(9, 9, (uchar)0);
    std::vector<Vec2f> lines;
    EXPECT_EQ("", wrongException([&]() { cv::linespace::HoughLines(edges, lines, 0, degree, 5); },
                                 {"rho", "0"}));
    EXPECT_EQ("", wrongException([&]() { cv::linespace::HoughLines(edges, lines, -1, degree, 5); },
                                 {"rho", "-1"}));
    EXPECT_EQ("", wrongException([&]() { cv::linespace::HoughLines(edges, lines, 1, -0.25, 5); },
                                 {"theta", "-0.25"}));
    EXPECT_EQ("", wrongException(
                      [&]() { cv::linespace::HoughLines(edges, lines, 1, degree, 5, 0, 0, 2, 1); },
                      {"theta", "2", "1"}));
    EXPECT_EQ("",
              wrongException([&]() { cv::linespace::HoughLines(Mat1f(3, 3), lines, 1, degree, 5); },
                             {"image", "CV_32FC1"}));
}

} // namespace
} // namespace opencv_test
