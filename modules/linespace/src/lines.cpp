// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// What users do with the lines they got: end points and drawing.

#include "line_geometry.hpp"

#include <opencv2/imgproc.hpp>

#include <cmath>
#include <limits>

namespace cv {
namespace linespace {

namespace {

//! The lines as rows of (rho, theta); throws if the array is not a list of lines.
std::vector<Vec2f> polarLines(InputArray lines)
{
    std::vector<Vec2f> result;
    if (lines.empty())
        return result;
    const int type = lines.type();
    // In OpenCV 5 a std::vector is an array of one dimension, with one row.
    if ((type != CV_32FC2 && type != CV_32FC3) || lines.dims() > 2)
        CV_Error_(Error::StsUnsupportedFormat,
                  ("lines has %d dimensions and type %s: must be N x 1 or 1 x N, CV_32FC2 or "
                   "CV_32FC3",
                   lines.dims(), typeToString(type).c_str()));
    const Mat array = lines.getMat();
    if (array.cols != 1 && array.rows != 1)
        CV_Error_(
            Error::StsUnsupportedFormat,
            ("lines has %d x %d elements of type %s: must be N x 1 or 1 x N, CV_32FC2 or CV_32FC3",
             array.rows, array.cols, typeToString(type).c_str()));
    result.resize(array.total());
    for (int i = 0; i < (int)result.size(); ++i)
    {
        const float* line =
            array.cols == 1 ? array.ptr<float>(i) : array.ptr<float>(0) + i * array.channels();
        result[i] = Vec2f(line[0], line[1]);
    }
    return result;
}

} // namespace

void lineEndPoints(InputArray lines, Size imageSize, OutputArray endPoints)
{
    if (imageSize.width < 1 || imageSize.height < 1)
        CV_Error_(Error::StsOutOfRange, ("imageSize = %d x %d: must be at least 1 x 1",
                                         imageSize.width, imageSize.height));
    if (endPoints.fixedType() && endPoints.type() != CV_32FC4)
        CV_Error_(Error::StsUnsupportedFormat, ("endPoints has type %s: must be CV_32FC4",
                                                typeToString(endPoints.type()).c_str()));
    const std::vector<Vec2f> polar = polarLines(lines);
    if (polar.empty())
    {
        endPoints.release();
        return;
    }
    Mat points((int)polar.size(), 1, CV_32FC4);
    for (int i = 0; i < points.rows; ++i)
    {
        const float nan = std::numeric_limits<float>::quiet_NaN();
        const double theta = polar[i][1];
        Ends ends;
        points.at<Vec4f>(i) =
            clipLine(std::cos(theta), std::sin(theta), polar[i][0], imageSize, ends)
                ? Vec4f((float)ends.first.x, (float)ends.first.y, (float)ends.second.x,
                        (float)ends.second.y)
                : Vec4f(nan, nan, nan, nan);
    }
    points.copyTo(endPoints);
}

void drawLines(InputOutputArray image, InputArray lines, const Scalar& color, int thickness)
{
    const int type = image.type();
    if (image.empty() || image.dims() > 2 ||
        (type != CV_8UC1 && type != CV_8UC3 && type != CV_8UC4))
        CV_Error_(Error::StsUnsupportedFormat,
                  ("image has %d dimensions and type %s: must be CV_8UC1, CV_8UC3 or CV_8UC4 with "
                   "two dimensions, and not empty",
                   image.dims(), typeToString(type).c_str()));
    if (thickness < 1 || thickness > 32767)
        CV_Error_(Error::StsOutOfRange, ("thickness = %d: must be 1 to 32767 pixels", thickness));
    Mat ends;
    lineEndPoints(lines, image.size(), ends);
    const int shift = 4; // fractional bits of cv::line's coordinates
    for (int i = 0; i < ends.rows; ++i)
    {
        const Vec4f p = ends.at<Vec4f>(i);
        if (cvIsNaN(p[0]))
            continue;
        const double scale = 1 << shift;
        line(image, Point(cvRound(p[0] * scale), cvRound(p[1] * scale)),
             Point(cvRound(p[2] * scale), cvRound(p[3] * scale)), color, thickness, LINE_AA, shift);
    }
}

} // namespace linespace
} // namespace cv
