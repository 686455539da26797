// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The drop-in cv::linespace::HoughLines on an OpenCL device: its lists are those of the CPU path,
// to the last bit and in the same order. What the lists are is a matter of test_houghlines.cpp.

#include "test_precomp.hpp"

#include "generators.hpp"
#include "test_support.hpp"

#include <opencv2/core/ocl.hpp>

#include <thread>

namespace opencv_test {
namespace {

using namespace generators;

typedef std::vector<Vec3f> Lines;

struct Arguments
{
    double rho, theta;
    int threshold;
    double minTheta, maxTheta;
    bool edgeValue;
};

std::ostream& operator<<(std::ostream& out, const Arguments& a)
{
    return out << "rho " << a.rho << ", theta " << a.theta << ", threshold " << a.threshold
               << ", from " << a.minTheta << " to " << a.maxTheta << ", edge value " << a.edgeValue;
}

Lines houghLines(InputArray edges, const Arguments& a)
{
    Lines lines;
    cv::linespace::HoughLines(edges, lines, a.rho, a.theta, a.threshold, 0, 0, a.minTheta,
                              a.maxTheta, a.edgeValue);
    return lines;
}

Lines byDevice(InputArray edges, const Arguments& arguments)
{
    const DefaultBackend device(BACKEND_OPENCL);
    return houghLines(edges, arguments);
}

//! Part of an image on the device that has margins of edge pixels, so that it has an offset and a
//! step.
UMat partOnDevice(const Mat1b& edges, int left, int top)
{
    Mat large;
    cv::copyMakeBorder(edges, large, top, 3, left, 5, BORDER_CONSTANT, 255);
    UMat onDevice;
    large.copyTo(onDevice);
    return onDevice(Rect(left, top, edges.cols, edges.rows));
}

const Arguments plain = {1, CV_PI / 180, 30, 0, CV_PI, false};

TEST(Linespace_OpenClHoughLines, all_small_sizes)
{
    requireBackend(BACKEND_OPENCL);
    int found = 0;
    for (int height = 1; height <= 20; ++height)
        for (int width = 1; width <= 20; ++width)
        {
            const int variant = height * 20 + width;
            const Mat1b edges =
                randomEdges(Size(width, height), 0.2 + 0.1 * (variant % 7), (unsigned)variant);
            const Arguments arguments = {0.5 * (1 << variant % 3),
                                         variant % 5 ? CV_PI / 36 : CV_PI / 180,
                                         variant % 4 ? (width + height) / 5
                                                     : std::max(variant % 3 - 1, leastThreshold()),
                                         variant % 2 ? -0.7 : 0,
                                         variant % 2 ? 0.8 : CV_PI,
                                         false};
            const Lines expected = houghLines(edges, arguments);
            ASSERT_EQ(expected, byDevice(partOnDevice(edges, variant % 6, variant % 4), arguments))
                << edges.size() << ", " << arguments;
            found += !expected.empty();
        }
    EXPECT_GT(found, 300);
}

//! Sparse maps and dense ones, few of whose lines the table of the frame supports, or most.
TEST(Linespace_OpenClHoughLines, random_sizes_densities_and_arguments)
{
    requireBackend(BACKEND_OPENCL);
    const double rhos[] = {0.5, 1, 2, 3.3}, steps[] = {CV_PI / 180, CV_PI / 900, 0.1, 1};
    const double ranges[][2] = {{0, CV_PI}, {-0.3, 0.4}, {1, 6}, {-2, -1}};
    RNG random(11);
    int found = 0;
    for (int i = 0; i < 200; ++i)
    {
        const int most = i % 4 ? 150 : 420;
        const Size size(random.uniform(1, most), random.uniform(1, most));
        const double density = random.uniform(0., i % 2 ? 1. : 0.1);
        Mat1b edges = randomEdges(size, density, (unsigned)i);
        const bool edgeValue = i % 5 == 4;
        if (edgeValue)
            cv::multiply(edges, randomEdges(size, 0.5, 77) + 1, edges, 100);
        const int side = std::max(size.width, size.height);
        const double* const range = ranges[random.uniform(0, 4)];
        const Arguments arguments = {
            rhos[random.uniform(0, 4)],
            steps[random.uniform(0, 4)],
            cvRound(density * side * random.uniform(0.7, 1.6) * (edgeValue ? 150 : 1)),
            range[0],
            range[1],
            edgeValue};
        const Lines expected = houghLines(edges, arguments);
        ASSERT_EQ(expected, byDevice(partOnDevice(edges, random.uniform(0, 9), i % 5), arguments))
            << i << ": " << size << ", " << arguments;
        found += !expected.empty();
    }
    EXPECT_GT(found, 100);
}

//! Few heavy pixels on light ones: the chords next to many a line miss those in its band, so that
//! it shows in the list which chords were looked at.
TEST(Linespace_OpenClHoughLines, lines_that_the_table_rules_out)
{
    requireBackend(BACKEND_OPENCL);
    const double rhos[] = {0.5, 1, 2, 3.3};
    const Size sizes[] = {Size(300, 280), Size(420, 220), Size(200, 410)};
    for (int i = 0; i < 12; ++i)
    {
        const Mat1b edges = randomEdges(sizes[i % 3], 0.01, (unsigned)i) * 250 + 1;
        const double rho = rhos[i / 3];
        const Arguments arguments = {rho,  CV_PI / 900,       cvRound(1500 * std::sqrt(rho)),
                                     -0.4, i % 2 ? 1.3 : 2.7, true};
        const Lines expected = houghLines(edges, arguments);
        EXPECT_GT(expected.size(), 100u) << i;
        ASSERT_EQ(expected, byDevice(partOnDevice(edges, 2, 3), arguments)) << i;
    }
}

//! Few lines of an angle are supported, and are walked along one by one.
TEST(Linespace_OpenClHoughLines, lines_that_stand_out)
{
    requireBackend(BACKEND_OPENCL);
    for (int i = 0; i < 12; ++i)
    {
        std::vector<Vec2d> drawn;
        const Mat1b lines =
            linesInNoise(Size(360 - 11 * i, 250 + 13 * i), 7, 0, (unsigned)i, drawn);
        const Mat1b edges = lines * 200 + 1;
        const double rho = 0.5 * (1 << i % 3);
        const Arguments arguments = {rho, CV_PI / 1800, 15000, 0, CV_PI, true};
        const Lines expected = houghLines(edges, arguments);
        EXPECT_GT(expected.size(), 20u) << i;
        ASSERT_EQ(expected, byDevice(partOnDevice(edges, i, 1), arguments)) << i;
    }
}

TEST(Linespace_OpenClHoughLines, photographs)
{
    requireBackend(BACKEND_OPENCL);
    const char* const names[] = {"building.jpg", "sudoku.png"};
    for (const char* name : names)
    {
        const Mat1b edges = photographEdges(name, 400);
        const UMat onDevice = partOnDevice(edges, 3, 2);
        for (int threshold = 0; threshold <= 80; threshold += 40)
            for (double rho = 0.5; rho <= 2; rho *= 2)
            {
                Arguments arguments = plain;
                arguments.threshold = threshold;
                arguments.rho = rho;
                ASSERT_EQ(houghLines(edges, arguments), byDevice(onDevice, arguments))
                    << name << ", " << arguments;
            }
    }
}

//! Many more lines than there is room for at first, then few, then many.
TEST(Linespace_OpenClHoughLines, any_number_of_lines)
{
    requireBackend(BACKEND_OPENCL);
    const Mat1b edges = randomEdges(Size(160, 120), 0.1, 2);
    const UMat onDevice = partOnDevice(edges, 1, 1);
    const int thresholds[] = {0, 25, -5, INT_MAX, 3, INT_MIN};
    for (int threshold : thresholds)
    {
        Arguments arguments = plain;
        arguments.threshold = std::max(threshold, leastThreshold());
        const Lines expected = houghLines(edges, arguments);
        EXPECT_EQ(expected, byDevice(onDevice, arguments)) << threshold;
        EXPECT_EQ(threshold == INT_MAX, expected.empty());
    }
}

//! Positions beyond 2^22, where single precision has halves only.
TEST(Linespace_OpenClHoughLines, the_finest_distances)
{
    requireBackend(BACKEND_OPENCL);
    const Mat1b edges = randomEdges(Size(6, 5), 0.8, 3);
    const Arguments arguments = {1.2e-6, 1, 0, 0.3, 2.5, false};
    const Lines expected = houghLines(edges, arguments);
    EXPECT_GT(expected.size(), 50u);
    EXPECT_EQ(expected, byDevice(partOnDevice(edges, 2, 1), arguments));
}

TEST(Linespace_OpenClHoughLines, ten_times_over)
{
    requireBackend(BACKEND_OPENCL);
    for (double density = 0.1; density < 1; density += 0.5) // by all lines, and by the table
    {
        const Mat1b edges = randomEdges(Size(320, 240), density, 4);
        const UMat onDevice = partOnDevice(edges, 7, 1);
        Arguments arguments = plain;
        arguments.threshold = cvRound(240 * density);
        const Lines expected = houghLines(edges, arguments);
        EXPECT_FALSE(expected.empty());
        for (int round = 0; round < 10; ++round)
            ASSERT_EQ(expected, byDevice(onDevice, arguments)) << density << ", " << round;
    }
}

//! What is kept between calls serves whatever thread comes next, and several at a time.
TEST(Linespace_OpenClHoughLines, threads)
{
    requireBackend(BACKEND_OPENCL);
    const DefaultBackend device(BACKEND_OPENCL);
    const double densities[] = {0.1, 0.6};
    Mat1b edges[2];
    Lines expected[2];
    Arguments arguments[2] = {plain, plain};
    for (int k = 0; k < 2; ++k)
    {
        edges[k] = randomEdges(Size(200, 150), densities[k], 5);
        arguments[k].threshold = cvRound(150 * densities[k]);
        const DefaultBackend processor(BACKEND_CPU);
        expected[k] = houghLines(edges[k], arguments[k]);
    }
    setDefaultBackend(BACKEND_OPENCL);
    const auto check = [&](int k, bool& isSame)
    {
        UMat own;
        edges[k].copyTo(own);
        isSame = houghLines(own, arguments[k]) == expected[k];
    };
    for (int round = 0; round < 6; ++round)
    {
        const int count = round % 2 ? 7 : 1;
        bool isSame[7];
        std::vector<std::thread> threads;
        for (int i = 0; i < count; ++i)
            threads.push_back(std::thread(check, (round + i) % 2, std::ref(isSame[i])));
        for (std::thread& thread : threads)
            thread.join();
        for (int i = 0; i < count; ++i)
            EXPECT_TRUE(isSame[i]) << round << ", " << i;
    }
}

//! Buffers of one context are of no use in another one.
TEST(Linespace_OpenClHoughLines, contexts)
{
    requireBackend(BACKEND_OPENCL);
    const Mat1b edges = randomEdges(Size(200, 150), 0.1, 6);
    const Lines expected = houghLines(edges, plain);
    const ocl::OpenCLExecutionContext before = ocl::OpenCLExecutionContext::getCurrent();
    for (int round = 0; round < 3; ++round)
    {
        EXPECT_EQ(expected, byDevice(partOnDevice(edges, 1, 2), plain));
        const ocl::Context other = ocl::Context::create(":CPU:0"); // not the default's words
        if (!other.ptr())
            throw SkipTestException("no second OpenCL context");
        ASSERT_NE(before.getContext().ptr(), other.ptr());
        {
            const ocl::OpenCLExecutionContextScope scope(
                ocl::OpenCLExecutionContext::create(other, other.device(0)));
            EXPECT_EQ(expected, byDevice(partOnDevice(edges, 2, 1), plain));
        }
        {
            const ocl::OpenCLExecutionContextScope scope(before.cloneWithNewQueue());
            EXPECT_EQ(expected, byDevice(partOnDevice(edges, 3, 1), plain));
        }
    }
}

} // namespace
} // namespace opencv_test
