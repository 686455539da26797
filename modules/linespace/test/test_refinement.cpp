// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Sub-pixel lines and their deviations, against edges rendered analytically (doc/algorithm.md,
// section 5).

#include "test_precomp.hpp"
#include "generators.hpp"
#include "test_support.hpp"

namespace opencv_test {
namespace {

using namespace generators;

typedef std::vector<Vec3f> Vectors;

struct Edge
{
    double rho, theta;
};

//! An image, its gradients, and its edge map.
struct View
{
    Mat1f image;
    Mat dx, dy;
    Mat1b edges;
};

//! profile(distance from the line, position along it) at every pixel centre, and Gaussian noise.
template<class Profile>
Mat1f render(const Size& size, const Edge& edge, double noise, RNG& rng, Profile profile)
{
    Mat1f image(size);
    const double cosine = std::cos(edge.theta), sine = std::sin(edge.theta);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            image(y, x) = (float)(profile(x * cosine + y * sine - edge.rho, y * cosine - x * sine) +
                                  rng.gaussian(noise));
    return image;
}

//! An edge of a contrast, blurred by a Gaussian of deviation 1.
double step(double distance, double contrast)
{
    return 0.5 * contrast * std::erf(distance / std::sqrt(2.));
}

View viewOf(const Mat1f& image)
{
    View view;
    view.image = image;
    Mat bytes;
    image.convertTo(bytes, CV_8U);
    Canny(bytes, view.edges, 40, 100);
    Sobel(image, view.dx, CV_32F, 1, 0);
    Sobel(image, view.dy, CV_32F, 0, 1);
    return view;
}

View stepView(const Size& size, const Edge& edge, double contrast, double noise, RNG& rng)
{
    return viewOf(render(size, edge, noise, rng,
                         [=](double distance, double) { return 128 + step(distance, contrast); }));
}

//! Where the edge enters and leaves the image: x1, y1, x2, y2.
Vec4d endsOf(const Edge& edge, const Size& size)
{
    Point2d ends[2];
    brute::clipLine(Vec2d(edge.rho, edge.theta), size, ends);
    return Vec4d(ends[0].x, ends[0].y, ends[1].x, ends[1].y);
}

//! Distance of the line from the middle of the edge inside the image, with a sign.
double errorAtMiddle(const Vec3f& line, const Edge& edge, const Size& size)
{
    const Vec4d ends = endsOf(edge, size);
    return 0.5 * (ends[0] + ends[2]) * std::cos(line[1]) +
           0.5 * (ends[1] + ends[3]) * std::sin(line[1]) - line[0];
}

double lengthOf(const Edge& edge, const Size& size)
{
    const Vec4d ends = endsOf(edge, size);
    return std::sqrt((ends[2] - ends[0]) * (ends[2] - ends[0]) +
                     (ends[3] - ends[1]) * (ends[3] - ends[1]));
}

//! Deviation of the position at the middle of the edge that the covariance of a line gives.
double deviationAtMiddle(const Vec3f& deviation, const Edge& edge, const Size& size)
{
    const Vec4d ends = endsOf(edge, size);
    // d(position) = tau d(theta) - d(rho) at the distance tau along the line
    const double tau = 0.5 * (ends[1] + ends[3]) * std::cos(edge.theta) -
                       0.5 * (ends[0] + ends[2]) * std::sin(edge.theta);
    return std::sqrt(deviation[0] * deviation[0] + tau * tau * deviation[1] * deviation[1] -
                     2 * tau * deviation[0] * deviation[1] * deviation[2]);
}

class Linespace_Refinement : public testing::TestWithParam<int>
{
protected:
    int backend() const { return GetParam(); }
    Ptr<LineSpaceDetector> strongestAbove(int threshold) const
    {
        Ptr<LineSpaceDetector> detector =
            LineSpaceDetector::create(threshold, 1, METHOD_CASCADED, 8, backend());
        detector->setSelection(SELECT_EXPLAIN);
        return detector;
    }
};

const double ANGLES[] = {0, 0.001, 0.1, 0.4, CV_PI / 4, 1.1, CV_PI / 2, 1.9, 2.7};

// Cramer-Rao: sigma / sqrt(L J), J = c^2 / (2 sqrt(pi) s), for a step of contrast c blurred by s.
TEST_P(Linespace_Refinement, position_is_within_twice_the_cramer_rao_bound)
{
    const Size size(128, 96);
    const double contrast = 60, noises[] = {6, 12};
    for (double noise : noises)
        for (double theta : ANGLES)
        {
            double squares = 0, normalised = 0, atPixels = 0, byPixels = 0;
            const int repeats = 24;
            for (int i = 0; i < repeats; ++i)
            {
                RNG rng(1000 + i);
                const Edge edge = {63.5 * std::cos(theta) + 47.5 * std::sin(theta) +
                                       rng.uniform(-15., 15.),
                                   theta};
                const View view = stepView(size, edge, contrast, noise, rng);
                Ptr<LineSpaceDetector> detector = strongestAbove(25);
                Vectors lines, deviations;
                detector->detect(view.edges, view.dx, view.dy, lines);
                detector->getDeviations(deviations);
                ASSERT_EQ(1u, lines.size());
                ASSERT_EQ(1u, deviations.size());
                const double information = contrast * contrast / (2 * std::sqrt(CV_PI));
                const double bound = noise / std::sqrt(lengthOf(edge, size) * information);
                const double error = errorAtMiddle(lines[0], edge, size);
                squares += std::pow(error / bound, 2);
                normalised += std::pow(error / deviationAtMiddle(deviations[0], edge, size), 2);

                detector->detect(view.edges, lines);
                detector->getDeviations(deviations);
                ASSERT_EQ(1u, lines.size());
                const double pixelError = errorAtMiddle(lines[0], edge, size);
                atPixels += std::pow(pixelError / bound, 2);
                byPixels += std::pow(pixelError / deviationAtMiddle(deviations[0], edge, size), 2);
            }
            const std::string where = format("noise %g, theta %g", noise, theta);
            EXPECT_LT(std::sqrt(squares / repeats), 2) << where;
            EXPECT_LT(std::sqrt(squares / repeats), std::sqrt(atPixels / repeats)) << where;
            // The deviations are those of the errors; 24 errors give them to about 15 %.
            EXPECT_GT(std::sqrt(normalised / repeats), 0.6) << where;
            EXPECT_LT(std::sqrt(normalised / repeats), 1.7) << where;
            if (noise > noises[0])
                continue; // without directions, edge pixels of the noise are among the others
            EXPECT_GT(std::sqrt(byPixels / repeats), 0.1) << where;
            EXPECT_LT(std::sqrt(byPixels / repeats), 1.7) << where;
        }
}

// Without noise the position is that of the edge, whatever the angle.
TEST_P(Linespace_Refinement, an_edge_without_noise)
{
    const Size size(128, 96);
    for (double theta : ANGLES)
        for (int i = 0; i < 8; ++i)
        {
            RNG rng(i);
            const Edge edge = {63.5 * std::cos(theta) + 47.5 * std::sin(theta) + i / 8., theta};
            const View view = stepView(size, edge, 60, 0, rng);
            Vectors lines;
            strongestAbove(25)->detect(view.edges, view.dx, view.dy, lines);
            ASSERT_EQ(1u, lines.size());
            EXPECT_LT(brute::endDistance(Vec2d(edge.rho, edge.theta),
                                         Vec2d(lines[0][0], lines[0][1]), size),
                      0.02)
                << "theta " << theta << ", rho " << edge.rho << " " << lines[0];
        }
}

// The same edge, its polarity alternating as on a chessboard, with gaps and in either type.
TEST_P(Linespace_Refinement, alternating_polarity_and_kinds_of_gradients)
{
    const Size size(128, 96);
    for (double theta : ANGLES)
    {
        RNG rng(7);
        const Edge edge = {63.5 * std::cos(theta) + 47.5 * std::sin(theta) + 0.3, theta};
        const View view =
            viewOf(render(size, edge, 1, rng,
                          [](double distance, double along) {
                              return 128 + std::tanh(6 * std::sin(along / 5)) * step(distance, 80);
                          }));
        Ptr<LineSpaceDetector> detector = strongestAbove(25);
        detector->setAngleRange(theta - 0.2, theta + 0.2); // not the stripes' own edges
        Vectors lines;
        detector->detect(view.edges, view.dx, view.dy, lines);
        ASSERT_EQ(1u, lines.size());
        EXPECT_LT(
            brute::endDistance(Vec2d(edge.rho, edge.theta), Vec2d(lines[0][0], lines[0][1]), size),
            0.1)
            << "theta " << theta << " " << lines[0];
        // Shorts, and floats at another scale, are the same gradients but for rounding.
        const double scales[] = {1, 1e-40, 1e-12, 1e20, 1e36, 40};
        for (double scale : scales)
        {
            Mat dx, dy;
            view.dx.convertTo(dx, scale == 1 ? CV_16S : CV_32F, scale);
            view.dy.convertTo(dy, scale == 1 ? CV_16S : CV_32F, scale);
            Vectors others;
            detector->detect(view.edges, dx, dy, others);
            ASSERT_EQ(1u, others.size());
            EXPECT_LT(brute::endDistance(Vec2d(others[0][0], others[0][1]),
                                         Vec2d(lines[0][0], lines[0][1]), size),
                      0.01)
                << "theta " << theta << ", scale " << scale;
        }
        Mat dx, dy;
        // As large as shorts can be: along the normal larger than these.
        const double largest =
            std::max(cvtest::norm(view.dx, NORM_INF), cvtest::norm(view.dy, NORM_INF));
        view.dx.convertTo(dx, CV_16S, 32767 / largest);
        view.dy.convertTo(dy, CV_16S, 32767 / largest);
        Vectors others;
        detector->detect(view.edges, dx, dy, others);
        ASSERT_EQ(1u, others.size());
        EXPECT_LT(brute::endDistance(Vec2d(others[0][0], others[0][1]),
                                     Vec2d(lines[0][0], lines[0][1]), size),
                  0.01)
            << "theta " << theta << ", large shorts";
    }
}

// The two edges of a bar have opposite signs: the stronger one does not pull the other one's line
// to itself. (Where they overlap as much as here, the gradients' maxima are farther apart than
// they are.)
TEST_P(Linespace_Refinement, edges_of_a_narrow_bar)
{
    const Size size(128, 96);
    const double width = 3, contrasts[] = {45, 150}, errors[] = {0.6, 0.15};
    for (double theta : ANGLES)
    {
        RNG rng(3);
        const Edge middle = {63.5 * std::cos(theta) + 47.5 * std::sin(theta) + 0.4, theta};
        const View view = viewOf(render(size, middle, 1, rng,
                                        [=](double distance, double)
                                        {
                                            return 125 + step(distance + width / 2, contrasts[0]) -
                                                   step(distance - width / 2, contrasts[1]);
                                        }));
        Ptr<LineSpaceDetector> detector =
            LineSpaceDetector::create(25, 2, METHOD_CASCADED, 8, backend());
        detector->setSelection(SELECT_EXPLAIN);
        Vectors lines;
        detector->detect(view.edges, view.dx, view.dy, lines);
        EXPECT_EQ(2u, lines.size()) << "theta " << theta;
        for (int side = 0; side < 2; ++side)
        {
            const Vec2d truth(middle.rho + (side - 0.5) * width, theta);
            double nearest = DBL_MAX;
            for (const Vec3f& line : lines)
                nearest =
                    std::min(nearest, brute::endDistance(truth, Vec2d(line[0], line[1]), size));
            EXPECT_LT(nearest, errors[side]) << "theta " << theta << ", side " << side;
        }
    }
}

// Directions without a profile around the edge leave the line where its edge pixels are.
TEST_P(Linespace_Refinement, gradients_that_tell_no_position)
{
    const Size size(90, 70);
    for (double theta : ANGLES)
    {
        const double rho = 44.5 * std::cos(theta) + 34.5 * std::sin(theta) + 3.3;
        Mat1b edges(size, (uchar)0);
        addLine(edges, rho, theta);
        Vectors expected, lines;
        Ptr<LineSpaceDetector> detector = strongestAbove(20);
        detector->detect(edges, expected);
        ASSERT_EQ(1u, expected.size());
        const Mat dx(size, CV_32FC1, Scalar(std::cos(theta))),
            dy(size, CV_32FC1, Scalar(std::sin(theta)));
        detector->detect(edges, dx, dy, lines);
        EXPECT_EQ(expected, lines) << "theta " << theta;
    }
}

// Gradients tell as much as floats as they do as shorts, and nothing changes with their sign.
TEST_P(Linespace_Refinement, the_same_gradients_give_the_same_lines)
{
    const Size size(128, 96);
    for (double theta : ANGLES)
    {
        RNG rng(17);
        const Edge edge = {63.5 * std::cos(theta) + 47.5 * std::sin(theta) + 0.2, theta};
        const View view = stepView(size, edge, 60, 4, rng);
        Ptr<LineSpaceDetector> detector = strongestAbove(25);
        const double scales[] = {0.1, 1, 100};
        for (double scale : scales)
        {
            Mat shorts[2], floats[2], negative[2];
            for (int i = 0; i < 2; ++i)
            {
                (i == 0 ? view.dx : view.dy).convertTo(shorts[i], CV_16S, scale);
                shorts[i].convertTo(floats[i], CV_32F);
                negative[i] = -shorts[i];
            }
            Vectors lines, deviations, others, otherDeviations;
            detector->detect(view.edges, shorts[0], shorts[1], lines);
            detector->getDeviations(deviations);
            ASSERT_EQ(1u, lines.size());
            detector->detect(view.edges, floats[0], floats[1], others);
            detector->getDeviations(otherDeviations);
            EXPECT_EQ(lines, others) << "as floats, theta " << theta << ", scale " << scale;
            EXPECT_EQ(deviations, otherDeviations)
                << "as floats, theta " << theta << ", scale " << scale;
            detector->detect(view.edges, negative[0], negative[1], others);
            EXPECT_EQ(lines, others) << "other sign, theta " << theta << ", scale " << scale;
        }
    }
}

// A gradient that is out of all proportion is finite, and none of the line's business.
TEST_P(Linespace_Refinement, a_large_gradient_elsewhere)
{
    const Size size(128, 96);
    RNG rng(19);
    const Edge edge = {50.3, 0.3};
    const View view = stepView(size, edge, 60, 2, rng);
    Ptr<LineSpaceDetector> detector = strongestAbove(25);
    Vectors lines, others;
    detector->detect(view.edges, view.dx, view.dy, lines);
    ASSERT_EQ(1u, lines.size());
    const float sizes[] = {1e9f, -1e20f, FLT_MAX, -FLT_MAX};
    for (float large : sizes)
    {
        Mat dx = view.dx.clone(), dy = view.dy.clone();
        dx.at<float>(5, 120) = dy.at<float>(90, 110) = large;
        detector->detect(view.edges, dx, dy, others);
        EXPECT_EQ(lines, others) << large;
        // One of the line's own pixels that is no edge pixel counts as a large one, no more.
        dx.at<float>(48, 40) = std::abs(large);
        detector->detect(view.edges, dx, dy, others);
        ASSERT_EQ(1u, others.size());
        EXPECT_LT(brute::endDistance(Vec2d(others[0][0], others[0][1]),
                                     Vec2d(lines[0][0], lines[0][1]), size),
                  0.03)
            << large;
    }
}

// Few gradients along a line say less of it than all of its edge pixels.
TEST_P(Linespace_Refinement, gradients_of_few_columns)
{
    const Size size(128, 96);
    for (double theta : ANGLES)
    {
        RNG rng(23);
        const double rho = 63.5 * std::cos(theta) + 47.5 * std::sin(theta) + 0.1;
        const Edge moved = {rho + 0.6, theta};
        const View view = stepView(size, moved, 60, 0, rng);
        Mat1b edges(size, (uchar)0);
        addLine(edges, rho, theta);
        Ptr<LineSpaceDetector> detector = strongestAbove(25);
        Vectors expected, lines;
        detector->detect(edges, expected);
        ASSERT_EQ(1u, expected.size());
        Mat dx = view.dx.clone(), dy = view.dy.clone();
        const Rect few(56, 40, 16, 16);
        Mat1b elsewhere(size, (uchar)1);
        elsewhere(few).setTo(0);
        dx.setTo(0, elsewhere);
        dy.setTo(0, elsewhere);
        detector->detect(edges, dx, dy, lines);
        EXPECT_EQ(expected, lines) << "theta " << theta;
        // All of them do move it.
        detector->detect(edges, view.dx, view.dy, lines);
        ASSERT_EQ(1u, lines.size());
        EXPECT_NEAR(moved.rho, lines[0][0], 0.05) << "theta " << theta;
    }
}

// A sign that changes from each column to the next is noise: where it does, nothing says where the
// edge is. Here that would be on the other side of the chord.
TEST_P(Linespace_Refinement, signs_that_alternate_say_nothing)
{
    const Size size(128, 96);
    const Edge edge = {47.6, CV_PI / 2}, other = {46.4, CV_PI / 2};
    RNG rng(29);
    const View view = stepView(size, edge, 60, 0, rng),
               otherView = stepView(size, other, 60, 0, rng);
    Mat1b edges(size, (uchar)0);
    edges.row(47).setTo(255);
    Mat dx = view.dx.clone(), dy = view.dy.clone();
    const Range silent(90, size.width - 1); // the last sign has no other side, so is not dropped
    dx.colRange(silent).setTo(0);
    dy.colRange(silent).setTo(0);
    Vectors expected, lines;
    strongestAbove(100)->detect(edges, dx, dy, expected);
    ASSERT_EQ(1u, expected.size());
    EXPECT_NEAR(edge.rho, expected[0][0], 0.05);
    for (int x = silent.start; x < silent.end; ++x)
    {
        dx.col(x) += otherView.dx.col(x) * (x % 2 ? 1 : -1);
        dy.col(x) += otherView.dy.col(x) * (x % 2 ? 1 : -1);
    }
    strongestAbove(100)->detect(edges, dx, dy, lines);
    ASSERT_EQ(1u, lines.size());
    EXPECT_NEAR(expected[0][0], lines[0][0], 1e-3);
    EXPECT_NEAR(expected[0][1], lines[0][1], 1e-5);
}

// Whether pixels at exactly the distance of support count must not depend on how their distances
// are rounded, which differs along the line.
TEST_P(Linespace_Refinement, edges_of_three_rows)
{
    for (int length = 60; length <= 240; length += 60)
        for (int at = 10; at < 50; at += 7)
            for (int transposed = 0; transposed < 2; ++transposed)
            {
                Mat1b edges(60, length, (uchar)0);
                edges.rowRange(at - 1, at + 2).setTo(255);
                for (int x = 0; x < length; x += 10) // the middle row is the strongest
                    edges(at - 1, x) = edges(at + 1, x) = 0;
                if (transposed)
                    edges = edges.t();
                Vectors lines;
                strongestAbove(length / 2)->detect(edges, lines);
                ASSERT_EQ(1u, lines.size());
                EXPECT_EQ(Vec2f((float)at, transposed ? 0.f : (float)(CV_PI / 2)),
                          Vec2f(lines[0][0], lines[0][1]))
                    << "length " << length << ", transposed " << transposed;
            }
}

TEST_P(Linespace_Refinement, deviations_belong_to_the_last_lines)
{
    std::vector<Vec2d> drawn;
    const Mat1b edges = linesInNoise(Size(160, 120), 6, 0.02, 5, drawn);
    Ptr<LineSpaceDetector> detector =
        LineSpaceDetector::create(60, 0, METHOD_CASCADED, 8, backend());
    Vectors lines, deviations(3);
    detector->getDeviations(deviations);
    EXPECT_TRUE(deviations.empty()) << "before the first call";
    detector->detect(edges, lines);
    detector->getDeviations(deviations);
    ASSERT_GE(lines.size(), 6u);
    ASSERT_EQ(lines.size(), deviations.size());
    for (size_t i = 0; i < deviations.size(); ++i)
    {
        EXPECT_GT(deviations[i][0], 0);
        EXPECT_LT(deviations[i][0], 3);
        EXPECT_GT(deviations[i][1], 0);
        EXPECT_LT(deviations[i][1], 0.03);
        EXPECT_LE(std::abs(deviations[i][2]), 1);
    }
    Mat array;
    UMat onDevice;
    detector->getDeviations(array);
    detector->getDeviations(onDevice);
    EXPECT_EQ(CV_32FC3, array.type());
    EXPECT_EQ(Size(1, (int)lines.size()), array.size());
    EXPECT_EQ(0, cvtest::norm(array, onDevice.getMat(ACCESS_READ), NORM_INF));

    // The same lines with the other sign of rho have the other sign of correlation.
    detector->setAngleRange(-CV_PI, 0);
    Vectors turned, turnedDeviations;
    detector->detect(edges, turned);
    detector->getDeviations(turnedDeviations);
    ASSERT_EQ(lines.size(), turned.size());
    for (size_t i = 0; i < lines.size(); ++i)
    {
        EXPECT_FLOAT_EQ(deviations[i][0], turnedDeviations[i][0]);
        EXPECT_NEAR(deviations[i][2], -turnedDeviations[i][2], 1e-5);
    }

    // A failed call leaves them; one without lines empties them; clear() as well.
    EXPECT_ANY_THROW(detector->detect(Mat(4, 4, CV_32F), lines));
    std::vector<Vec2f> wrong;
    EXPECT_EQ(
        "", wrongException([&]() { detector->getDeviations(wrong); }, {"deviations", "CV_32FC3"}));
    detector->getDeviations(deviations);
    EXPECT_EQ(turnedDeviations, deviations);
    detector->detect(Mat1b(120, 160, (uchar)0), lines);
    detector->getDeviations(deviations);
    EXPECT_TRUE(deviations.empty()) << "no lines";
    detector->detect(edges, lines);
    detector->clear();
    detector->getDeviations(deviations);
    EXPECT_TRUE(deviations.empty()) << "cleared";
}

// Refinement is code that all back ends share; Linespace_Oriented compares their refined lines.
INSTANTIATE_TEST_CASE_P(/**/, Linespace_Refinement, testing::Values((int)BACKEND_CPU));

} // namespace
} // namespace opencv_test
