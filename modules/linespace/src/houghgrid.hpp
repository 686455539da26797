// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The grid of lines of the Hough transform, and how their votes are counted (doc/algorithm.md,
// section 8).

#ifndef OPENCV_LINESPACE_HOUGHGRID_HPP
#define OPENCV_LINESPACE_HOUGHGRID_HPP

#include "line_geometry.hpp"
#include "stages.hpp"

namespace cv {
namespace linespace {

/** The lines (i rho, min_theta + j theta), j = 0 .. angles - 1, of an image. Pixel (x, y) belongs
to line i of angle j if round(x cosines[j] + y sines[j]) = i, in float, ties to even. */
struct HoughGrid
{
    double rho;
    AngleInterval interval;
    int angles;
    int mostDistance; //!< |i| is never larger
    bool wraps;       //!< the last angle is within theta of the first one plus pi
    Size image;
    std::vector<double> thetas;
    std::vector<float> cosines, sines; //!< of the angles, divided by rho

    /** Throws where cv::HoughLines does: rho or theta not positive or not a number, min_theta >
    max_theta, angles not finite, or too many to count. */
    HoughGrid(Size imageSize, double rho, double theta, double minTheta, double maxTheta);

    //! (rho, theta) of a line as reported.
    Vec2f line(int angle, int distance) const;

    /** Whether whole rows or columns of pixels can lie on the boundary between two lines (as at rho
    = 2): they are within rho / 2 of both, and vote for both. */
    bool isAxisParallel(int angle) const;

    //! Nearest integer, ties to even, of a pixel's position in units of rho.
    int nearest(float value) const;

    //! Whether all positions are so small (below 2^22) that the nearest integer is in the low bits
    //! of a sum.
    bool isSmall() const;

    //! Smallest and largest i that a pixel of the image can have at an angle.
    void distanceRange(int angle, int& first, int& last) const;
};

//! A line of the grid that has so many votes.
struct GridLine
{
    int votes, angle, distance;
};

//! The edge pixels by rows, and as a map with its transpose for walks along lines.
struct EdgePixels
{
    std::vector<float> x, y;
    std::vector<int> weights; //!< empty if all are 1
    const EdgeMap* edges;

    explicit EdgePixels(const EdgeMap& edgeMap);
    size_t count() const { return x.size(); }
};

//! Up to so many lines of an angle are cheaper to count one by one than with all pixels.
int mostWalkedLines(const HoughGrid& grid, size_t pixels);

//! Counts the votes of lines of one angle, by whichever way is cheaper: all pixels, or each line's
//! own.
class BandCounter
{
public:
    BandCounter(const EdgePixels& pixels, const HoughGrid& grid);
    //! votes[k] becomes the votes of line distances[k] of the angle.
    void count(int angle, const std::vector<int>& distances, std::vector<int>& votes);

private:
    void countAll(int angle);
    int countLine(int angle, int distance) const;

    const EdgePixels& pixels_;
    const HoughGrid& grid_;
    std::vector<int> histogram_;
};

//! All lines of an angle that a pixel can vote for.
void allDistances(const HoughGrid& grid, int angle, std::vector<int>& distances);

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_HOUGHGRID_HPP
