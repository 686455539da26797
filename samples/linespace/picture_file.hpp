// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Writes the pictures of one input: an image, a video, or numbered images of the frames of a video.

#ifndef LINESPACE_SAMPLES_PICTURE_FILE_HPP
#define LINESPACE_SAMPLES_PICTURE_FILE_HPP

#include <string>

#include "opencv2/videoio.hpp"

namespace program {

class PictureFile
{
public:
    //! path: empty for no file; its extension says what is written.
    explicit PictureFile(const std::string& path, double framesPerSecond = 0);

    //! frame: -1 for an image. All pictures of a video have one size. Throws InputError.
    void write(const cv::Mat& picture, int frame);

private:
    void writeImage(const cv::Mat& picture, int frame) const;
    void writeVideo(const cv::Mat& picture);

    std::string path_;
    double framesPerSecond_;
    cv::VideoWriter video_;
};

} // namespace program

#endif // LINESPACE_SAMPLES_PICTURE_FILE_HPP
