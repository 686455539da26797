// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Calls one function two to four times, UMat in, UMat out, for test_launches.py, which reads the
// device's own account of it:
//   linespace_device_calls FUNCTION IMAGE
// FUNCTION: compute, houghlines, houghlines-dense, or detect with parameters: detect, estimated,
// oriented, recount, exact, explained, significant, significant-masked, significant-oriented,
// interval, greedy, blocks, sizes (of an image, of a part of it, and again). The last call's lines of
// standard error stand between "warm call begins" and "warm call ends", which may stand in the middle
// of a line of another thread.

#include <opencv2/core/ocl.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/linespace.hpp>

#include <cstdio>

int main(int argc, char** argv)
{
    if (argc != 3)
    {
        std::fprintf(stderr, "usage: linespace_device_calls FUNCTION IMAGE\n");
        return 2;
    }
    const cv::String function = argv[1];
    cv::Mat image = cv::imread(argv[2], cv::IMREAD_GRAYSCALE), edges, gradient;
    if (image.empty())
    {
        std::fprintf(stderr, "%s cannot be read\n", argv[2]);
        return 2;
    }
    if (!cv::ocl::useOpenCL())
    {
        std::printf("no OpenCL device\n");
        return 77;
    }
    std::printf("%s\n", cv::ocl::Device::getDefault().name().c_str());
    if (function == "houghlines-dense")
    {
        // Of so many edge pixels that it counts chords first.
        cv::resize(image, image, cv::Size(400, 300), 0, 0, cv::INTER_AREA);
        cv::adaptiveThreshold(image, edges, 1, cv::ADAPTIVE_THRESH_MEAN_C, cv::THRESH_BINARY, 5, 0);
    }
    else
    {
        const cv::Size size = function == "exact" ? cv::Size(100, 80) : cv::Size(640, 480);
        cv::resize(image, image, size, 0, 0, cv::INTER_AREA);
        cv::Canny(image, edges, 50, 150);
    }
    cv::UMat input, dx, dy, output;
    edges.copyTo(input);
    cv::Sobel(image, gradient, CV_32F, 1, 0);
    gradient.copyTo(dx);
    cv::Sobel(image, gradient, CV_32F, 0, 1);
    gradient.copyTo(dy);
    const cv::Ptr<cv::linespace::LineSpaceDetector> detector =
        cv::linespace::LineSpaceDetector::create(edges.rows / 5, 100);
    if (function == "recount")
    {
        detector->setSuppressionRadius(0); // candidates do not climb: the device counts them again
        detector->setPruning(false);       // and of whole tables
    }
    if (function == "exact")
        detector->setMethod(cv::linespace::METHOD_EXACT);
    else if (function == "explained")
        detector->setSelection(cv::linespace::SELECT_EXPLAIN);
    else if (function.find("significant") == 0)
        detector->setThreshold(0);
    else if (function == "interval")
        detector->setAngleRange(-0.5, 0.8);
    else if (function == "greedy")
        detector->setSuppression(cv::linespace::SUPPRESS_GREEDY);
    else if (function == "blocks")
        detector->setSuppression(cv::linespace::SUPPRESS_BLOCKS);
    if (function == "significant-masked")
        detector->setMask(cv::Mat(edges.size(), CV_8UC1, cv::Scalar(1)));
    // Where pruning was in vain, the second call is the first of whole tables.
    const int calls = function == "sizes" ? 4 : function.find("significant") == 0 ? 3 : 2;
    for (int call = 0; call < calls; ++call)
    {
        std::fprintf(stderr, call < calls - 1 ? "first call begins\n" : "warm call begins\n");
        if (function == "compute")
            detector->compute(input, output);
        else if (function == "houghlines")
            cv::linespace::HoughLines(input, output, 1, CV_PI / 180, 120);
        else if (function == "houghlines-dense")
            cv::linespace::HoughLines(input, output, 1, CV_PI / 1800, 250);
        else if (function == "oriented" || function == "significant-oriented")
            detector->detect(input, dx, dy, output);
        else if (function == "estimated")
            detector->detect(input, cv::noArray(), cv::noArray(), output);
        else if (function == "sizes" && call % 2 == 0)
            detector->detect(input(cv::Rect(0, 0, 600, 400)), output);
        else
            detector->detect(input, output);
    }
    std::fprintf(stderr, "warm call ends\n");
    cv::ocl::finish();
    if (output.empty())
    {
        std::printf("nothing was found\n");
        return 1;
    }
    std::printf("%d levels, %d x %d out\n", detector->getLevelCount(), output.cols, output.rows);
    return 0;
}
