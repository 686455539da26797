// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Calls every kernel on small images and compares with the CPU path; for a simulator of devices,
// which checks what kernels do with memory, or has limits that this machine's device has not:
//   linespace_small_images opencl|cpu [COUNT]
// The first argument is the back end that is to run: cpu, where the device cannot. With COUNT only
// so many small images are taken; the larger ones, too, if these have all options.

#include <opencv2/core/ocl.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/linespace.hpp>

#include <cstdio>
#include <cstdlib>
#include <string>

using cv::linespace::LineSpaceDetector;

namespace {

//! Variants, of which these are of another size than the others: chords so long that several are
//! counted at once, and frames so large that their last levels are pruned, of weights and of bits.
enum
{
    WITH_ALL_OPTIONS = 10,
    SMALL_VARIANTS = 20,
    LONG_CHORDS = 1,
    PRUNED_WEIGHTS = 22,
    PRUNED_BITS = 25,
    VARIANTS = 26
};

int differences = 0;

cv::Size sizeOf(int variant)
{
    return variant == LONG_CHORDS      ? cv::Size(90, 5)
           : variant >= SMALL_VARIANTS ? cv::Size(64, 64)
                                       : cv::Size(1 + variant * 13 % 41, 1 + variant * 7 % 29);
}

void check(bool same, const char* what, int variant, cv::Size size)
{
    if (same)
        return;
    std::printf("%s differs, variant %d of %d x %d\n", what, variant, size.width, size.height);
    ++differences;
}

bool same(const cv::Mat& a, const cv::Mat& b)
{
    return a.size() == b.size() &&
           (a.empty() || (a.type() == b.type() && cv::norm(a, b, cv::NORM_INF) == 0));
}

cv::Ptr<LineSpaceDetector> detectorOf(int variant, const cv::Mat& mask)
{
    const cv::Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(variant % 2 ? 4 : 0);
    detector->setFalseAlarms(1e6);
    detector->setEdgeWeights(variant & 4);
    if (variant & 8)
        detector->setMask(mask);
    detector->setMethod(variant % 5 == 4 ? cv::linespace::METHOD_EXACT
                                         : cv::linespace::METHOD_CASCADED);
    detector->setSuppressionRadius(variant % 3 == 0 ? 0 : variant % 3 == 1 ? 2 : 7);
    if (variant % 6 == 5)
        detector->setSuppression(cv::linespace::SUPPRESS_BLOCKS);
    if (variant % 4 == 3 || variant == PRUNED_BITS)
        detector->setAngleRange(-0.3, 1.2);
    detector->setPoolSize(variant % 7 < 4 ? 10 : 8192);
    detector->setMaxLines(variant % 7 < 4 ? 1 : 0);
    return detector;
}

//! The drop-in, with all angles from -0.2 on below `most`.
void checkHoughLines(const cv::Mat& edges, const cv::UMat& onDevice, double rho, double theta,
                     int threshold, double most, bool weighted, int variant, int expected)
{
    std::vector<cv::Vec3f> byCpu, found;
    cv::linespace::HoughLines(edges, byCpu, rho, theta, threshold, 0, 0, -0.2, most, weighted);
    cv::linespace::setDefaultBackend(expected == cv::linespace::BACKEND_OPENCL
                                         ? cv::linespace::BACKEND_OPENCL // which must not fail
                                         : cv::linespace::BACKEND_AUTO);
    cv::linespace::HoughLines(onDevice, found, rho, theta, threshold, 0, 0, -0.2, most, weighted);
    cv::linespace::setDefaultBackend(cv::linespace::BACKEND_AUTO);
    check(byCpu == found, "HoughLines", variant, edges.size());
}

//! Of so many edge pixels and angles that it asks the table of the frame which lines to count.
void checkDenseHoughLines(cv::RNG& random, int expected)
{
    cv::Mat dense(112, 112, CV_8UC1);
    cv::UMat onDevice;
    random.fill(dense, cv::RNG::UNIFORM, 1, 256);
    dense.copyTo(onDevice);
    checkHoughLines(dense, onDevice, 1, 0.018, 112 * 135, 3, true, VARIANTS, expected);
}

//! A device that was asked for must not be replaced.
void checkThatItFails(const cv::UMat& onDevice)
{
    cv::linespace::setDefaultBackend(cv::linespace::BACKEND_OPENCL);
    bool throws = false;
    try
    {
        std::vector<cv::Vec3f> lines;
        cv::linespace::HoughLines(onDevice, lines, 1, 0.1, 1);
    }
    catch (const cv::Exception& error)
    {
        throws = error.code == cv::Error::OpenCLApiCallError;
    }
    cv::linespace::setDefaultBackend(cv::linespace::BACKEND_AUTO);
    check(throws, "HoughLines on a device that cannot", 0, onDevice.size());
}

} // namespace

