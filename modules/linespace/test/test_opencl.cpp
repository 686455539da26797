// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// When the OpenCL path runs; that it counts the same is a matter of the tests of all back ends.

#include "test_precomp.hpp"

#include "generators.hpp"
#include "test_support.hpp"

#include <opencv2/core/ocl.hpp>

#include <thread>

namespace opencv_test {
namespace {

using namespace generators;

typedef std::vector<Vec3f> Lines;

//! OpenCV uses OpenCL in this thread, or does not, as long as it lives.
class UseOpenCl
{
public:
    explicit UseOpenCl(bool use) : before_(cv::ocl::useOpenCL()) { cv::ocl::setUseOpenCL(use); }
    ~UseOpenCl() { cv::ocl::setUseOpenCL(before_); }

private:
    const bool before_;
};

bool hasDevice()
{
    return isCompared(BACKEND_OPENCL);
}

class Linespace_OpenCl : public testing::Test
{
protected:
    Linespace_OpenCl() : edges(randomEdges(Size(90, 70), 0.2, 1)), expected()
    {
        edges.copyTo(onDevice);
        detectorFor(BACKEND_CPU)->detect(edges, expected);
    }
    static Ptr<LineSpaceDetector> detectorFor(int backend)
    {
        return LineSpaceDetector::create(20, 0, METHOD_CASCADED, 8, backend);
    }

    //! The device where there is one; a failure of it is none of BACKEND_AUTO, which would compare the
    //! CPU path with itself.
    static Ptr<LineSpaceDetector> detectorOfDevice()
    {
        return detectorFor(hasDevice() ? BACKEND_OPENCL : BACKEND_CPU);
    }

    //! Of so many edge pixels that the drop-in counts chords.
    static Mat1b denseEdges() { return randomEdges(Size(400, 300), 0.5, 1); }

