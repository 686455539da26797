// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Which lines LineSpaceDetector::detect must report, from brute-force tables (doc/algorithm.md,
// section 4), and comparisons with those that it did.

#ifndef OPENCV_LINESPACE_TEST_EXPECTED_LINES_HPP
#define OPENCV_LINESPACE_TEST_EXPECTED_LINES_HPP

#include "brute_force.hpp"
#include "test_support.hpp"

namespace opencv_test {

typedef std::vector<cv::Vec3f> Lines;

Lines detectLines(LineSpaceDetector& detector, const cv::Mat& edges);

//! A map with a few lines and noise, small enough for brute force.
cv::Mat1b smallScene(unsigned seed = 1);

//! The same lines bit by bit, in the same order.
void expectSameLines(const Lines& actual, const Lines& expected, const std::string& what);

//! The lines are those of the candidates, with their votes, in their order.
void expectChords(const Lines& lines, const std::vector<brute::Candidate>& expected,
                  const cv::Size& frame, const std::string& what);

enum Thinning
{
    THIN_NOT,
    THIN_RING,
    THIN_BLOCKS,
    THIN_GREEDY
};

//! The selection of section 4 without near-duplicates.
class Selection
{
public:
    Selection(const cv::Mat& edges, int method, int cellSize, bool weighted = false,
              const cv::Mat& directions = cv::Mat());

    //! Lines must have more than mostRefused votes; pool 0: all candidates.
    std::vector<brute::Candidate> select(int mostRefused, double ratio, int thinning, int radius,
                                         size_t pool = 0) const;

    cv::Size frame;

private:
    //! Those stronger than (s + 1, e - 1) and (s - 1, e + 1).
    std::vector<brute::Candidate> parallelMaxima(const std::vector<brute::Candidate>& all) const;
    //! To the strongest of the ring neighbourhood, until it is the chord itself.
    brute::Candidate climb(const brute::Candidate& start, int radius) const;

    bool climbs; //!< with the cascade, whose maxima need not be those of the exact votes
    cv::Mat1i exact, table;
};

} // namespace opencv_test

#endif // OPENCV_LINESPACE_TEST_EXPECTED_LINES_HPP
