// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "test_precomp.hpp"

#include "test_support.hpp"

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

void skipTest(const std::string& reason)
{
    const char* required = std::getenv("LINESPACE_REQUIRE_BACKENDS");
    if (required && std::string(required) == "1")
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
