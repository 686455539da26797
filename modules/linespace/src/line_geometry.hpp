// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Lines outside of the table: normal form, ends inside an image, angle intervals. Coordinates are
// OpenCV's, pixel centres at integers: the image covers [-0.5, width - 0.5] x [-0.5, height - 0.5].

#ifndef OPENCV_LINESPACE_LINE_GEOMETRY_HPP
#define OPENCV_LINESPACE_LINE_GEOMETRY_HPP

#include "plan.hpp"

namespace cv {
namespace linespace {

//! x cos(theta) + y sin(theta) = rho
struct Line
{
    double rho, theta;
};

//! Where a line enters and leaves an image.
struct Ends
{
    Point2d first, second;
};

//! The line of a chord of a frame, theta in [0, pi).
Line lineOf(const Cell& frame, Chord chord);

//! False if the line misses the image. The first end has the smaller x, of equal ones the smaller
//! y.
bool clipLine(double cosine, double sine, double rho, Size image, Ends& ends);

//! A closed interval of angles; of pi or more it means all directions, in [min, min + pi).
struct AngleInterval
{
    double min, max;

    bool isFull() const { return max - min >= CV_PI; }
    //! Writes the line with its angle in the interval; false if there is none.
    bool represent(Line& line) const;
    bool contains(double theta) const
    {
        return theta >= min && (isFull() ? theta < min + CV_PI : theta <= max);
    }
    /** (rho, theta) as floats, theta in the interval after rounding as well, unless no float is.
    For lines from represent(). */
    Vec2f round(const Line& line) const;
};

/** Lines of an image that were reported already, for the question whether another one is a
duplicate: whether its two ends are both within a distance of one of them. A hash of angle and
distance from the centre of the image keeps the search short; the answer is that of a comparison
with all. */
class LineIndex
{
public:
    LineIndex(Size image, double distance);
    void insert(const Line& line);
    bool hasNear(const Line& line, const Ends& ends) const;

private:
    struct Entry
    {
        double cosine, sine, rho;
        int next; //!< entry of the bin, -1: none
    };
    enum
    {
        ANGLE_BINS = 256
    };
    int distanceBin(double distance) const;
    int bin(int angle, int distance) const { return angle * distanceBins_ + distance; }

    Point2d centre_;
    double distance_, radius_, distanceStep_;
    int distanceBins_;
    std::vector<int> bins_; //!< the last entry of each, -1: none
    std::vector<Entry> entries_;
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_LINE_GEOMETRY_HPP
