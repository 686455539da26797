// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "calls.hpp"

#include "common/stopwatch.hpp"

#include "opencv2/core/ocl.hpp"
#include "opencv2/linespace.hpp"

namespace benchmark {

namespace {

namespace ls = cv::linespace;

cv::Ptr<ls::LineSpaceDetector> detectorOf(const Input& input, int backend)
{
    return ls::LineSpaceDetector::create(input.threshold, 100, ls::METHOD_CASCADED, 8, backend);
}

Call detection(const std::string& method, const Input& input, const cv::UMat& edges, bool isNew,
               const std::shared_ptr<const std::vector<cv::Vec3f>>& expected)
{
    const auto kept = detectorOf(input, ls::BACKEND_OPENCL);
    return {method, [=]
            {
                auto detector = kept;
                std::vector<cv::Vec3f> lines;
                const double milliseconds = measure::millisecondsOf(
                    [&]
                    {
                        if (isNew)
                            detector = detectorOf(input, ls::BACKEND_OPENCL);
                        detector->detect(edges, lines);
                    });
                return Outcome{milliseconds, (int)lines.size(), lines == *expected, {}};
            }};
}

//! Without lines that could be compared.
Call timed(const std::string& method, const std::function<void()>& work)
{
    return {method, [=]
            {
                return Outcome{measure::millisecondsOf(work), 0, true, {}};
            }};
}

} // namespace

std::vector<Call> openClCalls(const Input& input)
{
    cv::UMat edges;
    input.edges.copyTo(edges);
    const auto expected = std::make_shared<std::vector<cv::Vec3f>>();
    detectorOf(input, ls::BACKEND_REFERENCE)->detect(input.edges, *expected);
    cv::UMat lines;
    cv::Mat(*expected).copyTo(lines);
    const cv::Mat dropInLines = [&]
    {
        cv::Mat found;
        ls::HoughLines(input.edges, found, 1, angleStep("1 deg", input.edges.size()),
                       input.threshold);
        return found;
    }();
    const Call dropIn = {
        "OpenCL drop-in 1 deg", [=]
        {
            cv::Mat found;
            const double milliseconds = measure::millisecondsOf(
                [&] {
                    ls::HoughLines(edges, found, 1, angleStep("1 deg", input.edges.size()),
                                   input.threshold);
                });
            const bool same = found.size() == dropInLines.size() &&
                              (found.empty() || cv::norm(found, dropInLines, cv::NORM_INF) == 0);
            return Outcome{milliseconds, found.rows, same, {}};
        }};
    return {detection("OpenCL Line Space", input, edges, false, expected),
            detection("OpenCL Line Space first call", input, edges, true, expected),
            dropIn,
            openClHoughLines(input, "1 deg"),
            timed("OpenCL edge map in",
                  [=]
                  {
                      cv::UMat uploaded = edges;
                      input.edges.copyTo(uploaded);
                      cv::ocl::finish();
                  }),
            timed("OpenCL lines out",
                  [=]
                  {
                      cv::Mat read;
                      lines.copyTo(read);
                  })};
}

} // namespace benchmark
