// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "draw.hpp"

#include <algorithm>
#include <cmath>

#include "opencv2/imgproc.hpp"
#include "opencv2/linespace.hpp"

namespace program {

const cv::Scalar ourColor(40, 60, 255), theirColor(255, 160, 0);

namespace {

cv::Mat withCaption(const cv::Mat& picture, const std::string& caption, int barHeight)
{
    const int font = cv::FONT_HERSHEY_SIMPLEX;
    int baseline = 0;
    const cv::Size unit = cv::getTextSize(caption, font, 1, 1, &baseline);
    const double scale = std::min(0.9 * picture.cols / unit.width, 0.5 * barHeight / unit.height);
    cv::Mat result;
    cv::copyMakeBorder(picture, result, 0, barHeight, 0, 0, cv::BORDER_CONSTANT,
                       cv::Scalar::all(255));
    const cv::Point at(cvRound(0.05 * picture.cols),
                       picture.rows + cvRound((barHeight + scale * unit.height) / 2));
    cv::putText(result, caption, at, font, scale, cv::Scalar::all(0), 1, cv::LINE_AA);
    return result;
}

} // namespace

cv::Mat drawOver(const cv::Mat& colors, const std::vector<cv::Vec3f>& lines,
                 const cv::Scalar& color)
{
    cv::Mat result = colors.clone();
    const int thickness = std::max(2, cvRound(std::hypot(colors.cols, colors.rows) / 450));
    // The weakest first, so that the strongest end on top.
    for (std::size_t i = lines.size(); i-- > 0;)
    {
        const std::vector<cv::Vec3f> line = {lines[i]};
        cv::linespace::drawLines(result, line, cv::Scalar::all(0), thickness + 2);
        cv::linespace::drawLines(result, line, color, thickness);
    }
    return result;
}

cv::Mat sideBySide(const cv::Mat& left, const std::string& leftCaption, const cv::Mat& right,
                   const std::string& rightCaption)
{
    // Room for a caption that can be read.
    const int factor = std::max(1, (360 + left.cols - 1) / left.cols);
    const int gap = 8, barHeight = std::max(30, left.cols * factor / 20);
    cv::Mat panels[2] = {left, right}, separator;
    const std::string captions[2] = {leftCaption, rightCaption};
    for (int i = 0; i < 2; ++i)
    {
        if (factor > 1)
            cv::resize(panels[i], panels[i], cv::Size(), factor, factor, cv::INTER_NEAREST);
        panels[i] = withCaption(panels[i], captions[i], barHeight);
    }
    separator.create(panels[0].rows, gap, CV_8UC3);
    separator.setTo(cv::Scalar::all(255));
    const std::vector<cv::Mat> parts = {panels[0], separator, panels[1]};
    cv::Mat result;
    cv::hconcat(parts, result);
    return result;
}

cv::Mat lineSpacePicture(const cv::Mat& table)
{
    // Large tables are reduced by the largest entry of each square, which keeps the peaks; small
    // ones are enlarged.
    const int wanted = 1200, size = table.rows;
    const int step = (size + wanted - 1) / wanted, factor = std::max(1, wanted / 2 / size);
    cv::Mat reduced((size + step - 1) / step, (size + step - 1) / step, CV_32FC1, cv::Scalar(0));
    for (int s = 0; s < size; ++s)
    {
        const int* votes = table.ptr<int>(s);
        float* row = reduced.ptr<float>(s / step);
        for (int e = 0; e < size; ++e)
            row[e / step] = std::max(row[e / step], static_cast<float>(votes[e]));
    }
    double largest = 0;
    cv::minMaxLoc(reduced, nullptr, &largest);
    if (largest > 0)
        cv::sqrt(reduced / largest, reduced); // most chords have few votes: lift the dark tones
    cv::Mat picture;
    reduced.convertTo(picture, CV_8U, 255);
    if (factor > 1)
        cv::resize(picture, picture, cv::Size(), factor, factor, cv::INTER_NEAREST);
    return picture;
}

} // namespace program
