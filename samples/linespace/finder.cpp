// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "finder.hpp"

#include "frames.hpp"
#include "text.hpp"

#include "opencv2/core/utility.hpp"
#include "opencv2/imgproc.hpp"

namespace program {

namespace {

double radians(double degrees)
{
    return degrees * CV_PI / 180;
}

//! 255 where any channel is not black.
cv::Mat notBlack(const cv::Mat& image)
{
    cv::Mat result = cv::Mat::zeros(image.size(), CV_8UC1), channel;
    for (int i = 0; i < image.channels(); ++i)
    {
        cv::extractChannel(image, channel, i);
        result |= channel != 0;
    }
    return result;
}

cv::Mat toColors(const cv::Mat& image)
{
    cv::Mat bytes = image, colors;
    if (image.depth() == CV_16U)
        image.convertTo(bytes, CV_8U, 1.0 / 257);
    else if (image.depth() != CV_8U)
        cv::normalize(image, bytes, 0, 255, cv::NORM_MINMAX, CV_8U);
    if (bytes.channels() == 3)
        return bytes;
    cv::cvtColor(bytes, colors, cv::COLOR_GRAY2BGR);
    return colors;
}

std::string sizeText(cv::Size size)
{
    return std::to_string(size.width) + " x " + std::to_string(size.height);
}

} // namespace

LineFinder::LineFinder(const Options& options)
    : options_(options),
      detector_(cv::linespace::LineSpaceDetector::create(options.threshold, options.maxLines,
                                                         methodOf(options), options.cellSize,
                                                         backendOf(options)))
{
    detector_->setAngleRange(radians(options.minAngle), radians(options.maxAngle));
    detector_->setSelection(selectionOf(options));
    detector_->setSuppressionDistance(options.minDistance);
    requireBackend();
    if (options.mask.empty())
        return;
    try
    {
        mask_ = notBlack(readImage(options.mask));
    }
    catch (const InputError& error)
    {
        throw UsageError("--mask " + options.mask + ": " + error.what());
    }
}

// Whether a back end is there does not depend on the input: say it once, before any work.
void LineFinder::requireBackend()
{
    try
    {
        std::vector<cv::Vec3f> lines;
        detector_->detect(cv::Mat::zeros(8, 8, CV_8UC1), lines);
    }
    catch (const cv::Exception& error)
    {
        throw UsageError("--backend " + options_.backend + ": " + reasonOf(error));
    }
}

Picture LineFinder::prepare(const cv::Mat& frame) const
{
    if (!mask_.empty() && mask_.size() != frame.size())
        throw InputError("its size " + sizeText(frame.size()) + " differs from the mask's " +
                         sizeText(mask_.size()));
    Picture picture;
    picture.colors = toColors(frame);
    cv::Mat mask = mask_;
    if (!options_.resize.empty())
    {
        const bool smaller = options_.resize.area() < frame.size().area();
        cv::resize(picture.colors, picture.colors, options_.resize, 0, 0,
                   smaller ? cv::INTER_AREA : cv::INTER_LINEAR);
        if (!mask.empty())
            cv::resize(mask_, mask, options_.resize, 0, 0, cv::INTER_NEAREST);
    }

    if (options_.edgeMap)
        picture.edges = notBlack(frame);
    else
    {
        cv::Mat gray;
        cv::cvtColor(picture.colors, gray, cv::COLOR_BGR2GRAY);
        if (options_.blur > 0)
            cv::GaussianBlur(gray, gray, cv::Size(), options_.blur);
        cv::Canny(gray, picture.edges, options_.cannyLow, options_.cannyHigh);
        if (options_.oriented)
        {
            cv::Sobel(gray, picture.dx, CV_16S, 1, 0);
            cv::Sobel(gray, picture.dy, CV_16S, 0, 1);
        }
    }
    if (!mask.empty())
        picture.edges &= mask;
    picture.mask = mask;
    return picture;
}

Found LineFinder::find(const Picture& picture)
{
    Found found;
    detector_->setMask(picture.mask); // the statistical rule asks for the density inside of it
    cv::TickMeter time;
    time.start();
    if (options_.oriented)
        detector_->detect(picture.edges, picture.dx, picture.dy, found.lines);
    else
        detector_->detect(picture.edges, found.lines);
    time.stop();
    cv::linespace::lineEndPoints(found.lines, picture.edges.size(), found.endPoints);
    found.size = picture.edges.size();
    found.edgePixels = cv::countNonZero(picture.edges);
    found.milliseconds = time.getTimeMilli();
    found.backend = backendName(detector_->getActiveBackend());
    return found;
}

cv::Mat LineFinder::lineSpace(const Picture& picture)
{
    cv::Mat table;
    detector_->setMask(picture.mask);
    detector_->compute(picture.edges, table);
    return table;
}

} // namespace program
