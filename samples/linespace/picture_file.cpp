// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "picture_file.hpp"

#include <filesystem>

#include "frames.hpp"
#include "inputs.hpp"
#include "naming.hpp"
#include "silence.hpp"

#include "opencv2/imgcodecs.hpp"

namespace program {

PictureFile::PictureFile(const std::string& path, double framesPerSecond)
    : path_(path), framesPerSecond_(framesPerSecond > 0 ? framesPerSecond : 25)
{
}

void PictureFile::write(const cv::Mat& picture, int frame)
{
    if (path_.empty())
        return;
    if (isVideoName(path_))
        writeVideo(picture);
    else
        writeImage(picture, frame);
}

void PictureFile::writeImage(const cv::Mat& picture, int frame) const
{
    const std::string path = numbered(path_, frame);
    bool written = false;
    try
    {
        const SilentStderr silence;
        written = cv::imwrite(path, picture);
    }
    catch (const cv::Exception&)
    {
        // an extension without a writer in this OpenCV, or a full disk
    }
    if (!written)
        throw InputError(path + " cannot be written");
}

void PictureFile::writeVideo(const cv::Mat& picture)
{
    const SilentStderr silence;
    if (!video_.isOpened())
    {
        const bool avi = std::filesystem::path(path_).extension() == ".avi";
        const int codec = avi ? cv::VideoWriter::fourcc('M', 'J', 'P', 'G')
                              : cv::VideoWriter::fourcc('m', 'p', '4', 'v');
        if (!video_.open(path_, codec, framesPerSecond_, picture.size()))
            throw InputError(path_ + " cannot be written");
    }
    video_.write(picture);
}

} // namespace program
