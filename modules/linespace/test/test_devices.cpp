// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// What only devices search in another way than the processor: beside that.

#include "test_precomp.hpp"

#include "generators.hpp"
#include "test_support.hpp"

namespace opencv_test {
namespace {

using namespace generators;

typedef std::vector<Vec3f> Lines;
typedef testing::TestWithParam<int> Linespace_Devices;

/** Every chord of frames of any shape, by the angle: intervals around directions of chords, as narrow as
one of them, across 0 and pi, almost everything, hardly anything. */
TEST_P(Linespace_Devices, intervals_of_angles)
{
    requireBackend(GetParam());
    const Size sizes[] = {Size(1, 1), Size(2, 1),   Size(1, 9),
                          Size(5, 5), Size(16, 11), Size(33, 20)};
    RNG random(5);
    for (const Size size : sizes)
    {
        const Mat1b white(size, (uchar)1);
        UMat whiteOnDevice;
        white.copyTo(whiteOnDevice);
        Ptr<LineSpaceDetector> detectors[2];
        for (int k = 0; k < 2; ++k)
        {
            // All chords with two votes or more.
            detectors[k] = LineSpaceDetector::create(1, 0, METHOD_EXACT, 8,
                                                     k == 0 ? (int)BACKEND_CPU : GetParam());
            detectors[k]->setSuppressionRadius(0);
            detectors[k]->setSuppressionDistance(0);
            detectors[k]->setRefine(REFINE_NONE);
        }
        Lines all;
        detectors[0]->detect(white, all);
        for (int i = 0; i < 60; ++i)
        {
            double from = random.uniform(-4., 4.), to = from + random.uniform(0., CV_PI);
            if (i < 30 && !all.empty())
            {
                from = all[random.uniform(0, (int)all.size())][1];
                to = i < 10 ? from : from + (i < 20 ? 1e-7 : random.uniform(0., 3.2));
            }
            Lines lines[2];
            for (int k = 0; k < 2; ++k)
                detectors[k]->setAngleRange(from, to);
            detectors[0]->detect(white, lines[0]);
            detectors[1]->detect(whiteOnDevice, lines[1]);
            ASSERT_EQ(lines[0], lines[1]) << size << ", " << from << " to " << to;
        }
    }
}

//! What the statistical rule asks for by length and direction, with masks and weights, in an interval.
TEST_P(Linespace_Devices, the_statistical_rule)
{
    requireBackend(GetParam());
    size_t count = 0;
    for (int i = 0; i < 32; ++i)
    {
        std::vector<Vec2d> placed;
        const Size size(60 + 4 * i, 90 + 3 * i);
        Mat1b image = linesInNoise(size, 3, 0.03, i, placed);
        // So much votes for directions near that of x that nothing of these is significant.
        Mat1s dx(size, 0), dy(size, 0);
        if (i & 4)
        {
            const Mat1b noise = randomEdges(size, 0.6, i + 2) & ~image;
            dy.setTo(9, noise);
            image |= noise;
        }
        UMat imageOnDevice, dxOnDevice, dyOnDevice;
        image.copyTo(imageOnDevice);
        dx.copyTo(dxOnDevice);
        dy.copyTo(dyOnDevice);
        Lines lines[2];
        for (int k = 0; k < 2; ++k)
        {
            const Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(
                0, 0, METHOD_CASCADED, 8, k == 0 ? (int)BACKEND_CPU : GetParam());
            detector->setFalseAlarms(100);
            detector->setEdgeWeights(i % 16 >= 8);
            if (i & 1)
                detector->setMask(randomEdges(size, 0.8, i + 1));
            if (i & 2)
                detector->setAngleRange(0.4, 2);
            if (i >= 16)
                detector->setSuppression(i % 8 >= 4 ? SUPPRESS_GREEDY : SUPPRESS_BLOCKS);
            if (k == 0)
                i & 4 ? detector->detect(image, dx, dy, lines[k])
                      : detector->detect(image, lines[k]);
            else
                i & 4 ? detector->detect(imageOnDevice, dxOnDevice, dyOnDevice, lines[k])
                      : detector->detect(imageOnDevice, lines[k]);
            EXPECT_EQ(k == 0 ? (int)BACKEND_CPU : GetParam(), detector->getActiveBackend());
        }
        EXPECT_EQ(lines[0], lines[1]) << i;
        count += lines[0].size();
    }
    EXPECT_GT(count, 50u);
}

/** Small pools of candidates, with ties at the last one, and cuts that a sample sets too high; the
exact method, candidates that do not climb, estimated directions, and other suppressions. */
TEST_P(Linespace_Devices, the_strongest_candidates)
{
    requireBackend(GetParam());
    const int radii[] = {0, 1, 4, 6};
    for (int i = 0; i < 160; ++i)
    {
        const Mat1b image = randomEdges(Size(40 + 13 * (i % 7), 110 - 9 * (i % 5)),
                                        0.05 + 0.1 * (i % 4), (unsigned)i);
        Mat1b weighted = image.clone();
        if (i % 3 == 0)
            cv::multiply(image, randomEdges(image.size(), 0.5, 3) + 2, weighted, 100);
        UMat weightedOnDevice;
        weighted.copyTo(weightedOnDevice);
        Lines lines[2];
        for (int k = 0; k < 2; ++k)
        {
            const int backend = k == 0 ? (int)BACKEND_CPU : GetParam();
            const Ptr<LineSpaceDetector> detector =
                LineSpaceDetector::create(i % 2 ? 5 : 0, 0, METHOD_CASCADED, 8, backend);
            detector->setFalseAlarms(i % 6 < 3 ? 1 : 3e4);
            detector->setEdgeWeights(i % 3 == 0);
            detector->setCandidateRatio(i % 8 < 4 ? 1 : 0.75);
            detector->setSuppressionDistance(i % 9 < 4 ? 40 : 1);
            detector->setMaxLines(i % 5 > 0 ? 1 + i % 37 : 0);
            detector->setPoolSize(1 << i % 11);
            detector->setSuppressionRadius(radii[i % 4]);
            detector->setMethod(i % 13 == 5 ? METHOD_EXACT : METHOD_CASCADED);
            detector->setSuppression(i % 17 == 3   ? SUPPRESS_BLOCKS
                                     : i % 17 == 9 ? SUPPRESS_GREEDY
                                                   : SUPPRESS_RING);
            const auto detect = [&](InputArray edges)
            {
                if (i % 5 == 1)
                    detector->detect(edges, noArray(), noArray(), lines[k]);
                else
                    detector->detect(edges, lines[k]);
            };
            if (k == 0)
                detect(weighted);
            else
                detect(weightedOnDevice);
            ASSERT_EQ(backend, detector->getActiveBackend());
        }
        ASSERT_EQ(lines[0], lines[1]) << i;
    }
}

INSTANTIATE_TEST_CASE_P(/**/, Linespace_Devices, testing::Values(BACKEND_OPENCL, BACKEND_OPENGL));

} // namespace
} // namespace opencv_test
