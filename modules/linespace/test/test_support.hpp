// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// What the accuracy tests share: which back ends run, how tables are compared, how a test is
// skipped.

#ifndef OPENCV_LINESPACE_TEST_SUPPORT_HPP
#define OPENCV_LINESPACE_TEST_SUPPORT_HPP

#include "opencv2/linespace.hpp"
#include "brute_force.hpp"

namespace opencv_test {

using namespace cv::linespace;

/** The back ends every test of votes runs on: the processor's, OpenCL where OpenCV uses a device, and
OpenGL where there is a context. Tells once which devices these are, or why there is none, which with
LINESPACE_REQUIRE_BACKENDS=1 is an error (but with OPENCV_OPENCL_RUNTIME=disabled and
LINESPACE_EGL_LIBRARY=disabled). */
std::vector<int> testBackends();
//! The same without the reference: those that are compared with it.
std::vector<int> comparedBackends();
bool isCompared(int backend);
//! Skips a test, from its body, if it is not. (What a fixture throws is no skipped test.)
void requireBackend(int backend);
#define LINESPACE_TEST_BACKENDS testing::ValuesIn(testBackends())

const char* backendName(int backend);

//! The back end of the process, as long as it lives. A named device must not fail.
class DefaultBackend
{
public:
    explicit DefaultBackend(int backend) { setDefaultBackend(backend); }
    ~DefaultBackend() { setDefaultBackend(BACKEND_AUTO); }
};

/** Ends the calling test as skipped, with the reason. With LINESPACE_REQUIRE_BACKENDS=1 in the
environment, as continuous integration sets it, it fails instead: nothing that is missing goes
unnoticed there. */
void skipTest(const std::string& reason);

//! A detector that reports every chord above the threshold: no suppression, no refinement.
Ptr<LineSpaceDetector> createPlain(int method, int cellSize, int backend, int minVotes = 1);

//! Where a table comes from; printed with the first entry that is wrong.
struct TableOrigin
{
    TableOrigin(int backend_, const Size& image_, int cellSize_, int level_, const Size& cell_)
        : backend(backend_), image(image_), cellSize(cellSize_), level(level_), cell(cell_)
    {
    }
    int backend;
    Size image;
    int cellSize;
    int level;
    Size cell; //!< of the level
};
//! Tolerance 0, type and size included; false and one failure with cell, chord and both values
//! otherwise.
bool expectSameTable(const Mat& actual, const Mat& expected, const TableOrigin& origin);

//! Sets cv::setNumThreads and restores it.
class ThreadCount
{
public:
    explicit ThreadCount(int count) : before(getNumThreads()) { setNumThreads(count); }
    ~ThreadCount() { setNumThreads(before); }

private:
    ThreadCount(const ThreadCount&);
    ThreadCount& operator=(const ThreadCount&);
    int before;
};

//! The smallest threshold that HoughLines takes: from OpenCV 5.1 on, cv::HoughLines refuses negative
//! ones, and so does ours.
int leastThreshold();

//! Empty if the statement threw a cv::Exception whose message has all words; what is wrong
//! otherwise.
std::string wrongException(const std::function<void()>& call,
                           const std::vector<std::string>& words);

} // namespace opencv_test

#endif // OPENCV_LINESPACE_TEST_SUPPORT_HPP
