// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The statistical threshold (doc/algorithm.md, section 7), after A. Desolneux, L. Moisan,
// J.-M. Morel, "Meaningful alignments", International Journal of Computer Vision 40 (2000).

#ifndef OPENCV_LINESPACE_ACONTRARIO_HPP
#define OPENCV_LINESPACE_ACONTRARIO_HPP

#include "precomp.hpp"

namespace cv {
namespace linespace {

/** The smallest significant numbers of votes. By chance, the pixels along a chord are a Markov
chain: one is an edge pixel with probability `density`, and the one after an edge pixel with at
least 0.75, because edge detectors give chains of pixels where there is no line, too.
@param maxLength longest chord in pixels, >= 0.
@param density probability that a pixel is an edge pixel, in [0, 1].
@param tests number of chords that are looked at, >= 1.
@param falseAlarms epsilon, > 0.
@return for every length l of 0 to maxLength the smallest k with
tests * P(a chain of l pixels has k or more edge pixels) < epsilon, at most l + 1, which no chord
reaches. Does not decrease with l. */
std::vector<int> significantVotes(int maxLength, double density, double tests, double falseAlarms);

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_ACONTRARIO_HPP
