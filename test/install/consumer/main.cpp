// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// A user's program: exit status 0 if the installed library finds the one line of an image, by the
// detector and by the drop-in.

#include <opencv2/linespace.hpp>

#include <cmath>
#include <cstdio>
#include <vector>

static bool isTheLine(const std::vector<cv::Vec3f>& lines)
{
    std::printf("%d lines\n", (int)lines.size());
    return lines.size() == 1 && std::abs(lines[0][0] - 40) < 0.6 &&
           std::abs(lines[0][1] - CV_PI / 2) < 0.01;
}

int main()
{
    cv::Mat edges = cv::Mat::zeros(100, 160, CV_8UC1);
    edges.row(40) = 255;

    std::vector<cv::Vec3f> lines;
    cv::linespace::LineSpaceDetector::create(100)->detect(edges, lines);
    const bool detected = isTheLine(lines);

    cv::linespace::HoughLines(edges, lines, 1, CV_PI / 180, 100);
    return detected && isTheLine(lines) ? 0 : 1;
}
