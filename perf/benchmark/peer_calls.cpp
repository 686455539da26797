// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "calls.hpp"

#include "common/stopwatch.hpp"

#include "opencv2/core/ocl.hpp"
#include "opencv2/imgproc.hpp"
#include "opencv2/ximgproc.hpp"

#include <algorithm>

namespace benchmark {

namespace {

//! A call of a peer; `work` returns how many lines it found.
Call peer(const std::string& method, const std::function<int()>& work)
{
    return {method, [=]
            {
                int lines = 0;
                const double milliseconds = measure::millisecondsOf([&] { lines = work(); });
                return Outcome{milliseconds, lines, true, {}};
            }};
}

} // namespace

Call houghLines(const Input& input, const std::string& step, int threshold)
{
    const double theta = angleStep(step, input.edges.size());
    return peer("HoughLines " + step,
                [=]
                {
                    std::vector<cv::Vec2f> lines;
                    cv::HoughLines(input.edges, lines, 1, theta, threshold);
                    return (int)lines.size();
                });
}

bool isOpenClThere()
{
    return cv::ocl::useOpenCL();
}

Call openClHoughLines(const Input& input, const std::string& step)
{
    const double theta = angleStep(step, input.edges.size());
    cv::UMat edges;
    input.edges.copyTo(edges);
    const Call call = peer("OpenCL HoughLines " + step,
                           [=]
                           {
                               cv::UMat lines;
                               cv::HoughLines(edges, lines, 1, theta, input.threshold);
                               cv::ocl::finish();
                               return (int)lines.total();
                           });
    call.run(); // compiles its kernels, which must not count
    return call;
}

Call houghLinesP(const Input& input)
{
    const double shortest = std::min(input.edges.cols, input.edges.rows) / 5;
    return peer("HoughLinesP",
                [=]
                {
                    std::vector<cv::Vec4i> segments;
                    cv::HoughLinesP(input.edges, segments, 1, CV_PI / 180, input.threshold,
                                    shortest, 3);
                    return (int)segments.size();
                });
}

Call fastHoughTransform(const Input& input)
{
    return peer("FastHoughTransform",
                [=]
                {
                    cv::Mat table;
                    cv::ximgproc::FastHoughTransform(input.edges, table, CV_32S);
                    return 0;
                });
}

Call lineSegmentDetector(const Input& input)
{
    const auto detector = cv::createLineSegmentDetector();
    return peer("LSD",
                [=]
                {
                    std::vector<cv::Vec4f> segments;
                    detector->detect(input.grey, segments);
                    return (int)segments.size();
                });
}

Call edgeDrawing(const Input& input)
{
    const auto detector = cv::ximgproc::createEdgeDrawing();
    return peer("EdgeDrawing",
                [=]
                {
                    std::vector<cv::Vec4f> segments;
                    detector->detectEdges(input.grey);
                    detector->detectLines(segments);
                    return (int)segments.size();
                });
}

Call fastLineDetector(const Input& input)
{
    // Aperture 0: it takes an edge map as it is, and erases what it uses, hence the copy, which is
    // timed with it (less than a hundredth of its time).
    const auto detector = cv::ximgproc::createFastLineDetector(10, 1.414213562f, 50, 50, 0);
    return peer("FastLineDetector",
                [=]
                {
                    std::vector<cv::Vec4f> segments;
                    detector->detect(input.edges.clone(), segments);
                    return (int)segments.size();
                });
}

Call canny(const Input& input)
{
    return peer("Canny",
                [=]
                {
                    cv::Mat edges;
                    cv::Canny(input.grey, edges, 50, 150);
                    return 0;
                });
}

} // namespace benchmark
