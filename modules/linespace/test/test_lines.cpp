// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// What is done with reported lines: lineEndPoints and drawLines.

#include "test_precomp.hpp"

#include "brute_force.hpp"
#include "test_support.hpp"

namespace opencv_test {
namespace {

bool isNear(const Vec4f& points, const Point2d& first, const Point2d& second, double tolerance)
{
    return std::abs(points[0] - first.x) < tolerance && std::abs(points[1] - first.y) < tolerance &&
           std::abs(points[2] - second.x) < tolerance && std::abs(points[3] - second.y) < tolerance;
}

TEST(Linespace_EndPoints, random_lines_in_any_direction)
{
    RNG rng(3);
    const Size sizes[] = {Size(1, 1), Size(640, 480), Size(7, 300), Size(1000, 2)};
    for (int i = 0; i < 4; ++i)
    {
        std::vector<Vec2f> lines;
        for (int j = 0; j < 500; ++j)
        {
            const double theta = rng.uniform(-8.0, 8.0);
            const double x = rng.uniform(-0.4, sizes[i].width - 0.6),
                         y = rng.uniform(-0.4, sizes[i].height - 0.6);
            lines.push_back(
                Vec2f((float)(x * std::cos(theta) + y * std::sin(theta)), (float)theta));
        }
        std::vector<Vec4f> endPoints;
        lineEndPoints(lines, sizes[i], endPoints);
        ASSERT_EQ(lines.size(), endPoints.size());
        for (size_t j = 0; j < lines.size(); ++j)
        {
            const Vec2d line(lines[j][0], lines[j][1]);
            Point2d ends[2];
            if (!brute::clipLine(line, sizes[i], ends))
                continue; // rounded out of the image
            const Vec4f& got = endPoints[j];
            // Shallow lines turn a rounding of rho into a shift along the border: look at the
            // distances instead.
            ASSERT_TRUE(isNear(got, ends[0], ends[1], 0.05) || isNear(got, ends[1], ends[0], 0.05))
                << "line " << lines[j] << " of " << sizes[i] << ": " << got << " instead of "
                << ends[0] << ends[1];
            ASSERT_TRUE(got[0] < got[2] || (got[0] == got[2] && got[1] <= got[3])) << got;
            for (int end = 0; end < 2; ++end)
            {
                const double x = got[2 * end], y = got[2 * end + 1];
                ASSERT_NEAR(line[0], x * std::cos(line[1]) + y * std::sin(line[1]), 1e-3);
                const double right = sizes[i].width - 0.5, bottom = sizes[i].height - 0.5;
                ASSERT_TRUE(x >= -0.5 && x <= right && y >= -0.5 && y <= bottom) << got;
                const double toBorder =
                    std::min(std::min(x + 0.5, right - x), std::min(y + 0.5, bottom - y));
                ASSERT_NEAR(0, toBorder, 1e-4);
            }
        }
    }
}

TEST(Linespace_EndPoints, upright_lines_and_misses)
{
    std::vector<Vec3f> lines;
    lines.push_back(Vec3f(3, 0, 10));                    // x = 3
    lines.push_back(Vec3f(4, (float)(CV_PI / 2), 10));   // y = 4
    lines.push_back(Vec3f(-3, (float)CV_PI, 10));        // x = 3 again
    lines.push_back(Vec3f(-2, 0, 10));                   // left of the image
    lines.push_back(Vec3f(100, (float)(CV_PI / 4), 10)); // beyond the lower right corner
    Mat endPoints;
    lineEndPoints(lines, Size(20, 10), endPoints);
    ASSERT_EQ(CV_32FC4, endPoints.type());
    ASSERT_EQ(Size(1, 5), endPoints.size());
    EXPECT_TRUE(isNear(endPoints.at<Vec4f>(0), Point2d(3, -0.5), Point2d(3, 9.5), 1e-5));
    EXPECT_TRUE(isNear(endPoints.at<Vec4f>(1), Point2d(-0.5, 4), Point2d(19.5, 4), 1e-4));
    // (float)pi is not pi: which end is further left is a matter of 1e-7.
    EXPECT_TRUE(isNear(endPoints.at<Vec4f>(2), Point2d(3, -0.5), Point2d(3, 9.5), 1e-4) ||
                isNear(endPoints.at<Vec4f>(2), Point2d(3, 9.5), Point2d(3, -0.5), 1e-4));
    for (int i = 3; i < 5; ++i)
        for (int j = 0; j < 4; ++j)
            EXPECT_TRUE(cvIsNaN(endPoints.at<Vec4f>(i)[j])) << i;
}

TEST(Linespace_EndPoints, kinds_of_arrays)
{
    const Vec2f polar[] = {Vec2f(3, 0), Vec2f(5, 1), Vec2f(2, 1.5f)};
    const Mat lines(3, 1, CV_32FC2, (void*)polar);
    Mat expected, got;
    lineEndPoints(lines, Size(20, 10), expected);
    lineEndPoints(lines.reshape(0, 1), Size(20, 10), got); // 1 x N
    EXPECT_EQ(0, cvtest::norm(expected.reshape(1), got.reshape(1), NORM_INF));
    EXPECT_EQ(Size(1, 3), got.size());
    // In OpenCV 5 a vector has one dimension.
    lineEndPoints(std::vector<Vec2f>(polar, polar + 3), Size(20, 10), got);
    EXPECT_EQ(0, cvtest::norm(expected.reshape(1), got.reshape(1), NORM_INF));
    EXPECT_EQ(Size(1, 3), got.size());
    UMat device;
    lineEndPoints(lines.getUMat(ACCESS_READ), Size(20, 10), device);
    EXPECT_EQ(0,
              cvtest::norm(expected.reshape(1), device.getMat(ACCESS_READ).reshape(1), NORM_INF));
    std::vector<Vec4f> none(3);
    lineEndPoints(std::vector<Vec3f>(), Size(20, 10), none);
    EXPECT_TRUE(none.empty());
}

TEST(Linespace_EndPoints, bad_input)
{
    const std::vector<Vec2f> lines(1, Vec2f(3, 0));
    const Vec4f sentinel(1, 2, 3, 4);
    std::vector<Vec4f> out(2, sentinel);
    EXPECT_EQ("", wrongException([&]() { lineEndPoints(lines, Size(0, 5), out); }, {"imageSize"}));
    EXPECT_EQ("", wrongException([&]() { lineEndPoints(lines, Size(5, -1), out); }, {"imageSize"}));
    EXPECT_EQ("",
              wrongException([&]() { lineEndPoints(Mat1f(1, 1), Size(5, 5), out); }, {"lines"}));
    EXPECT_EQ("", wrongException([&]() { lineEndPoints(Mat_<Vec2f>(2, 2), Size(5, 5), out); },
                                 {"lines"}));
    EXPECT_EQ("", wrongException([&]() { lineEndPoints(Mat_<Vec2d>(2, 1), Size(5, 5), out); },
                                 {"lines"}));
    const int sizes[] = {2, 3, 4};
    EXPECT_EQ("", wrongException(
                      [&]()
                      { lineEndPoints(Mat(3, sizes, CV_32FC2, Scalar::all(0)), Size(5, 5), out); },
                      {"lines", "3 dimensions"}));
    EXPECT_EQ(std::vector<Vec4f>(2, sentinel), out);
}

// As README's example hands them over: from OpenCV 5 on, a vector has one dimension.
TEST(Linespace_Draw, vectors_of_lines)
{
    const std::vector<Vec3f> lines = {Vec3f(3, 0, 9), Vec3f(4, 1, 8)};
    Mat1b expected(9, 12, (uchar)0), actual = expected.clone();
    drawLines(expected, Mat(2, 1, CV_32FC3, (void*)lines.data()), Scalar(255));
    drawLines(actual, lines, Scalar(255));
    EXPECT_EQ(0, cvtest::norm(expected, actual, NORM_INF));
    EXPECT_GT(countNonZero(actual), 10);
}

TEST(Linespace_Draw, three_dimensions_are_refused)
{
    const int sizes[] = {2, 3, 4};
    Mat image(3, sizes, CV_8UC1, Scalar(0));
    EXPECT_EQ("", wrongException([&]() { drawLines(image, std::vector<Vec3f>(1), Scalar(1)); },
                                 {"image", "3 dimensions"}));
}

TEST(Linespace_Draw, pixels_of_a_line)
{
    const int types[] = {CV_8UC1, CV_8UC3, CV_8UC4};
    for (int i = 0; i < 3; ++i)
    {
        const Scalar background = Scalar::all(7), color(100, 150, 200, 250);
        const Mat untouched(1, 1, types[i], background);
        Mat image(30, 40, types[i], background);
        std::vector<Vec3f> lines;
        lines.push_back(Vec3f(12, 0, 1));
        lines.push_back(Vec3f(5, (float)(CV_PI / 2), 1));
        lines.push_back(Vec3f(-300, 1, 1)); // misses the image
        drawLines(image, lines, color, 1);
        for (int y = 0; y < image.rows; ++y)
            for (int x = 0; x < image.cols; ++x)
            {
                // Smoothing at the sides of the lines is allowed.
                const int away = std::min(std::abs(x - 12), std::abs(y - 5));
                const double change = cvtest::norm(image(Rect(x, y, 1, 1)), untouched, NORM_INF);
                ASSERT_TRUE(away != 0 || change > 45) << Point(x, y) << " was not drawn";
                ASSERT_TRUE(away <= 1 || change == 0) << Point(x, y) << " was drawn";
            }
        const Mat drawn = image.clone();
        drawLines(image, std::vector<Vec2f>());
        EXPECT_EQ(0, cvtest::norm(image, drawn, NORM_INF)) << "no lines";
        UMat device(30, 40, types[i], background);
        drawLines(device, lines, color, 1);
        EXPECT_EQ(0, cvtest::norm(drawn, device.getMat(ACCESS_READ), NORM_INF)) << "UMat";
    }
}

TEST(Linespace_Draw, thickness_and_direction)
{
    Mat1b image(60, 80, (uchar)0);
    const Vec2d line(50, 0.8);
    drawLines(image, std::vector<Vec2f>(1, Vec2f(50, 0.8f)), Scalar(255), 5);
    std::vector<Point> pixels;
    findNonZero(image, pixels);
    ASSERT_GT(pixels.size(), 200u);
    for (size_t i = 0; i < pixels.size(); ++i)
        ASSERT_LE(
            std::abs(pixels[i].x * std::cos(line[1]) + pixels[i].y * std::sin(line[1]) - line[0]),
            4.5);
}

TEST(Linespace_Draw, bad_input)
{
    const std::vector<Vec2f> lines(1, Vec2f(3, 0));
    Mat image(9, 9, CV_8UC3, Scalar::all(1));
    const Mat before = image.clone();
    const int thickness[] = {0, -1, 32768, INT_MIN};
    for (int i = 0; i < 4; ++i)
        EXPECT_EQ("", wrongException([&]() { drawLines(image, lines, Scalar(), thickness[i]); },
                                     {"thickness", format("%d", thickness[i])}));
    EXPECT_EQ("", wrongException([&]() { drawLines(image, Mat1d(3, 1)); }, {"lines"}));
    EXPECT_EQ(0, cvtest::norm(image, before, NORM_INF));
    Mat floats(9, 9, CV_32FC3, Scalar::all(1)), two(9, 9, CV_8UC2, Scalar::all(1)), empty;
    EXPECT_EQ("", wrongException([&]() { drawLines(floats, lines); }, {"image"}));
    EXPECT_EQ("", wrongException([&]() { drawLines(two, lines); }, {"image"}));
    EXPECT_EQ("", wrongException([&]() { drawLines(empty, lines); }, {"image"}));
}

} // namespace
} // namespace opencv_test
