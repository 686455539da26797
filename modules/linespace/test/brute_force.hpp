// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The definition of the Line Space once more, as plainly as it can be said: what every test
// compares with. It is written from doc/algorithm.md alone and must never use, or be copied from,
// the library's sources. No tables, no vectors, no threads; every decision is exact in 64-bit
// integers.

#ifndef OPENCV_LINESPACE_TEST_BRUTE_FORCE_HPP
#define OPENCV_LINESPACE_TEST_BRUTE_FORCE_HPP

#include "opencv2/core.hpp"

namespace opencv_test {
namespace brute {

//! Points of the border in doubled coordinates: the midpoint of every unit edge is an integer
//! point.
typedef cv::Point_<int64> Doubled;

int borderCount(const cv::Size& cell);
//! Point of border index 0 .. borderCount - 1, clockwise from the top-left corner.
Doubled borderPoint(const cv::Size& cell, int index);
//! The inverse: the index of a border point, -1 for a point that is none.
int borderIndex(const cv::Size& cell, const Doubled& point);
//! 0 top, 1 right, 2 bottom, 3 left.
int borderSide(const cv::Size& cell, int index);
//! Whether the two border points make a chord: they are on different sides.
bool isChord(const cv::Size& cell, int s, int e);

//! Which axis counts as the major one when |dx| = |dy|. The definition says x; its transposition is
//! y.
enum DiagonalRule
{
    DIAGONAL_STEPS_X,
    DIAGONAL_STEPS_Y
};

//! One step of a chord's raster. The pixel may be outside the cell: then the step does not count.
struct Step
{
    cv::Point pixel;
    bool tie; //!< the exact minor coordinate is an integer, where the floor is a choice
};
std::vector<Step> raster(const Doubled& p, const Doubled& q, DiagonalRule rule = DIAGONAL_STEPS_X);
bool stepsAlongX(const Doubled& p, const Doubled& q, DiagonalRule rule = DIAGONAL_STEPS_X);

//! Value of a pixel, 0 outside the image.
int pixelValue(const cv::Mat& edges, const cv::Point& pixel, bool weighted = false);

//! The direction bin of a chord: 0 .. 15, of pi / 16 each.
int directionBin(const Doubled& direction);
//! Whether an edge pixel with this gradient votes for chords of a bin; tolerance in degrees.
bool votesForBin(const cv::Point2d& gradient, int bin, double tolerance);
//! votesForBin for all pixels and bins, a bit for each bin.
cv::Mat1w directions(const cv::Mat& dx, const cv::Mat& dy, double tolerance);

//! Votes of one chord of a frame by its raster; with directions, of the pixels that vote for its
//! bin.
int chordVotes(const cv::Mat& edges, const cv::Size& frame, int s, int e, bool weighted = false,
               const cv::Mat& directions = cv::Mat());
//! The whole table of a frame by chordVotes, both triangles.
cv::Mat1i exactTable(const cv::Mat& edges, const cv::Size& frame, bool weighted = false,
                     const cv::Mat& directions = cv::Mat());

//! How one axis is cut: 2^merges cells of `cell` pixels.
struct Axis
{
    int cell, merges;
    int frame() const { return cell << merges; }
};
Axis axisOf(int pixels, int wantedCell);

//! The shape of the cascade of an image.
struct Cascade
{
    Axis x, y;

    cv::Size frame() const { return cv::Size(x.frame(), y.frame()); }
    int levelCount() const { return x.merges + y.merges + 1; }
    //! Whether the merge from level - 1 to level joins left and right neighbours.
    bool mergesColumns(int level) const;
    //! Of the merges 1 .. level, those of left and right neighbours.
    int columnMerges(int level) const;
    cv::Size cellSize(int level) const;
    cv::Size gridSize(int level) const;
};
Cascade cascadeOf(const cv::Size& image, int wantedCell);

struct BinnedPixel
{
    cv::Point pixel;
    int bin; //!< of the part of the chord that counts it, in a cell of level 0
};
//! The pixels on a chord of a cell of a level, top-down by the definition of the merge; also such
//! in the padding.
void cascadePixels(const Cascade& cascade, int level, const cv::Point& cell, int s, int e,
                   std::vector<BinnedPixel>& pixels);
//! All cells and chords of one level in the layout of LineSpaceDetector::computeLevel.
cv::Mat1i cascadeTable(const cv::Mat& edges, const Cascade& cascade, int level,
                       bool weighted = false, const cv::Mat& directions = cv::Mat());

struct Candidate
{
    int s, e, votes;
};
//! The total order of lines: votes descending, then s, then e.
bool isStronger(const Candidate& a, const Candidate& b);

//! All chords s < e with more votes than minVotes, in the order (s, e).
std::vector<Candidate> chordsAbove(const cv::Mat1i& table, const cv::Size& frame, double minVotes);
//! Those that no chord of their (2 r + 1)^2 ring neighbourhood beats.
std::vector<Candidate> ringMaxima(const cv::Mat1i& table, const std::vector<Candidate>& all,
                                  int radius);
//! The strongest one of every aligned block of the table.
std::vector<Candidate> blockMaxima(const std::vector<Candidate>& all, int radius);
//! The strongest first, each deleting its ring neighbourhood.
std::vector<Candidate> greedyMaxima(const std::vector<Candidate>& all, int borderPoints,
                                    int radius);

//! (rho, theta) of a chord in OpenCV's coordinates, theta in [minTheta, minTheta + pi).
cv::Vec2d lineOf(const cv::Size& frame, int s, int e, double minTheta = 0);
//! The chord of a frame that a reported line came from, found again from its rounded (rho, theta).
bool chordOf(const cv::Size& frame, const cv::Vec3f& line, int& s, int& e);
//! Where a line enters and leaves the image; false if it misses it.
bool clipLine(const cv::Vec2d& line, const cv::Size& image, cv::Point2d ends[2]);
//! The larger distance of the two ends of `line` inside the image from the line `other`.
double endDistance(const cv::Vec2d& line, const cv::Vec2d& other, const cv::Size& image);

} // namespace brute
} // namespace opencv_test

#endif // OPENCV_LINESPACE_TEST_BRUTE_FORCE_HPP
