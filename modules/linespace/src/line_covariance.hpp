// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// How well the pixels along a line determine it (doc/algorithm.md, section 5.3).

#ifndef OPENCV_LINESPACE_LINE_COVARIANCE_HPP
#define OPENCV_LINESPACE_LINE_COVARIANCE_HPP

#include "band.hpp"

namespace cv {
namespace linespace {

//! Variances of rho (pixels squared) and theta (radians squared), and their covariance.
struct Covariance
{
    double rho, rhoTheta, theta;

    //! (standard deviation of rho, that of theta, correlation)
    Vec3f deviations() const;
};

//! A line, and how well it is known.
struct FittedLine
{
    Line line;
    Covariance covariance;
};

/** A line's offset along its normal as a function of the column, a + b t with t = i - middle: what
a fit changes, and what is known of it. */
struct Offset
{
    double a, b;
};
struct OffsetCovariance
{
    double aa, ab, bb;
};

//! The line moved along its normal.
Line moved(const Columns& columns, double middle, const Line& line, const Offset& offset);
//! The covariance of (a, b) as that of (rho, theta).
Covariance polarCovariance(const Columns& columns, double middle, const Line& line,
                           const OffsetCovariance& covariance);

//! What one column says about the offset there; zeros: nothing.
struct ColumnScore
{
    double score;       //!< a sum over the column's pixels whose expectation is 0 on the true line
    double sensitivity; //!< how fast the score grows with the offset
};

/** The covariance of the offset at which the scores and their products with t sum up to 0, from
the scores that are left there (the sandwich estimator). Neighbours up to four columns away may be
correlated, as smoothed images' gradients are (Newey and West).
@param columns one after the other, of t = first, first + 1 ...
@return false if they do not determine a line. */
bool offsetCovariance(double first, const std::vector<ColumnScore>& columns,
                      OffsetCovariance& covariance);

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_LINE_COVARIANCE_HPP
