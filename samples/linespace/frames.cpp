// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "frames.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <vector>

#include "inputs.hpp"
#include "silence.hpp"

#include "opencv2/imgcodecs.hpp"

namespace program {

namespace {

std::ifstream openFile(const std::string& path)
{
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (file.peek() == std::ifstream::traits_type::eof())
        throw InputError(errno != 0 ? std::string("cannot be read: ") + std::strerror(errno)
                                    : "the file is empty");
    return file;
}

std::vector<std::uint8_t> readBytes(const std::string& path)
{
    std::ifstream file = openFile(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

// OpenCV decodes what is there of a JPEG file and fills the rest with grey. The file is whole if
// its markers lead to the end-of-image marker (ISO/IEC 10918-1, annex B).
bool isBrokenOffJpeg(const std::vector<std::uint8_t>& bytes)
{
    const std::size_t size = bytes.size();
    if (size < 2 || bytes[0] != 0xFF || bytes[1] != 0xD8)
        return false;
    std::size_t at = 2;
    while (at + 1 < size)
    {
        const std::uint8_t marker = bytes[at + 1];
        if (bytes[at] != 0xFF || marker == 0xFF || marker == 0x00 || marker == 0x01 ||
            (marker >= 0xD0 && marker <= 0xD7))
            ++at; // inside a scan: compressed data, restart markers, fill bytes
        else if (marker == 0xD9)
            return false;
        else if (at + 3 < size)
            at += 2 + (bytes[at + 2] << 8 | bytes[at + 3]); // a segment: skip what it holds
        else
            break;
    }
    return true;
}

} // namespace

cv::Mat readImage(const std::string& path)
{
    const std::vector<std::uint8_t> bytes = readBytes(path);
    if (isBrokenOffJpeg(bytes))
        throw InputError("the JPEG file is truncated");
    const SilentStderr silence;
    // The orientation that a camera stored is obeyed by all flags but IMREAD_UNCHANGED.
    cv::Mat image = cv::imdecode(bytes, cv::IMREAD_ANYDEPTH | cv::IMREAD_ANYCOLOR);
    if (image.empty())
        throw InputError("not an image that can be read, damaged or truncated");
    return image;
}

bool isImageFile(const std::string& path)
{
    // By content, except that a damaged image shall not be tried as a video.
    return isImageName(path) || cv::haveImageReader(path);
}

FrameReader::FrameReader(const std::string& path)
{
    if (isImageFile(path))
    {
        image_ = readImage(path);
        return;
    }
    openFile(path); // gives better reasons than a video reader
    const SilentStderr silence;
    if (!video_.open(path))
        throw InputError("neither an image nor a video that can be read, or damaged");
    const double count = video_.get(cv::CAP_PROP_FRAME_COUNT);
    frameCount_ = count > 0 && count < 1e9 ? cvRound(count) : 0;
    framesPerSecond_ = video_.get(cv::CAP_PROP_FPS);
}

bool FrameReader::next(cv::Mat& frame)
{
    if (!isVideo())
    {
        frame = image_;
        image_ = cv::Mat();
        return !frame.empty();
    }
    const SilentStderr silence;
    if (!video_.read(frame) || frame.empty())
    {
        requireWholeVideo();
        return false;
    }
    ++framesRead_;
    return true;
}

// Some videos have fewer frames than they claim because frames that repeat were left out; they
// still reach their claimed end in time.
void FrameReader::requireWholeVideo()
{
    const double seconds = video_.get(cv::CAP_PROP_POS_MSEC) / 1000;
    const double reached = std::max<double>(framesRead_, seconds * framesPerSecond_ + 1);
    if (framesRead_ == 0)
        throw InputError("the video has no frame that can be read");
    if (reached < 0.9 * frameCount_)
        throw InputError("the video is truncated: it ends after " + std::to_string(framesRead_) +
                         " of " + std::to_string(frameCount_) + " frames");
}

} // namespace program
