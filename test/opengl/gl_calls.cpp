// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Calls one function some times with BACKEND_OPENGL, for test_launches.py, which reads what the
// driver says about it:
//   linespace_gl_calls
// compute|detect|recount|exact|oriented|weighted|houghlines|texture|significant
//     IMAGE CALLS [LOST]
// LOST: which call may fail, as it loses the context; the lines of the others must be the same.

#include "test_gl.hpp"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/linespace.hpp>

#include <cstdio>
#include <cstdlib>
#include <memory>

namespace ls = cv::linespace;

namespace {

void call(const cv::String& function, ls::LineSpaceDetector& detector, const cv::Mat& edges,
          unsigned int texture, cv::Mat& output)
{
    if (function == "compute")
        detector.compute(edges, output);
    else if (function == "houghlines")
        ls::HoughLines(edges, output, 1, CV_PI / 1800, 120);
    else if (texture)
        detector.detectTexture(texture, output);
    else if (function == "oriented")
        detector.detect(edges, cv::noArray(), cv::noArray(), output);
    else
        detector.detect(edges, output);
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 4 && argc != 5)
    {
        std::fprintf(stderr, "usage: linespace_gl_calls FUNCTION IMAGE CALLS [LOST]\n");
        return 2;
    }
    const cv::String function = argv[1];
    cv::Mat image = cv::imread(argv[2], cv::IMREAD_GRAYSCALE), edges, output;
    if (image.empty())
    {
        std::fprintf(stderr, "%s cannot be read\n", argv[2]);
        return 2;
    }
    if (function == "houghlines")
    {
        // Of so many edge pixels that it counts chords first.
        cv::resize(image, image, cv::Size(400, 300), 0, 0, cv::INTER_AREA);
        cv::adaptiveThreshold(image, edges, 1, cv::ADAPTIVE_THRESH_MEAN_C, cv::THRESH_BINARY, 5, 0);
        ls::setDefaultBackend(ls::BACKEND_OPENGL);
    }
    else
    {
        const cv::Size size = function == "exact" ? cv::Size(100, 80) : cv::Size(640, 480);
        cv::resize(image, image, size, 0, 0, cv::INTER_AREA);
        cv::Canny(image, edges, 50, 150);
    }
    const cv::Ptr<ls::LineSpaceDetector> detector = ls::LineSpaceDetector::create(
        edges.rows / 5, 100, function == "exact" ? ls::METHOD_EXACT : ls::METHOD_CASCADED, 8,
        ls::BACKEND_OPENGL);
    if (function == "recount")
        detector->setSuppressionRadius(0); // candidates do not climb
    if (function == "significant")         // lines of a texture
        detector->setThreshold(0);
    if (function == "weighted")
    {
        detector->setEdgeWeights(true);
        detector->setThreshold(255 * 96);
    }
    try
    {
        std::unique_ptr<opencv_test::TestContext> context;
        unsigned int texture = 0;
        if (function == "texture" || function == "significant")
        {
            context.reset(new opencv_test::TestContext);
            texture = context->textureOf(edges, true);
        }
        cv::Mat first;
        for (int i = 0; i < std::atoi(argv[3]); ++i)
        {
            const bool isLost = argc == 5 && i == std::atoi(argv[4]);
            try
            {
                call(function, *detector, edges, texture, output);
            }
            catch (const cv::Exception& exception)
            {
                if (!isLost)
                    throw;
                std::printf("%s\n", exception.err.c_str());
                continue;
            }
            if (i == 0)
                first = output.clone();
            if (first.size() != output.size() || cv::norm(first, output, cv::NORM_INF) != 0)
            {
                std::printf("call %d gives something else\n", i);
                return 1;
            }
        }
    }
    catch (const cv::Exception& exception)
    {
        std::printf("%s\n", exception.err.c_str());
        return 77;
    }
    if (output.empty())
    {
        std::printf("nothing was found\n");
        return 1;
    }
    std::printf("%d levels, %d x %d out\n", detector->getLevelCount(), output.cols, output.rows);
    return 0;
}
