// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The pictures of one input: one for an image, many for a video.

#ifndef LINESPACE_SAMPLES_FRAMES_HPP
#define LINESPACE_SAMPLES_FRAMES_HPP

#include <stdexcept>
#include <string>

#include "opencv2/videoio.hpp"

namespace program {

//! One input cannot be used; what() is the reason, for a person.
struct InputError : std::runtime_error
{
    using std::runtime_error::runtime_error;
};

class FrameReader
{
public:
    //! Throws InputError if there is neither an image nor a video.
    explicit FrameReader(const std::string& path);

    //! Gives the next picture as it is stored; false after the last one. Throws InputError where a
    //! file breaks off.
    bool next(cv::Mat& frame);

    bool isVideo() const { return video_.isOpened(); }
    int frameCount() const { return frameCount_; } //!< as the file claims; 0: it does not tell
    double framesPerSecond() const { return framesPerSecond_; }

private:
    void requireWholeVideo();

    cv::Mat image_;
    cv::VideoCapture video_;
    int frameCount_ = 1;
    int framesRead_ = 0;
    double framesPerSecond_ = 0;
};

//! Whether a file is read as an image; else it is tried as a video.
bool isImageFile(const std::string& path);

//! Reads one image as it is stored, or throws InputError.
cv::Mat readImage(const std::string& path);

} // namespace program

#endif // LINESPACE_SAMPLES_FRAMES_HPP
