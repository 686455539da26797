// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// From a picture to its edge map and from the edge map to its lines, as the options say.

#ifndef LINESPACE_SAMPLES_FINDER_HPP
#define LINESPACE_SAMPLES_FINDER_HPP

#include <string>
#include <vector>

#include "options.hpp"

#include "opencv2/linespace.hpp"

namespace program {

//! A picture ready to be searched and drawn on.
struct Picture
{
    cv::Mat colors; //!< CV_8UC3
    cv::Mat edges;  //!< CV_8UC1; pixels outside the mask are already 0, for cv::HoughLines
    cv::Mat mask;   //!< CV_8UC1 of that size, or empty
    cv::Mat dx, dy; //!< CV_16SC1, the gradient; only for oriented voting and if the input has one
};

//! What was found in one picture.
struct Found
{
    std::string input;  //!< as the user named it
    int frame = -1;     //!< of a video, from 0; -1 for an image
    double seconds = 0; //!< time of the frame in its video
    cv::Size size;
    int edgePixels = 0;
    double milliseconds = 0; //!< of the search alone; the first of a size includes its preparation
    std::string backend;     //!< the one that ran
    std::vector<cv::Vec3f> lines;
    std::vector<cv::Vec4f> endPoints;
};

class LineFinder
{
public:
    //! Throws UsageError if the mask cannot be read or the back end is not there.
    explicit LineFinder(const Options& options);

    //! Throws InputError if the mask does not fit.
    Picture prepare(const cv::Mat& frame) const;

    Found find(const Picture& picture);

    //! The table of votes, B x B CV_32SC1.
    cv::Mat lineSpace(const Picture& picture);

private:
    void requireBackend();

    Options options_;
    cv::Mat mask_;
    cv::Ptr<cv::linespace::LineSpaceDetector> detector_;
};

} // namespace program

#endif // LINESPACE_SAMPLES_FINDER_HPP
