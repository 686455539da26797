// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "gradients.hpp"

#include "backends.hpp"

#include <cmath>
#include <limits>

namespace cv {
namespace linespace {

namespace {

//! A value that is not finite, if there is one. (To cv::checkRange the largest float is none.)
bool findNotFinite(const Mat& values, Point& where)
{
    const float most = std::numeric_limits<float>::max();
    for (int y = 0; y < values.rows; ++y)
    {
        const float* const row = values.ptr<float>(y);
        int wrong = 0; // without a branch, for speed
        for (int x = 0; x < values.cols; ++x)
            wrong |= !(std::abs(row[x]) <= most);
        for (int x = 0; wrong && x < values.cols; ++x)
            if (!(std::abs(row[x]) <= most))
            {
                where = Point(x, y);
                return true;
            }
    }
    return false;
}

void checkFinite(const Mat& values, const char* name)
{
    Point bad;
    if (findNotFinite(values, bad))
        CV_Error_(Error::StsOutOfRange, ("%s at (%d, %d) = %g: must be finite", name, bad.x, bad.y,
                                         values.at<float>(bad)));
}

} // namespace

Gradients Gradients::none()
{
    Gradients result;
    result.isOriented = false;
    return result;
}

Gradients Gradients::of(InputArray dx, InputArray dy)
{
    Gradients result;
    result.isOriented = true;
    result.dxOnDevice = onDevice(dx);
    result.dyOnDevice = onDevice(dy);
    if (!result.dxOnDevice.empty() && !result.dyOnDevice.empty())
        return result;
    result.dxOnDevice.release();
    result.dyOnDevice.release();
    result.dx = dx.getMat();
    result.dy = dy.getMat();
    return result;
}

Gradients Gradients::onHost() const
{
    Gradients result = *this;
    if (!areOnDevice())
        return result;
    result.dx = dxOnDevice.getMat(ACCESS_READ);
    result.dy = dyOnDevice.getMat(ACCESS_READ);
    result.dxOnDevice.release();
    result.dyOnDevice.release();
    return result;
}

void Gradients::check(Size size) const
{
    const struct
    {
        const _InputArray values;
        const char* name;
    } both[2] = {{areOnDevice() ? _InputArray(dxOnDevice) : _InputArray(dx), "dx"},
                 {areOnDevice() ? _InputArray(dyOnDevice) : _InputArray(dy), "dy"}};
    if (!areOnDevice() && dx.empty() && dy.empty())
        return;
    for (const auto& one : both)
    {
        if (one.values.empty())
            CV_Error_(Error::StsBadSize,
                      ("%s is empty: must not be, unless both dx and dy are", one.name));
        if ((one.values.type() != CV_16SC1 && one.values.type() != CV_32FC1) ||
            one.values.dims() > 2)
            CV_Error_(Error::StsUnsupportedFormat,
                      ("%s has %d dimensions and type %s: must be CV_16SC1 or CV_32FC1 with two "
                       "dimensions",
                       one.name, one.values.dims(), typeToString(one.values.type()).c_str()));
        if (one.values.size() != size)
            CV_Error_(Error::StsUnmatchedSizes,
                      ("%s has %d x %d pixels: must have the %d x %d of edges", one.name,
                       one.values.cols(), one.values.rows(), size.width, size.height));
    }
    if (both[0].values.type() != both[1].values.type())
        CV_Error_(Error::StsUnmatchedFormats, ("dx has type %s and dy %s: must be the same",
                                               typeToString(both[0].values.type()).c_str(),
                                               typeToString(both[1].values.type()).c_str()));
    if (areOnDevice() || dx.type() != CV_32FC1)
        return;
    checkFinite(dx, "dx");
    checkFinite(dy, "dy");
}

void Gradients::findBits(const Mat& votes, double tolerance, EstimatedGradients& estimated,
                         Mat& bits) const
{
    CV_DbgAssert(!areOnDevice());
    if (!dx.empty())
        return directionBits(votes, dx, dy, tolerance, bits);
    estimateGradients(votes, estimated);
    directionBits(votes, estimated.dx, estimated.dy, tolerance, bits);
}

} // namespace linespace
} // namespace cv
