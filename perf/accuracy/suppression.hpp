// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// What the Line Space does with near-duplicates by itself, for detectors that do nothing.

#ifndef LINESPACE_ACCURACY_SUPPRESSION_HPP
#define LINESPACE_ACCURACY_SUPPRESSION_HPP

#include "detectors.hpp"

namespace accuracy {

/** Drops each line whose two ends inside the image are both within 3 pixels of a stronger line that
is kept, and lines that miss the image.
@param lines strongest first.
@param maxLines stops after so many; 0: never. */
std::vector<DetectedLine> withoutNearDuplicates(const std::vector<DetectedLine>& lines,
                                                cv::Size size, int maxLines);

} // namespace accuracy

#endif // LINESPACE_ACCURACY_SUPPRESSION_HPP
