// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The detectors that are evaluated, ours and others, behind one interface.

#ifndef LINESPACE_ACCURACY_DETECTORS_HPP
#define LINESPACE_ACCURACY_DETECTORS_HPP

#include <functional>
#include <string>
#include <vector>

#include "opencv2/core.hpp"

namespace accuracy {

//! What every detector is given; each takes of it what it can use.
struct EdgeInput
{
    cv::Mat1b grey;   //!< the image that the edge map was made from, already smoothed
    cv::Mat1b edges;  //!< of cv::Canny
    cv::Mat1s dx, dy; //!< of cv::Sobel, 3 x 3, on grey
};

//! x cos(theta) + y sin(theta) = rho in pixels, pixel centres at integers.
struct DetectedLine
{
    double rho, theta;
    double votes; //!< edge pixels; of segment detectors the length of the line's segments in pixels
};

struct Request
{
    int maxLines; //!< the strongest so many; 0: all
    //! Least votes; 0: each detector's own rule, and minVotesWithoutRule where it has none.
    int minVotes;
};

//! What one detector finds, strongest first.
struct Result
{
    std::string detector; //!< its name in the tables
    std::vector<DetectedLine> lines;
};

//! One run can give several results: with and without suppression.
using Detector = std::function<std::vector<Result>(const EdgeInput&, const Request&)>;

/** Vote threshold as a share of the image's shorter side: low enough that the strongest lines are
what is compared, the same for all detectors and images. */
int lowThreshold(cv::Size size);

//! Threshold of the detectors that have no rule of their own: 0.3 of the image's shorter side.
int minVotesWithoutRule(cv::Size size);

//! cv::linespace: plain, plain with SELECT_EXPLAIN, oriented with SELECT_EXPLAIN.
std::vector<Detector> ourDetectors();
//! The two with SELECT_EXPLAIN.
std::vector<Detector> ourDetectorsByOwnRule();
//! The oriented one without refinement, and by METHOD_EXACT (slow).
Detector unrefinedDetector();
Detector exactDetector();

//! cv::HoughLines in three resolutions with and without suppression (the same thing where one line is
//! asked for), cv::ximgproc::FastHoughTransform, LSD, cv::ximgproc::FastLineDetector.
std::vector<Detector> peerDetectors();
//! Those whose own rule is compared: cv::HoughLines at 1 pixel and 1 degree, suppressed, and LSD.
std::vector<Detector> peerDetectorsByOwnRule();

//! Ours and the peers.
std::vector<Detector> allDetectors();
std::vector<Detector> detectorsByOwnRule();

} // namespace accuracy

#endif // LINESPACE_ACCURACY_DETECTORS_HPP
