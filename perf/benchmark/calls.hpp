// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The methods that are timed, ours and others, behind one interface.

#ifndef LINESPACE_BENCHMARK_CALLS_HPP
#define LINESPACE_BENCHMARK_CALLS_HPP

#include "input.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace benchmark {

struct Stage
{
    std::string name;
    double milliseconds;
};

//! What came of one call.
struct Outcome
{
    double milliseconds;
    int lines;
    bool valid; //!< the lines are the reference's; true where there is no reference
    std::vector<Stage> stages;
};

struct Call
{
    std::string method; //!< its name in the tables
    std::function<Outcome()> run;
    int threads = 0;      //!< 0: as the others
    std::string isa = {}; //!< empty: as this process
};

enum class Kind
{
    DETECT,   //!< as it is
    UNPRUNED, //!< setPruning(false)
    NEW,      //!< a new detector for every call
    EXACT     //!< METHOD_EXACT
};

/** `detect` for the 100 strongest lines above the input's threshold, refined; its lines are
compared with BACKEND_REFERENCE's after every call. */
Call detection(const Input& input, Kind kind);

//! The several kinds of `detect`, with one run of the reference for all.
std::vector<Call> detections(const Input& input, const std::vector<Kind>& kinds);

//! The same by BACKEND_OPENGL; only if isOpenGlThere().
std::vector<Call> openGlDetections(const Input& input, const std::vector<Kind>& kinds);
bool isOpenGlThere();

/** cv::linespace::HoughLines(1, theta), all lines above the threshold; they are compared with those
by BACKEND_REFERENCE after every call. */
Call dropIn(const Input& input, const std::string& step, int threshold);

//! The angle steps that are compared, by name: "1 deg", "0.1 deg" and "1/(2n)", in radians.
double angleStep(const std::string& step, cv::Size size);

//! cv::HoughLines(1, theta).
Call houghLines(const Input& input, const std::string& step, int threshold);

//! The same on cv::UMat; only if isOpenClThere().
Call openClHoughLines(const Input& input, const std::string& step);
bool isOpenClThere();

/** What runs on OpenCL, with one run of the reference for all: `detect` of a cv::UMat, by a detector
that is kept and by a new one; cv::HoughLines and its drop-in at 1 degree on it; the transfer of an
edge map to the device and of as many lines back. Only if isOpenClThere(). */
std::vector<Call> openClCalls(const Input& input);

//! cv::HoughLinesP(1, 1 degree), least length a fifth of the shorter side, gaps of 3 pixels.
Call houghLinesP(const Input& input);

//! cv::ximgproc::FastHoughTransform over all directions: the transform alone, no lines.
Call fastHoughTransform(const Input& input);

//! Line detectors that look for edges themselves: cv::createLineSegmentDetector and
//! cv::ximgproc::createEdgeDrawing, at their defaults, on the grey image.
Call lineSegmentDetector(const Input& input);
Call edgeDrawing(const Input& input);

//! cv::ximgproc::createFastLineDetector on the edge map.
Call fastLineDetector(const Input& input);

//! cv::Canny, which makes the edge map for all the others.
Call canny(const Input& input);

} // namespace benchmark

#endif // LINESPACE_BENCHMARK_CALLS_HPP