    const Mat1b edges;
    UMat onDevice;
    Lines expected;
};

TEST_F(Linespace_OpenCl, auto_takes_it_for_a_umat)
{
    const Ptr<LineSpaceDetector> detector = detectorFor(BACKEND_AUTO);
    for (int round = 0; round < 2; ++round)
    {
        Lines lines;
        detector->detect(onDevice, lines);
        EXPECT_EQ(hasDevice() ? BACKEND_OPENCL : BACKEND_CPU, detector->getActiveBackend());
        EXPECT_EQ(expected, lines);
        detector->detect(edges, lines);
        EXPECT_EQ(BACKEND_CPU, detector->getActiveBackend());
        EXPECT_EQ(expected, lines);
    }
}

TEST_F(Linespace_OpenCl, a_named_one_takes_any_array)
{
    if (!hasDevice())
        throw SkipTestException("no OpenCL device");
    const Ptr<LineSpaceDetector> detector = detectorFor(BACKEND_OPENCL);
    Lines fromMat, fromUMat;
    UMat lines;
    detector->detect(edges, fromMat);
    detector->detect(onDevice, fromUMat);
    detector->detect(onDevice, lines);
    EXPECT_EQ(BACKEND_OPENCL, detector->getActiveBackend());
    EXPECT_EQ(expected, fromMat);
    EXPECT_EQ(expected, fromUMat);
    const Mat_<Vec3f> read = lines.getMat(ACCESS_READ);
    EXPECT_EQ(expected, Lines(read.begin(), read.end()));
}

TEST_F(Linespace_OpenCl, switched_off)
{
    const UseOpenCl off(false);
    const Lines sentinel(2, Vec3f(1, 2, 3));
    Lines lines = sentinel;
    EXPECT_EQ("", wrongException([&]() { detectorFor(BACKEND_OPENCL)->detect(edges, lines); },
                                 {"backend", "BACKEND_OPENCL", "device"}));
    EXPECT_EQ(sentinel, lines);
    const Ptr<LineSpaceDetector> detector = detectorFor(BACKEND_AUTO);
    detector->detect(onDevice, lines);
    EXPECT_EQ(BACKEND_CPU, detector->getActiveBackend());
    EXPECT_EQ(expected, lines);
}

//! One detector for images of more sizes than it keeps tables of, on the device and on the host in turns.
TEST_F(Linespace_OpenCl, sizes_and_back_ends_in_turns)
{
    const Ptr<LineSpaceDetector> detector = detectorFor(BACKEND_AUTO);
    for (int i = 0; i < 14; ++i)
    {
        const Rect part(0, 0, 40 + 7 * (i % 6), 60 - 5 * (i % 6));
        Lines own, lines;
        detectorFor(BACKEND_CPU)->detect(edges(part), own);
        i % 4 == 3 ? detector->detect(edges(part), lines) : detector->detect(onDevice(part), lines);
        EXPECT_EQ(own, lines) << i;
    }
}

//! Parts of images, weights, masks that come and go; the output on the device and on the host.
TEST_F(Linespace_OpenCl, images_on_the_device)
{
    const Mat1b large = randomEdges(Size(120, 100), 0.3, 7) * 200;
    UMat largeOnDevice;
    large.copyTo(largeOnDevice);
    const Rect part(5, 3, 83, 61);
    const Mat1b masks[] = {Mat1b(), randomEdges(part.size(), 0.7, 8), Mat1b(),
                           randomEdges(part.size(), 0.7, 9)};
    const int backends[] = {BACKEND_CPU, hasDevice() ? BACKEND_OPENCL : BACKEND_CPU};
    Ptr<LineSpaceDetector> detectors[2];
    for (int k = 0; k < 2; ++k)
        detectors[k] = detectorFor(backends[k]);
    for (int i = 0; i < 8; ++i)
    {
        Lines lines[2];
        for (int k = 0; k < 2; ++k)
        {
            detectors[k]->setEdgeWeights(i >= 4);
            detectors[k]->setThreshold(i >= 4 ? 3000 : 15);
            detectors[k]->setMask(masks[i % 4]);
        }
        detectors[0]->detect(large(part), lines[0]);
        detectors[1]->detect(largeOnDevice(part), lines[1]);
        EXPECT_EQ(lines[0], lines[1]) << i;
        EXPECT_FALSE(lines[0].empty());
        for (int l = detectors[0]->getLevelCount() - 1; l >= 0; --l)
        {
            Mat expectedTable, table;
            UMat tableOnDevice, margins;
            detectors[0]->computeLevel(large(part), l, expectedTable);
            detectors[1]->computeLevel(largeOnDevice(part), l, tableOnDevice);
            detectors[1]->computeLevel(largeOnDevice(part), l, table);
            EXPECT_EQ(0, cvtest::norm(expectedTable, table, NORM_INF)) << i << ", " << l;
            EXPECT_EQ(0, cvtest::norm(expectedTable, tableOnDevice.getMat(ACCESS_READ), NORM_INF))
                << i << ", " << l;
            margins.create(expectedTable.rows + 7, expectedTable.cols + 5, CV_32SC1);
            margins.setTo(-1);
            detectors[1]->computeLevel(largeOnDevice(part), l,
                                       margins(Rect(3, 2, expectedTable.cols, expectedTable.rows)));
            Mat expectedMargins;
            cv::copyMakeBorder(expectedTable, expectedMargins, 2, 5, 3, 2, BORDER_CONSTANT, -1);
            EXPECT_EQ(0, cvtest::norm(expectedMargins, margins.getMat(ACCESS_READ), NORM_INF));
        }
    }
}

TEST_F(Linespace_OpenCl, a_umat_of_the_host)
{
    UMat onHost, table;
    {
        const UseOpenCl off(false);
        edges.copyTo(onHost);
    }
    const Ptr<LineSpaceDetector> detector = detectorFor(BACKEND_AUTO);
    Lines lines;
    detector->detect(onHost, lines);
    EXPECT_EQ(expected, lines);
    EXPECT_EQ(hasDevice() ? BACKEND_OPENCL : BACKEND_CPU, detector->getActiveBackend());
    Mat expectedTable;
    detectorFor(BACKEND_CPU)->compute(edges, expectedTable);
    detector->compute(onHost, table);
    EXPECT_EQ(0, cvtest::norm(expectedTable, table.getMat(ACCESS_READ), NORM_INF));
    {
        const UseOpenCl off(false);
        detector->compute(onDevice, table);
        EXPECT_EQ(0, cvtest::norm(expectedTable, table.getMat(ACCESS_READ), NORM_INF));
        EXPECT_EQ(BACKEND_CPU, detector->getActiveBackend());
    }
}

//! Each thread has a queue of its own, and nothing waits for the device.
TEST_F(Linespace_OpenCl, one_detector_from_one_thread_after_another)
{
    const Ptr<LineSpaceDetector> detector = detectorOfDevice();
    const Mat1b images[] = {randomEdges(Size(300, 200), 0.1, 1),
                            randomEdges(Size(300, 200), 0.6, 2)};
    for (int round = 0; round < 6; ++round)
    {
        Mat expectedTable;
        detectorFor(BACKEND_CPU)->compute(images[round % 2], expectedTable);
        std::thread(
            [&]()
            {
                UMat image, onDeviceTable;
                images[round % 2].copyTo(image);
                detector->compute(image, onDeviceTable);
                detector->compute(onDevice, onDeviceTable); // queued when the thread ends
            })
            .join();
        UMat image, onDeviceTable;
        images[round % 2].copyTo(image);
        detector->compute(image, onDeviceTable);
        EXPECT_EQ(0, cvtest::norm(expectedTable, onDeviceTable.getMat(ACCESS_READ), NORM_INF));
    }
}

//! Detectors in threads of their own, at the same time.
TEST_F(Linespace_OpenCl, detectors_of_several_threads)
{
    std::vector<std::thread> threads;
    std::vector<Lines> lines(4);
    for (size_t i = 0; i < lines.size(); ++i)
        threads.push_back(std::thread(
            [this, i, &lines]()
            {
                UMat own;
                edges.copyTo(own);
                const Ptr<LineSpaceDetector> detector = detectorOfDevice();
                for (int round = 0; round < 5; ++round)
                    detector->detect(own, lines[i]);
            }));
    for (size_t i = 0; i < threads.size(); ++i)
        threads[i].join();
    for (size_t i = 0; i < lines.size(); ++i)
        EXPECT_EQ(expected, lines[i]);
}

TEST_F(Linespace_OpenCl, random_sizes_and_densities)
{
    RNG random(5);
    for (int i = 0; i < 200; ++i)
    {
        const Size size(random.uniform(1, 260), random.uniform(1, 200));
        const Mat1b image = randomEdges(size, random.uniform(0., 1.), (unsigned)i);
        UMat imageOnDevice;
        Mat1b(image * random.uniform(1, 256)).copyTo(imageOnDevice);
        const int backends[] = {BACKEND_CPU, hasDevice() ? BACKEND_OPENCL : BACKEND_CPU};
        Lines lines[2], oriented[2];
        Mat tables[2];
        for (int k = 0; k < 2; ++k)
        {
            const Ptr<LineSpaceDetector> detector = detectorFor(backends[k]);
            detector->setEdgeWeights(i % 4 == 3);
            detector->setThreshold(std::min(size.width, size.height) / 2);
            detector->setMaxLines(200);
            if (i % 3 == 0)
                detector->setMask(randomEdges(size, 0.8, (unsigned)i + 1000));
            UMat table;
            detector->detect(imageOnDevice, lines[k]);
            detector->detect(imageOnDevice, noArray(), noArray(), oriented[k]);
            detector->compute(imageOnDevice, table);
            table.copyTo(tables[k]);
        }
        ASSERT_EQ(lines[0], lines[1]) << i << ": " << size;
        ASSERT_EQ(oriented[0], oriented[1]) << i << ": " << size;
        ASSERT_EQ(0, cvtest::norm(tables[0], tables[1], NORM_INF)) << i << ": " << size;
    }
}

/** All small sizes and some odd and large ones, twice, some of them ten times: each output of the device
is the CPU path's, plain, weighted, masked, oriented, and of the drop-in. */
TEST_F(Linespace_OpenCl, every_output)
{
    std::vector<Size> sizes;
    for (int width = 1; width <= 20; ++width)
        for (int height = 1; height <= 20; ++height)
            sizes.push_back(Size(width, height));
    for (const Size& size :
         {Size(1, 301), Size(257, 2), Size(97, 101), Size(255, 257), Size(640, 480)})
        sizes.push_back(size);
    for (size_t i = 0; i < sizes.size(); ++i)
    {
        const Mat1b image = randomEdges(sizes[i], 0.3, (unsigned)i) * 200,
                    mask = randomEdges(sizes[i], 0.8, (unsigned)i + 500);
        Mat dx, dy;
        cv::Sobel(image, dx, CV_16S, 1, 0);
        cv::Sobel(image, dy, CV_16S, 0, 1);
        UMat imageOnDevice, dxOnDevice, dyOnDevice;
        image.copyTo(imageOnDevice);
        dx.copyTo(dxOnDevice);
        dy.copyTo(dyOnDevice);
        const bool isWeighted = i % 2, isMasked = i % 3 == 0;
        const auto detectorWith = [&](int backend)
        {
            const Ptr<LineSpaceDetector> detector = detectorFor(backend);
            detector->setEdgeWeights(isWeighted);
            detector->setThreshold(std::max(1, sizes[i].width / 3 * (isWeighted ? 200 : 1)));
            if (isMasked)
                detector->setMask(mask);
            return detector;
        };
        const Ptr<LineSpaceDetector> cpu = detectorWith(BACKEND_CPU),
                                     ofDevice =
                                         detectorWith(hasDevice() ? BACKEND_OPENCL : BACKEND_CPU);
        Lines byCpu, oriented, dropIn;
        Mat table;
        cpu->detect(image, byCpu);
        cpu->detect(image, dx, dy, oriented);
        cpu->compute(image, table);
        cv::linespace::HoughLines(image, dropIn, 1, CV_PI / 90, sizes[i].width / 3);
        for (int round = 0; round < (i % 7 ? 2 : 10); ++round)
        {
            Lines lines;
            ofDevice->detect(imageOnDevice, lines);
            ASSERT_EQ(byCpu, lines) << sizes[i] << ", " << round;
            ofDevice->detect(imageOnDevice, dxOnDevice, dyOnDevice, lines);
            ASSERT_EQ(oriented, lines) << sizes[i] << ", " << round;
            cv::linespace::HoughLines(imageOnDevice, lines, 1, CV_PI / 90, sizes[i].width / 3);
            ASSERT_EQ(dropIn, lines) << sizes[i] << ", " << round;
            UMat onDeviceTable;
            ofDevice->compute(imageOnDevice, onDeviceTable);
            ASSERT_EQ(0, cvtest::norm(table, onDeviceTable.getMat(ACCESS_READ), NORM_INF))
                << sizes[i] << ", " << round;
        }
        if (hasDevice())
        {
            ASSERT_EQ(BACKEND_OPENCL, ofDevice->getActiveBackend());
        }
    }
}

//! Nearly all chords have no votes, so that the last merge is passed over but for these.
TEST_F(Linespace_OpenCl, lines_alone)
{
    RNG random(6);
    for (int i = 0; i < 110; ++i)
    {
        Mat1b image(120 + i, 230 - i, uchar(0));
        for (int k = 0; k < 6; ++k)
        {
            const Point begin(random.uniform(0, image.cols), random.uniform(0, image.rows));
            const double angle = random.uniform(0., CV_PI);
            const Point along(cvRound(500 * std::cos(angle)), cvRound(500 * std::sin(angle)));
            cv::line(image, begin - along, begin + along, 255);
        }
        UMat imageOnDevice;
        image.copyTo(imageOnDevice);
        const Ptr<LineSpaceDetector> cpu = detectorFor(BACKEND_CPU);
        const Ptr<LineSpaceDetector> ofDevice = detectorOfDevice();
        for (const Ptr<LineSpaceDetector>& detector : {cpu, ofDevice})
        {
            detector->setCandidateRatio(1);
            detector->setSuppressionRadius(0);
            detector->setSuppressionDistance(0);
            detector->setRefine(REFINE_NONE);
        }
        // Once more so that only the strongest chords are asked for.
        for (int threshold = 40, round = 0; round < 2; ++round)
        {
            Lines byCpu, byDevice;
            cpu->setThreshold(threshold);
            ofDevice->setThreshold(threshold);
            cpu->detect(image, byCpu);
            ofDevice->detect(imageOnDevice, byDevice);
            ASSERT_EQ(byCpu, byDevice) << i << ", " << threshold;
            ASSERT_TRUE(round > 0 || !byCpu.empty());
            Mat table;
            cpu->compute(image, table);
            double most;
            cv::minMaxLoc(table, nullptr, &most);
            threshold = (int)most - 1;
        }
    }
}

/** One detector for images of all kinds: it begins with what it learnt from the last one, which may
be a cut that is much too high, or that most of the table is needed. */
TEST_F(Linespace_OpenCl, pruned_levels)
{
    const Size sizes[] = {Size(256, 256), Size(500, 260), Size(320, 512)};
    const int radii[] = {0, 1, 4}, pools[] = {1, 300, 8192};
    int pruned = 0;
    for (int i = 0; i < 27; ++i)
    {
        const Size size = sizes[i % 3];
        Ptr<LineSpaceDetector> detectors[2];
        for (int k = 0; k < 2; ++k)
        {
            detectors[k] = k == 0 ? detectorFor(BACKEND_CPU) : detectorOfDevice();
            detectors[k]->setPruning(k == 1);
            detectors[k]->setSuppressionRadius(radii[i / 3 % 3]);
            detectors[k]->setPoolSize(pools[i / 9]);
            detectors[k]->setMaxLines(i % 4 == 3 ? 0 : 1 + i);
            detectors[k]->setThreshold(i % 4 == 1 ? 0 : i % 4 == 2 ? 12 : 50);
            detectors[k]->setRefine(REFINE_NONE);
        }
        std::vector<Vec2d> lines;
        const Mat images[] = {linesInNoise(size, 12, 0.02, i, lines),
                              linesInNoise(size, 3, 0.001, i, lines),
                              randomEdges(size, 0.05, i),
                              randomEdges(size, 0.4, i),
                              whiteEdges(size),
                              onePixel(size, Point(7, size.height / 2)),
                              Mat::zeros(size, CV_8UC1)};
        for (int round = 0; round < 7; ++round)
        {
            const Mat& image = images[round * 4 % 7];
            SCOPED_TRACE(format("%d, round %d", i, round));
            Lines byCpu, byDevice;
            detectors[0]->detect(image, byCpu);
            detectors[1]->detect(image.getUMat(ACCESS_READ), byDevice);
            ASSERT_EQ(byCpu, byDevice);
            std::vector<String> stages;
            std::vector<double> milliseconds;
            detectors[1]->getStageTimes(stages, milliseconds);
            const String last = format("level %d", detectors[1]->getLevelCount() - 1);
            pruned +=
                stages.size() > 1 && stages.end() == std::find(stages.begin(), stages.end(), last);
        }
    }
    EXPECT_GT(pruned, 100);
}

TEST_F(Linespace_OpenCl, the_drop_in_of_a_umat)
{
    const Mat1b dense = denseEdges();
    UMat denseOnDevice, lines;
    dense.copyTo(denseOnDevice);
    std::vector<Vec3f> byCpu, byDevice;
    cv::linespace::HoughLines(dense, byCpu, 1, CV_PI / 900, 220);
    cv::linespace::HoughLines(denseOnDevice, byDevice, 1, CV_PI / 900, 220);
    cv::linespace::HoughLines(denseOnDevice, lines, 1, CV_PI / 900, 220);
    ASSERT_FALSE(byCpu.empty());
    EXPECT_EQ(byCpu, byDevice);
    EXPECT_EQ((int)byCpu.size(), lines.rows);
}

TEST_F(Linespace_OpenCl, the_default_back_end_of_the_process)
{
    if (!hasDevice())
        throw SkipTestException("no OpenCL device");
    std::vector<Vec3f> byCpu, byDevice;
    const Mat1b dense = denseEdges();
    cv::linespace::HoughLines(dense, byCpu, 1, CV_PI / 900, 220);
    setDefaultBackend(BACKEND_OPENCL);
    const Ptr<LineSpaceDetector> detector = detectorFor(BACKEND_AUTO);
    Lines lines;
    detector->detect(edges, lines);
    const int active = detector->getActiveBackend();
    cv::linespace::HoughLines(dense, byDevice, 1, CV_PI / 900, 220);
    setDefaultBackend(BACKEND_AUTO);
    EXPECT_EQ(BACKEND_OPENCL, active);
    EXPECT_EQ(expected, lines);
    EXPECT_EQ(byCpu, byDevice);
}

} // namespace
} // namespace opencv_test
