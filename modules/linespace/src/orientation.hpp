// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Which directions an edge pixel votes for (doc/algorithm.md, section 6), by one integer rule for
// all back ends.

#ifndef OPENCV_LINESPACE_ORIENTATION_HPP
#define OPENCV_LINESPACE_ORIENTATION_HPP

#include "plan.hpp"

namespace cv {
namespace linespace {

enum
{
    DIRECTION_BINS = 16 //!< of pi / 16 each, over [0, pi); bit b of a pixel admits bin b
};

/** The bin that a direction falls into: floor(16 angle / pi) for its angle in [0, pi), x to the
right and y downwards. (dx, dy) is not (0, 0); each is less than 2^31 in size. */
int directionBin(int dx, int dy);

//! round(2^15 cos(b pi / 16)), by which the lower end of bin b is known.
int endCosine(int bin);

//! round(2^14 cos((2 b + 1) pi / 32)), of the centre of bin b.
int centreCosine(int bin);

//! The bin of a chord, and its bit.
int directionBin(const Cell& cell, Chord chord);
inline ushort directionBit(const Cell& cell, Chord chord)
{
    return (ushort)(1 << directionBin(cell, chord));
}

/** The bins that an edge pixel with the gradient (gx, gy), each -32768 to 32767, votes for: those
whose centres make an angle of at most `tolerance` degrees, in (0, 90], with the edge, which is
orthogonal to the gradient. A zero gradient votes for all. */
class DirectionRule
{
public:
    explicit DirectionRule(double tolerance);
    ushort bitsOf(int gx, int gy) const;
    int64 sineSquared() const { return sineSquared_; }

private:
    int64 sineSquared_; //!< of the tolerance, times 2^28; large enough for all at 90 degrees
};

/** The bits of every pixel: CV_16UC1, 0 where the pixel does not vote.
@param votes CV_8UC1
@param dx,dy of the same size, both CV_16SC1 or both CV_32FC1. Floating-point gradients are first
scaled by the power of two that takes the larger component into [2^14, 2^15) and rounded to the
nearest integers, of two the even one. They are finite. */
void directionBits(const Mat& votes, const Mat& dx, const Mat& dy, double tolerance, Mat& bits);

//! dx and dy, and what they are estimated by; 11 bytes per pixel that are kept for the next image.
struct EstimatedGradients
{
    Mat dx, dy;
    Mat edges, sobelX, sobelY;
};

/** Gradients of an edge map that has none of its own: the dominant direction of its structure
tensor, as CV_32FC1 vectors whose length has no meaning; 0 where no direction dominates. The tensor
is the sum over 7 x 7 pixels of the products of the map's 3 x 3 Sobel derivatives, in integers. */
void estimateGradients(const Mat& votes, EstimatedGradients& gradients);

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_ORIENTATION_HPP
