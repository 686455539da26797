// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Synthetic images with lines that are known exactly: blurred step edges and bars, rendered
// analytically, and images without any line. The same seed gives the same image on every platform.

#ifndef LINESPACE_ACCURACY_SCENE_HPP
#define LINESPACE_ACCURACY_SCENE_HPP

#include <cstdint>
#include <vector>

#include "opencv2/core.hpp"

namespace scenes {

/** The line x cos(theta) + y sin(theta) = rho in pixels, pixel centres at integers, theta in [0, pi)
radians. Its positive side is where x cos(theta) + y sin(theta) > rho. */
struct Line
{
    double rho, theta;
};

struct SceneOptions
{
    cv::Size size{256, 256};
    int lines = 8;
    double background = 128; //!< grey level, 0 to 255
    double contrast = 25;    //!< grey levels; each line adds or subtracts it, by chance
    double blur = 0.5; //!< sigma of the edge's profile (an error function), pixels; 0: a hard step
    double noise = 0;  //!< sigma of white Gaussian noise, grey levels
    //! Least length of a line inside the image, as a share of the image's shorter side; at most 1.
    double minShare = 0.5;
    /** Two lines are at least this far from each other at one of their ends in the image, pixels.
    Closer ones would be one line to a tolerance of half of it. */
    double minSeparation = 6;
    double barWidth = 3;     //!< full width of a bar, pixels
    double keptFraction = 1; //!< share of a bar's length that is drawn, in dashes of 8 pixels
};

struct Scene
{
    cv::Mat1b image;
    std::vector<Line> truth; //!< for bars, their centre lines
};

/** Ends of a line's chord in the rectangle [-0.5, width - 0.5] x [-0.5, height - 0.5] of an image;
false if the line misses it. */
bool chordEnds(const Line& line, cv::Size size, cv::Point2d ends[2]);

/** Random lines that keep minShare and minSeparation: uniform theta, then uniform rho. */
std::vector<Line> randomLines(const SceneOptions& options, std::uint64_t seed);

/** Half-planes: the positive side of each line is contrast brighter or darker. Signs are drawn anew
until the image without noise keeps inside 0 to 255. */
Scene stepEdges(const SceneOptions& options, std::uint64_t seed);
//! The same with lines of the caller's.
Scene stepEdges(const std::vector<Line>& lines, const SceneOptions& options, std::uint64_t seed);

//! Bright or dark bars of barWidth; where they cross, their contrasts add up.
Scene bars(const SceneOptions& options, std::uint64_t seed);

//! Images without a straight edge.
enum class Negative
{
    Noise, //!< white Gaussian noise, sigma 20
    Ramp,  //!< grey levels 64 to 192 across the image in a random direction, noise of sigma 4
    Discs, //!< 12 to 24 discs of radius 1/32 to 1/8 of the shorter side, edges blurred, sigma 4
    Salt   //!< 2 % of the pixels white on grey
};
cv::Mat1b negative(Negative kind, cv::Size size, std::uint64_t seed);

//! Keeps each edge pixel with this chance, 0 to 1.
void thinOut(cv::Mat1b& edges, double keptFraction, std::uint64_t seed);
//! Makes each pixel an edge pixel with this chance, 0 to 1.
void addClutter(cv::Mat1b& edges, double share, std::uint64_t seed);

} // namespace scenes

#endif // LINESPACE_ACCURACY_SCENE_HPP
