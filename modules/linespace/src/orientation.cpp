// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "orientation.hpp"

#include <cmath>

namespace cv {
namespace linespace {

namespace {

//! round(2^14 cos((2 b + 1) pi / 32)), the centres of the bins; their sines are those of bin 7 - b.
const int CENTRE_COSINE[DIRECTION_BINS] = {16305,  15679,  14449,  12665, 10394, 7723,
                                           4756,   1606,   -1606,  -4756, -7723, -10394,
                                           -12665, -14449, -15679, -16305};

//! round(2^15 cos(b pi / 16)), the lower ends of the bins; their sines are those of 8 - b.
const int END_COSINE[DIRECTION_BINS] = {32768,  32138,  30274,  27246, 23170,  18205,
                                        12540,  6393,   0,      -6393, -12540, -18205,
                                        -23170, -27246, -30274, -32138};

//! sin(x) = cos(pi / 2 - x), and cos(-x) = cos(x).
int centreSine(int bin)
{
    return CENTRE_COSINE[bin < 8 ? 7 - bin : bin - 8];
}
int endSine(int bin)
{
    return END_COSINE[std::abs(8 - bin)];
}

//! A finite gradient as 16-bit integers of the same direction.
void quantise(float x, float y, int& gx, int& gy)
{
    const float larger = std::max(std::abs(x), std::abs(y));
    if (larger == 0)
    {
        gx = gy = 0;
        return;
    }
    int exponent;
    std::frexp(larger, &exponent); // larger in [2^(exponent - 1), 2^exponent)
    gx = std::min(cvRound(std::ldexp((double)x, 15 - exponent)), 32767);
    gy = std::min(cvRound(std::ldexp((double)y, 15 - exponent)), 32767);
}

void quantise(short x, short y, int& gx, int& gy)
{
    gx = x;
    gy = y;
}

template<class Component>
void writeRowBits(const DirectionRule& rule, const Mat& votes, const Mat& dx, const Mat& dy, int y,
                  Mat& bits)
{
    const uchar* voting = votes.ptr<uchar>(y);
    const Component *rowX = dx.ptr<Component>(y), *rowY = dy.ptr<Component>(y);
    ushort* out = bits.ptr<ushort>(y);
    for (int x = 0; x < votes.cols; ++x)
    {
        if (!voting[x])
            continue;
        int gx, gy;
        quantise(rowX[x], rowY[x], gx, gy);
        out[x] = rule.bitsOf(gx, gy);
    }
}

//! Zeros, in the memory that the image has if that is as large.
void clear(Size size, int type, Mat& image)
{
    image.create(size, type);
    image.setTo(0);
}

} // namespace

int directionBin(int dx, int dy)
{
    int64 x = dx, y = dy;
    if (y < 0 || (y == 0 && x < 0))
    {
        x = -x;
        y = -y;
    }
    // The last bin whose lower end is not beyond the direction, without branches: which way is as
    // likely as not.
    static_assert((DIRECTION_BINS & (DIRECTION_BINS - 1)) == 0, "halved to the end");
    int bin = 0;
    for (int half = DIRECTION_BINS / 2; half > 0; half /= 2)
        bin += half * (END_COSINE[bin + half] * y - endSine(bin + half) * x >= 0);
    return bin;
}

int endCosine(int bin)
{
    return END_COSINE[bin];
}

int centreCosine(int bin)
{
    return CENTRE_COSINE[bin];
}

int directionBin(const Cell& cell, Chord chord)
{
    const Point p = cell.borderPoint(chord.s), q = cell.borderPoint(chord.e);
    return directionBin(q.x - p.x, q.y - p.y);
}

DirectionRule::DirectionRule(double tolerance)
{
    const double sine = std::sin(tolerance * (CV_PI / 180));
    // The rounded centres may be a little longer than 2^14.
    sineSquared_ = tolerance >= 90 ? (int64)1 << 29 : (int64)cvRound(sine * sine * (1 << 28));
}

ushort DirectionRule::bitsOf(int gx, int gy) const
{
    // |gradient . centre| = |gradient| |centre| |sin(angle between edge and centre)|
    const int64 limit = sineSquared_ * ((int64)gx * gx + (int64)gy * gy);
    ushort bits = 0;
    for (int bin = 0; bin < DIRECTION_BINS; ++bin)
    {
        const int64 product = (int64)gx * CENTRE_COSINE[bin] + (int64)gy * centreSine(bin);
        if (product * product <= limit)
            bits |= (ushort)(1 << bin);
    }
    return bits;
}

void directionBits(const Mat& votes, const Mat& dx, const Mat& dy, double tolerance, Mat& bits)
{
    const DirectionRule rule(tolerance);
    const bool isFloat = dx.type() == CV_32FC1;
    clear(votes.size(), CV_16UC1, bits);
    parallel_for_(Range(0, votes.rows),
                  [&](const Range& range)
                  {
                      for (int y = range.start; y < range.end; ++y)
                          if (isFloat)
                              writeRowBits<float>(rule, votes, dx, dy, y, bits);
                          else
                              writeRowBits<short>(rule, votes, dx, dy, y, bits);
                  });
}

void estimateGradients(const Mat& votes, EstimatedGradients& gradients)
{
    enum
    {
        REACH = 3,
        MARGIN = REACH + 1
    };
    // Of a map with a margin of zeros, where everything near a pixel can be read.
    const Size size(votes.cols + 2 * MARGIN, votes.rows + 2 * MARGIN);
    Mat &edges = gradients.edges, &sobelX = gradients.sobelX, &sobelY = gradients.sobelY;
    clear(size, CV_8UC1, edges);
    clear(size, CV_8SC1, sobelX);
    clear(size, CV_8SC1, sobelY);
    Mat inner = edges(Rect(MARGIN, MARGIN, votes.cols, votes.rows));
    cv::min(votes, Scalar(1), inner);
    for (int y = 1; y + 1 < edges.rows; ++y)
    {
        const uchar *above = edges.ptr<uchar>(y - 1), *at = edges.ptr<uchar>(y),
                    *below = edges.ptr<uchar>(y + 1);
        schar *outX = sobelX.ptr<schar>(y), *outY = sobelY.ptr<schar>(y);
        for (int x = 1; x + 1 < edges.cols; ++x)
        {
            const int l = x - 1, r = x + 1;
            outX[x] = (schar)(above[r] + 2 * at[r] + below[r] - above[l] - 2 * at[l] - below[l]);
            outY[x] =
                (schar)(below[l] + 2 * below[x] + below[r] - above[l] - 2 * above[x] - above[r]);
        }
    }
    Mat &dx = gradients.dx, &dy = gradients.dy;
    clear(votes.size(), CV_32FC1, dx);
    clear(votes.size(), CV_32FC1, dy);
    const auto estimate = [&](int x, int y)
    {
        // The tensor as a vector at twice the angle: (xx - yy, 2 xy).
        int difference = 0, product = 0;
        for (int j = -REACH; j <= REACH; ++j)
        {
            const schar *gx = sobelX.ptr<schar>(y + MARGIN + j) + x + MARGIN,
                        *gy = sobelY.ptr<schar>(y + MARGIN + j) + x + MARGIN;
            for (int i = -REACH; i <= REACH; ++i)
            {
                difference += gx[i] * gx[i] - gy[i] * gy[i];
                product += 2 * gx[i] * gy[i];
            }
        }
        const double a = difference, b = product, length = std::sqrt(a * a + b * b);
        dx.ptr<float>(y)[x] = (float)(a >= 0 ? length + a : b);
        dy.ptr<float>(y)[x] = (float)(a >= 0 ? b : length - a);
    };
    parallel_for_(Range(0, votes.rows),
                  [&](const Range& range)
                  {
                      for (int y = range.start; y < range.end; ++y)
                          for (int x = 0; x < votes.cols; ++x)
                              if (votes.ptr<uchar>(y)[x])
                                  estimate(x, y);
                  });
}

} // namespace linespace
} // namespace cv
