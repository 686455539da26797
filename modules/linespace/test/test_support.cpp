// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "test_precomp.hpp"

#include "test_gl.hpp"
#include "test_support.hpp"

#include <opencv2/core/ocl.hpp>

#include <climits>
#include <cstdlib>

namespace opencv_test {

const char* backendName(int backend)
{
    switch (backend)
    {
    case BACKEND_AUTO: return "auto";
    case BACKEND_REFERENCE: return "reference";
    case BACKEND_CPU: return "cpu";
    case BACKEND_OPENCL: return "opencl";
    case BACKEND_OPENGL: return "opengl";
    default: return "none";
    }
}

namespace {

bool isSet(const char* variable, const std::string& value)
{
    const char* const own = std::getenv(variable);
    return own && own == value;
}

bool findDevice()
{
    if (cv::ocl::useOpenCL())
    {
        std::cout << "OpenCL device of the tests: " << cv::ocl::Device::getDefault().name()
                  << std::endl;
        return true;
    }
    std::cout << "Tests on OpenCL are skipped: OpenCV uses no device (OPENCV_OPENCL_DEVICE=:CPU: "
                 "allows processors)"
              << std::endl;
    if (isSet("LINESPACE_REQUIRE_BACKENDS", "1") && !isSet("OPENCV_OPENCL_RUNTIME", "disabled"))
        CV_Error(Error::StsError, "an OpenCL device is required by LINESPACE_REQUIRE_BACKENDS");
    return false;
}

bool findOpenGl()
{
    std::string reason;
    try
    {
        std::vector<Vec3f> lines;
        LineSpaceDetector::create(1, 0, METHOD_CASCADED, 8, BACKEND_OPENGL)
            ->detect(Mat1b(1, 1, uchar(1)), lines);
        std::cout << "OpenGL of the tests: " << headlessRenderer() << std::endl;
        return true;
    }
    catch (const cv::Exception& exception)
    {
        reason = exception.err;
    }
    std::cout << "Tests on OpenGL are skipped: " << reason << std::endl;
    if (isSet("LINESPACE_REQUIRE_BACKENDS", "1") && !isSet("LINESPACE_EGL_LIBRARY", "disabled"))
        CV_Error(Error::StsError, "OpenGL is required by LINESPACE_REQUIRE_BACKENDS");
    return false;
}

} // namespace

std::vector<int> comparedBackends()
{
    static const bool hasDevice = findDevice(), hasOpenGl = findOpenGl();
    std::vector<int> backends(1, (int)BACKEND_CPU);
    if (hasDevice)
        backends.push_back(BACKEND_OPENCL);
    if (hasOpenGl)
        backends.push_back(BACKEND_OPENGL);
    return backends;
}

bool isCompared(int backend)
{
    const std::vector<int> backends = comparedBackends();
    return std::find(backends.begin(), backends.end(), backend) != backends.end();
}

void requireBackend(int backend)
{
    if (!isCompared(backend))
        throw SkipTestException(std::string("no ") + backendName(backend));
}

std::vector<int> testBackends()
{
    std::vector<int> backends = comparedBackends();
    backends.insert(backends.begin(), (int)BACKEND_REFERENCE);
    return backends;
}

void skipTest(const std::string& reason)
{
    if (isSet("LINESPACE_REQUIRE_BACKENDS", "1"))
        CV_Error(Error::StsError, "required, but it cannot run: " + reason);
    throw SkipTestException(reason);
}

Ptr<LineSpaceDetector> createPlain(int method, int cellSize, int backend, int minVotes)
{
    Ptr<LineSpaceDetector> detector =
        LineSpaceDetector::create(minVotes, 0, method, cellSize, backend);
    detector->setSuppressionRadius(0);
    detector->setSuppressionDistance(0);
    detector->setRefine(REFINE_NONE);
    detector->setCandidateRatio(0);
    return detector;
}

bool expectSameTable(const Mat& actual, const Mat& expected, const TableOrigin& origin)
{
    std::ostringstream where;
    where << "back end " << backendName(origin.backend) << ", image " << origin.image
          << ", cellSize " << origin.cellSize << ", level " << origin.level << ", cells of "
          << origin.cell;
    if (actual.type() != CV_32SC1 || actual.size() != expected.size())
    {
        ADD_FAILURE() << where.str() << ": table of type " << actual.type() << " and size "
                      << actual.size() << ", expected CV_32SC1 and " << expected.size();
        return false;
    }
    const int points = brute::borderCount(origin.cell);
    for (int row = 0; row < expected.rows; ++row)
        for (int column = 0; column < expected.cols; ++column)
            if (actual.at<int>(row, column) != expected.at<int>(row, column))
            {
                ADD_FAILURE() << where.str() << ", cell in row " << row / points << ", column "
                              << column / points << ", chord (" << row % points << ", "
                              << column % points << "): " << actual.at<int>(row, column)
                              << " votes, expected " << expected.at<int>(row, column);
                return false;
            }
    return true;
}

int leastThreshold()
{
    try
    {
        Mat lines;
        cv::HoughLines(Mat1b(3, 3, (uchar)0), lines, 1, CV_PI / 180, -1);
    }
    catch (const cv::Exception&)
    {
        return 0;
    }
    return INT_MIN;
}

std::string wrongException(const std::function<void()>& call, const std::vector<std::string>& words)
{
    try
    {
        call();
    }
    catch (const cv::Exception& exception)
    {
        for (size_t i = 0; i < words.size(); ++i)
            if (exception.err.find(words[i]) == std::string::npos)
                return "the message lacks '" + words[i] + "': " + exception.err;
        return std::string();
    }
    catch (const std::exception& exception)
    {
        return std::string("another exception: ") + exception.what();
    }
    return "no exception";
}

} // namespace opencv_test
