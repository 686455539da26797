// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Oriented detection with gradients on an OpenCL device: lines and errors are those of the host.
// What an oriented map counts is a matter of test_orientation.cpp.

#include "test_precomp.hpp"

#include "generators.hpp"
#include "test_support.hpp"

#include <limits>

namespace opencv_test {
namespace {

using namespace generators;

typedef std::vector<Vec3f> Lines;

//! Nearly every chord of a small image becomes a line, so each bit of each pixel shows.
Ptr<LineSpaceDetector> detectorOfChords(int backend, double tolerance)
{
    const Ptr<LineSpaceDetector> detector =
        LineSpaceDetector::create(1, 0, METHOD_EXACT, 8, backend);
    detector->setSuppressionRadius(0);
    detector->setSuppressionDistance(0);
    detector->setRefine(REFINE_NONE);
    detector->setOrientationTolerance(tolerance);
    return detector;
}

//! Of any length down to the least of all; some 0, some where a bin's pixels end: halfway between
//! two integers once they are scaled, or so large that they are rounded to more than 15 bits.
Mat randomGradients(const Size& size, int type, double tolerance, RNG& random)
{
    Mat both(size, CV_MAKETYPE(type, 2));
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
        {
            const double angle = random.uniform(0., 2 * CV_PI);
            const int kind = random.uniform(0, 8);
            if (type == CV_16S)
            {
                const double length = std::exp(random.uniform(0., 10.5));
                both.at<Vec2s>(y, x) = kind == 0
                                           ? Vec2s(-32768, (short)(32767 * random.uniform(-1, 2)))
                                           : Vec2s(saturate_cast<short>(length * std::cos(angle)),
                                                   saturate_cast<short>(length * std::sin(angle)));
                continue;
            }
            Vec2d gradient(std::cos(angle), std::sin(angle));
            int exponent = random.uniform(-149, 126);
            if (kind == 0)
                gradient = Vec2d(random.uniform(-1, 2), random.uniform(-1, 2));
            else if (kind < 5)
            {
                const double end = (random.uniform(0, 32) + 0.5) * CV_PI / 16 + CV_PI / 2 +
                                   tolerance * CV_PI / 180;
                const bool isSteep = std::abs(std::sin(end)) > std::abs(std::cos(end));
                const double slope = isSteep ? 1 / std::tan(end) : std::tan(end);
                const double larger =
                    kind == 4 ? 32767.75 : (1 << 14) + random.uniform(0, (1 << 14) - 1);
                gradient = Vec2d(larger, kind == 4 ? std::ceil(slope * 32767)
                                                   : std::floor(slope * larger) + 0.5);
                exponent = random.uniform(-130, 110);
                if (isSteep)
                    std::swap(gradient[0], gradient[1]);
            }
            both.at<Vec2f>(y, x) = Vec2f((float)std::ldexp(gradient[0], exponent),
                                         (float)std::ldexp(gradient[1], exponent));
        }
    return both;
}

//! dx or dy on the device, with an offset and a step.
UMat partOnDevice(const Mat& image, int left, int top)
{
    Mat large;
    cv::copyMakeBorder(image, large, top, 2, left, 3, BORDER_CONSTANT, Scalar::all(77));
    UMat onDevice;
    large.copyTo(onDevice);
    return onDevice(Rect(left, top, image.cols, image.rows));
}

TEST(Linespace_OpenClDirections, gradients_of_all_kinds)
{
    requireBackend(BACKEND_OPENCL);
    const double tolerances[] = {22.5, 3, 90, 47};
    RNG random(3);
    size_t found = 0;
    for (int i = 0; i < 120; ++i)
    {
        const Size size(random.uniform(1, 24), random.uniform(1, 24));
        const int type = i % 3 ? CV_32F : CV_16S;
        Mat gradients[2];
        cv::split(randomGradients(size, type, tolerances[i % 4], random), gradients);
        const Mat1b edges = randomEdges(size, 0.1 * (1 + i % 8), (unsigned)i) * (1 + i % 200);
        const UMat onDevice = partOnDevice(edges, i % 7, i % 3),
                   dx = partOnDevice(gradients[0], 1, 2), dy = partOnDevice(gradients[1], 4, 0);
        Lines byHost, byDevice, mixed;
        const Ptr<LineSpaceDetector> host = detectorOfChords(BACKEND_CPU, tolerances[i % 4]);
        const Ptr<LineSpaceDetector> device = detectorOfChords(BACKEND_OPENCL, tolerances[i % 4]);
        for (const Ptr<LineSpaceDetector>& detector : {host, device})
        {
            if (i % 5 == 0)
                detector->setMask(randomEdges(size, 0.8, 99));
            detector->setEdgeWeights(i % 4 == 3);
        }
        host->detect(edges, gradients[0], gradients[1], byHost);
        device->detect(onDevice, dx, dy, byDevice);
        ASSERT_EQ(byHost, byDevice) << i << ": " << size;
        device->detect(onDevice, gradients[0], dy, mixed);
        ASSERT_EQ(byHost, mixed) << i;
        host->detect(onDevice, dx, dy, mixed);
        ASSERT_EQ(byHost, mixed) << i;
        host->detect(edges, noArray(), noArray(), byHost);
        device->detect(onDevice, noArray(), noArray(), byDevice);
        ASSERT_EQ(byHost, byDevice) << i << ": " << size << ", estimated";
        found += byHost.size();
    }
    EXPECT_GT(found, 20000u);
}

//! Lines and deviations by the gradients, also by the statistical threshold, which counts bits.
TEST(Linespace_OpenClDirections, photographs)
{
    requireBackend(BACKEND_OPENCL);
    const Mat1b image = photographEdges("building.jpg", 300);
    const int types[] = {CV_16S, CV_32F};
    for (int type : types)
        for (int threshold = 0; threshold <= 40; threshold += 40)
        {
            Mat dx, dy, deviations[2];
            cv::Sobel(image, dx, type, 1, 0);
            cv::Sobel(image, dy, type, 0, 1);
            const int backends[] = {BACKEND_CPU, BACKEND_OPENCL};
            Lines lines[2];
            for (int k = 0; k < 2; ++k)
            {
                const Ptr<LineSpaceDetector> detector =
                    LineSpaceDetector::create(threshold, 0, METHOD_CASCADED, 8, backends[k]);
                for (int round = 0; round < 3; ++round)
                    if (k == 0)
                        detector->detect(image, dx, dy, lines[k]);
                    else
                        detector->detect(partOnDevice(image, 2, 1), partOnDevice(dx, round, 3),
                                         partOnDevice(dy, 5, round), lines[k]);
                detector->getDeviations(deviations[k]);
                EXPECT_EQ(backends[k], detector->getActiveBackend());
            }
            EXPECT_FALSE(lines[0].empty());
            EXPECT_EQ(lines[0], lines[1]) << type << ", " << threshold;
            EXPECT_EQ(0, cvtest::norm(deviations[0], deviations[1], NORM_INF));
        }
}

//! What is wrong with gradients is told in the same words, wherever they are.
TEST(Linespace_OpenClDirections, bad_gradients)
{
    requireBackend(BACKEND_OPENCL);
    const Mat1b edges = randomEdges(Size(40, 30), 0.1, 1);
    const float values[] = {std::numeric_limits<float>::quiet_NaN(),
                            std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity()};
    const auto messageOf = [&](InputArray image, InputArray dx, InputArray dy)
    {
        const Lines sentinel(2, Vec3f(1, 2, 3));
        Lines lines = sentinel;
        String message;
        try
        {
            LineSpaceDetector::create(5)->detect(image, dx, dy, lines);
        }
        catch (const Exception& error)
        {
            message = error.err;
        }
        EXPECT_EQ(sentinel, lines);
        return message;
    };
    for (int i = 0; i < 6; ++i)
    {
        Mat gradients[2] = {Mat1f(edges.size(), 1.f), Mat1f(edges.size(), 2.f)};
        gradients[i % 2].at<float>(29 - i, 39 - 2 * i) = values[i / 2];
        gradients[i % 2].at<float>(29, 39) = values[i / 2];
        const String expected = messageOf(edges, gradients[0], gradients[1]);
        EXPECT_NE("", expected);
        EXPECT_EQ(expected, messageOf(partOnDevice(edges, 1, 1), partOnDevice(gradients[0], 2, 1),
                                      partOnDevice(gradients[1], 1, 3)));
    }
    const Mat wrong[][2] = {{Mat1f(30, 41, 1.f), Mat1f(30, 40, 1.f)},
                            {Mat1f(30, 40, 1.f), Mat1s(30, 40, (short)1)},
                            {Mat1b(30, 40, (uchar)1), Mat1b(30, 40, (uchar)1)},
                            {Mat1f(30, 40, 1.f), Mat()}};
    for (const auto& pair : wrong)
    {
        UMat dx, dy;
        pair[0].copyTo(dx);
        pair[1].copyTo(dy);
        const String expected = messageOf(edges, pair[0], pair[1]);
        EXPECT_NE("", expected);
        EXPECT_EQ(expected, messageOf(partOnDevice(edges, 1, 1), dx, dy));
    }
}

} // namespace
} // namespace opencv_test
