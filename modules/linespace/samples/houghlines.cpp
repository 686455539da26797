// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// From cv::HoughLines to the Line Space by changing a namespace: nothing else in this program
// depends on which of the two finds the lines. Compile with -DUSE_OPENCV_HOUGH to see OpenCV's own.

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/linespace.hpp>

#ifdef USE_OPENCV_HOUGH
namespace hough = cv;
#else
namespace hough = cv::linespace;
#endif

static void drawStandardLine(cv::Mat& image, float rho, float theta)
{
    const double far = image.cols + image.rows;
    const cv::Point2d normal(std::cos(theta), std::sin(theta)), along(-normal.y, normal.x);
    const cv::Point2d foot = rho * normal;
    cv::line(image, foot - far * along, foot + far * along, cv::Scalar(0, 0, 255), 2, cv::LINE_AA);
}

int main(int argc, char** argv)
{
    if (argc != 3 && argc != 4)
    {
        std::cerr << "usage: houghlines INPUT OUTPUT [THRESHOLD]\n"
                     "Draws the lines with more than THRESHOLD (default 150) edge pixels.\n";
        return 2;
    }
    const cv::Mat image = cv::imread(argv[1], cv::IMREAD_GRAYSCALE);
    if (image.empty())
    {
        std::cerr << "houghlines: " << argv[1] << " cannot be read\n";
        return 1;
    }
    const int threshold = argc == 4 ? std::atoi(argv[3]) : 150;

    cv::Mat edges;
    cv::Canny(image, edges, 50, 200);
    std::vector<cv::Vec3f> lines; // rho, theta, votes
    hough::HoughLines(edges, lines, 1, CV_PI / 180, threshold);

    cv::Mat drawn;
    cv::cvtColor(image, drawn, cv::COLOR_GRAY2BGR);
    for (const cv::Vec3f& line : lines)
        drawStandardLine(drawn, line[0], line[1]);
    std::cout << lines.size() << " lines\n";
    for (std::size_t i = 0; i < lines.size() && i < 10; ++i)
        std::cout << "rho " << lines[i][0] << ", theta " << lines[i][1] << ", " << lines[i][2]
                  << " votes\n";
    if (!cv::imwrite(argv[2], drawn))
    {
        std::cerr << "houghlines: " << argv[2] << " cannot be written\n";
        return 1;
    }
    return 0;
}
