// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// What getDeviations tells of lines without gradients (doc/algorithm.md, section 5.3); those of
// lines by gradients are compared with their errors in test_refinement.cpp.

#include "test_precomp.hpp"
#include "generators.hpp"
#include "test_support.hpp"

namespace opencv_test {
namespace {

using namespace generators;

typedef std::vector<Vec3f> Vectors;

//! The strongest line above a threshold and its deviations; fails if there is none.
void detectStrongest(LineSpaceDetector& detector, const Mat& edges, Vec3f& line, Vec3f& deviation)
{
    Vectors lines, deviations;
    detector.detect(edges, lines);
    detector.getDeviations(deviations);
    ASSERT_FALSE(lines.empty());
    ASSERT_EQ(lines.size(), deviations.size());
    line = lines[0];
    deviation = deviations[0];
}

// An edge that is in a part of the image alone is known as well as the same edge in a larger image.
TEST(Linespace_Deviations, do_not_depend_on_where_the_image_ends)
{
    const double angles[] = {0.1, 0.6, 1.2, 1.9, 2.8};
    for (double theta : angles)
    {
        Mat1b edges(80, 90, (uchar)0);
        addLine(edges, 40 * std::cos(theta) + 40 * std::sin(theta), theta);
        edges.colRange(70, 90).setTo(0);
        edges.rowRange(60, 80).setTo(0);
        Mat1b larger(110, 125, (uchar)0);
        edges.copyTo(larger(Rect(0, 0, 90, 80)));
        Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(30, 1, METHOD_EXACT);
        Vec3f line, deviation, lineInLarger, deviationInLarger;
        detectStrongest(*detector, edges, line, deviation);
        detectStrongest(*detector, larger, lineInLarger, deviationInLarger);
        if (HasFatalFailure())
            return;
        ASSERT_NEAR(line[0], lineInLarger[0], 1e-3) << "theta " << theta;
        ASSERT_NEAR(line[1], lineInLarger[1], 1e-5) << "theta " << theta;
        for (int i = 0; i < 3; ++i)
            EXPECT_NEAR(deviation[i], deviationInLarger[i], 1e-3 * std::abs(deviation[i]))
                << "theta " << theta << ": " << deviation << " " << deviationInLarger;
    }
}

//! (rho, theta) of the line through two points, with the angle within a quarter turn of another.
Vec2d lineThrough(const Point2d& p, const Point2d& q, double near)
{
    double theta = std::atan2(q.x - p.x, p.y - q.y);
    theta += CV_PI * cvRound((near - theta) / CV_PI);
    return Vec2d(p.x * std::cos(theta) + p.y * std::sin(theta), theta);
}

//! A point of the border, moved along its side.
Point2d alongSide(const Point2d& end, const Size& size, double shift)
{
    const bool onVertical =
        std::abs(end.x + 0.5) < 1e-3 || std::abs(end.x - (size.width - 0.5)) < 1e-3;
    return onVertical ? Point2d(end.x, end.y + shift) : Point2d(end.x + shift, end.y);
}

// Of a chord, the ends are known to half a border edge: its deviations are those of lines through
// points drawn there, also where it only cuts a corner.
TEST(Linespace_Deviations, of_a_chord_are_those_of_its_ends)
{
    const Size size(60, 40);
    const Vec4d ends[] = {
        Vec4d(-0.5, 12, 15, -0.5), // corner, top left
        Vec4d(45, -0.5, 59.5, 9),  // top right
        Vec4d(-0.5, 30, 20, 39.5), // bottom left
        Vec4d(40, 39.5, 59.5, 15), // bottom right
        Vec4d(-0.5, 10, 59.5, 22), // across
        Vec4d(20, -0.5, 29, 39.5), // down
        Vec4d(-0.5, 35, 50, -0.5), // both kinds of sides
    };
    RNG rng(5);
    for (const Vec4d& drawn : ends)
    {
        const Vec2d truth =
            lineThrough(Point2d(drawn[0], drawn[1]), Point2d(drawn[2], drawn[3]), CV_PI / 2);
        Mat1b edges(size, (uchar)0);
        addLine(edges, truth[0], truth[1]);
        Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(5, 1, METHOD_EXACT);
        detector->setRefine(REFINE_NONE);
        Vec3f line, deviation;
        detectStrongest(*detector, edges, line, deviation);
        if (HasFatalFailure())
            return;
        std::vector<Vec4f> points;
        lineEndPoints(Vectors(1, line), size, points);
        const Point2d p(points[0][0], points[0][1]), q(points[0][2], points[0][3]);
        double rho = 0, theta = 0, both = 0;
        const int samples = 20000;
        for (int i = 0; i < samples; ++i)
        {
            const Vec2d sample = lineThrough(alongSide(p, size, rng.uniform(-0.5, 0.5)),
                                             alongSide(q, size, rng.uniform(-0.5, 0.5)), line[1]);
            rho += std::pow(sample[0] - line[0], 2) / samples;
            theta += std::pow(sample[1] - line[1], 2) / samples;
            both += (sample[0] - line[0]) * (sample[1] - line[1]) / samples;
        }
        EXPECT_NEAR(std::sqrt(rho), deviation[0], 0.03 * std::sqrt(rho)) << drawn << " " << line;
        EXPECT_NEAR(std::sqrt(theta), deviation[1], 0.03 * std::sqrt(theta)) << drawn << line;
        EXPECT_NEAR(both / std::sqrt(rho * theta), deviation[2], 0.03) << drawn << " " << line;
    }
}

// Also where rho is 0, of which either sign looks the same.
TEST(Linespace_Deviations, correlation_changes_with_the_sign_of_rho)
{
    Mat1b edges(30, 40, (uchar)0);
    edges.row(0).setTo(255);
    Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(20, 1, METHOD_EXACT);
    detector->setRefine(REFINE_NONE);
    detector->setSuppressionRadius(0);
    Vec3f line, deviation, turned, turnedDeviation;
    detector->setAngleRange(CV_PI / 2 - 0.001, CV_PI / 2 + 0.001); // of the row's chords, one
    detectStrongest(*detector, edges, line, deviation);
    detector->setAngleRange(-CV_PI / 2 - 0.001, -CV_PI / 2 + 0.001);
    detectStrongest(*detector, edges, turned, turnedDeviation);
    if (HasFatalFailure())
        return;
    ASSERT_EQ(0, line[0]);
    ASSERT_EQ(0, turned[0]);
    ASSERT_NEAR(line[1] - CV_PI, turned[1], 1e-6);
    ASSERT_GT(std::abs(deviation[2]), 0.5);
    EXPECT_FLOAT_EQ(-deviation[2], turnedDeviation[2]);
}

} // namespace
} // namespace opencv_test