int main(int argc, char** argv)
{
    const int count = argc == 3 ? std::atoi(argv[2]) : SMALL_VARIANTS;
    if (argc < 2 || argc > 3 || count < 1 || count > SMALL_VARIANTS)
    {
        std::fprintf(stderr, "usage: linespace_small_images opencl|cpu [COUNT]\n");
        return 2;
    }
    if (!cv::ocl::useOpenCL())
    {
        std::printf("no OpenCL device\n");
        return 77;
    }
    const cv::ocl::Device& device = cv::ocl::Device::getDefault();
    std::printf("%s, work groups of %d\n", device.name().c_str(), (int)device.maxWorkGroupSize());
    const int expected =
        std::string(argv[1]) == "cpu" ? cv::linespace::BACKEND_CPU : cv::linespace::BACKEND_OPENCL;
    cv::RNG random(1);
    int calls = 0;
    for (int variant = 0; variant < VARIANTS; ++variant)
    {
        const bool isLarge = variant >= SMALL_VARIANTS;
        const bool isPruned = variant == PRUNED_WEIGHTS || variant == PRUNED_BITS;
        if (isLarge ? !isPruned || count < WITH_ALL_OPTIONS : variant >= count)
            continue;
        const cv::Size size = sizeOf(variant);
        cv::Mat noise(size, CV_8UC1), large, mask(size, CV_8UC1), dx, dy;
        random.fill(noise, cv::RNG::UNIFORM, 0, 256);
        const cv::Mat edges = noise.mul(noise < 70);
        random.fill(mask, cv::RNG::UNIFORM, 0, 4);
        cv::Sobel(noise, dx, CV_16S, 1, 0);
        cv::Sobel(noise, dy, CV_16S, 0, 1);
        // A part of a larger image, with an offset and a step.
        cv::copyMakeBorder(edges, large, 2, 3, 5, 4, cv::BORDER_CONSTANT, 255);
        cv::UMat largeOnDevice;
        large.copyTo(largeOnDevice);
        const cv::UMat onDevice = largeOnDevice(cv::Rect(5, 2, size.width, size.height));

        const cv::Ptr<LineSpaceDetector> cpu = detectorOf(variant, mask);
        const cv::Ptr<LineSpaceDetector> automatic = detectorOf(variant, mask);
        cv::Mat byCpu, found;
        cpu->detect(edges, byCpu);
        automatic->detect(onDevice, found);
        check(automatic->getActiveBackend() == expected, "back end", variant, size);
        check(same(byCpu, found), "detect", variant, size);
        ++calls;
        if (isLarge) // what else there is does not depend on the size
            continue;
        cpu->detect(edges, dx, dy, byCpu);
        automatic->detect(onDevice, dx, dy, found);
        check(same(byCpu, found), "oriented detect", variant, size);
        cv::UMat dxOnDevice, dyOnDevice;
        dx.convertTo(dxOnDevice, variant % 4 < 2 ? CV_16S : CV_32F);
        dy.convertTo(dyOnDevice, variant % 4 < 2 ? CV_16S : CV_32F);
        automatic->detect(onDevice, dxOnDevice, dyOnDevice, found);
        check(same(byCpu, found), "detect, gradients on the device", variant, size);
        cpu->detect(edges, cv::noArray(), cv::noArray(), byCpu);
        automatic->detect(onDevice, cv::noArray(), cv::noArray(), found);
        check(same(byCpu, found), "detect, estimated gradients", variant, size);
        const int levels = cpu->getLevelCount();
        for (int level = 0; level < levels; ++level)
        {
            cv::UMat table;
            cpu->computeLevel(edges, level, byCpu);
            automatic->computeLevel(onDevice, level, table);
            check(same(byCpu, table.getMat(cv::ACCESS_READ)), "computeLevel", variant, size);
        }
        const bool weighted = variant & 4;
        checkHoughLines(edges, onDevice, 0.5 * (1 << variant % 3), 0.1,
                        size.height / 5 * (weighted ? 40 : 1), 3, weighted, variant, expected);
        calls += 4 + levels;
    }
    if (count >= WITH_ALL_OPTIONS)
        checkDenseHoughLines(random, expected);
    if (expected == cv::linespace::BACKEND_CPU)
        checkThatItFails(cv::UMat(50, 60, CV_8UC1, cv::Scalar(1)));
    std::printf("%d calls, %d differences\n", calls, differences);
    return differences > 0;
}
