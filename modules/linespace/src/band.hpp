// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The pixels along a line of any position, not only of chords (doc/algorithm.md, section 5).

#ifndef OPENCV_LINESPACE_BAND_HPP
#define OPENCV_LINESPACE_BAND_HPP

#include "line_geometry.hpp"
#include "stages.hpp"

#include <cmath>

namespace cv {
namespace linespace {

/** The columns of an image that a line passes, or its rows if it is steeper than a diagonal: steps
along the major axis. */
struct Columns
{
    bool xMajor;
    int length, limit;        //!< pixels of the image along the major and along the minor axis
    double major, minor, rho; //!< i * major + k * minor = rho on the line, |minor| >= sqrt(1/2)

    Columns(Size image, const Line& line) : rho(line.rho)
    {
        const double cosine = std::cos(line.theta), sine = std::sin(line.theta);
        xMajor = std::abs(sine) >= std::abs(cosine);
        major = xMajor ? cosine : sine;
        minor = xMajor ? sine : cosine;
        length = xMajor ? image.width : image.height;
        limit = xMajor ? image.height : image.width;
    }
    //! Where the line passes column i.
    double centre(int i) const { return (rho - i * major) / minor; }
    //! Signed distance of pixel k of column i from the line.
    double distance(int i, int k) const { return i * major + k * minor - rho; }
    Point pixel(int i, int k) const { return xMajor ? Point(i, k) : Point(k, i); }

    //! Calls visit(i, k) for the pixels of the image whose centre is within a distance of the line.
    template<class Visit>
    void forEachWithin(double reach, Visit visit) const
    {
        const double along = reach / std::abs(minor);
        for (int i = 0; i < length; ++i)
        {
            const double middle = centre(i);
            if (!(middle > -along - 1 && middle < limit + along))
                continue;
            const int first = std::max(0, cvCeil(middle - along)),
                      last = std::min(limit - 1, cvFloor(middle + along));
            for (int k = first; k <= last; ++k)
                visit(i, k);
        }
    }
};

//! Which edge pixels can support the line of a chord: those that carry the bit of its bin.
class Support
{
public:
    Support(const EdgeMap& edges, ushort bit) : edges_(edges), bit_(bit) {}
    bool has(Point pixel) const
    {
        return edges_.votes.ptr<uchar>(pixel.y)[pixel.x] != 0 &&
               (!edges_.isOriented() || (edges_.directions.ptr<ushort>(pixel.y)[pixel.x] & bit_));
    }

private:
    const EdgeMap& edges_;
    ushort bit_;
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_BAND_HPP
