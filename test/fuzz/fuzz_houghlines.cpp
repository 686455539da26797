// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The drop-in with any arguments: what it reports holds what its documentation promises, and it
// throws nothing but cv::Exception.

#include "fuzz_image.hpp"

#include <opencv2/linespace.hpp>

#include <cmath>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size)
{
    FuzzedDataProvider data(bytes, size);
    const bool wild = data.ConsumeBool();
    const double rho = wild ? data.ConsumeFloatingPoint<double>()
                            : data.ConsumeFloatingPointInRange<double>(0.25, 20);
    const double theta = wild ? data.ConsumeFloatingPoint<double>()
                              : data.ConsumeFloatingPointInRange<double>(0.01, 1);
    const int threshold = data.ConsumeIntegralInRange(-5, 60);
    const double from = wild ? data.ConsumeFloatingPoint<double>()
                             : data.ConsumeFloatingPointInRange<double>(-7, 7);
    const double to = wild ? data.ConsumeFloatingPoint<double>()
                           : from + data.ConsumeFloatingPointInRange<double>(0, 7);
    const bool weighted = data.ConsumeBool();
    const cv::Mat image = fuzzImage(data);
    // A fine grid is a legal wish, but one that takes longer than a fuzzer waits.
    if (rho > 0 && theta > 0 && (80 / rho) * (7 / theta) > 1e6)
        return 0;
    std::vector<cv::Vec3f> lines;
    try
    {
        cv::linespace::HoughLines(image, lines, rho, theta, threshold, 0, 0, from, to, weighted);
    }
    catch (const cv::Exception&)
    {
        require(wild, "legal arguments are refused");
        return 0;
    }
    for (size_t i = 0; i < lines.size(); ++i)
    {
        require(lines[i][2] > threshold && lines[i][2] > 0, "votes");
        require(i == 0 || lines[i - 1][2] >= lines[i][2], "order");
        require(!std::isnan(lines[i][0]) && !std::isnan(lines[i][1]), "not a number");
        if (!wild)
            require(lines[i][1] >= (float)from - 1e-6f && lines[i][1] <= (float)to + 1e-6f,
                    "theta in its interval");
    }
    return 0;
}
