// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// A small image from the fuzzer's bytes.

#ifndef LINESPACE_FUZZ_IMAGE_HPP
#define LINESPACE_FUZZ_IMAGE_HPP

#include <fuzzer/FuzzedDataProvider.h>

#include <opencv2/core.hpp>

#include <stdexcept>

//! Up to 40 x 40 pixels, sometimes a part of a larger image; what the bytes do not fill is 0.
inline cv::Mat fuzzImage(FuzzedDataProvider& data)
{
    const int width = data.ConsumeIntegralInRange(1, 40),
              height = data.ConsumeIntegralInRange(1, 40);
    const int margin = data.ConsumeIntegralInRange(0, 3);
    cv::Mat whole = cv::Mat::zeros(height + 2 * margin, width + 2 * margin, CV_8UC1);
    cv::Mat image = whole(cv::Rect(margin, margin, width, height));
    const bool grey = data.ConsumeBool();
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width && data.remaining_bytes() > 0; ++x)
            image.at<uchar>(y, x) = grey ? data.ConsumeIntegral<uchar>() : data.ConsumeBool();
    return image;
}

//! One component of a gradient; empty once in a while, and of any bytes: a float may be no number.
inline cv::Mat fuzzGradient(FuzzedDataProvider& data, cv::Size size, int type)
{
    if (data.ConsumeIntegralInRange(0, 7) == 0)
        return cv::Mat();
    cv::Mat values = cv::Mat::zeros(size, type);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width && data.remaining_bytes() > 0; ++x)
        {
            if (type == CV_16SC1)
                values.at<short>(y, x) = data.ConsumeIntegral<short>();
            else
                data.ConsumeData(&values.at<float>(y, x), sizeof(float));
        }
    return values;
}

//! A difference between what must be the same; not a cv::Exception, so that no harness takes it for
//! one.
inline void require(bool condition, const char* what)
{
    if (!condition)
        throw std::logic_error(what);
}

#endif // LINESPACE_FUZZ_IMAGE_HPP
