// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// An interval of angles as a device needs it: without angles.

#ifndef OPENCV_LINESPACE_ANGLE_ENDS_HPP
#define OPENCV_LINESPACE_ANGLE_ENDS_HPP

#include "line_geometry.hpp"

namespace cv {
namespace linespace {

//! Whether an interval has the line of a chord.
bool isInInterval(const Cell& frame, const AngleInterval& angles, Chord chord);

/** The chords of a frame that are in an interval of angles. Around a border point the direction turns
one way, by less than half a turn, so that the partners e of s are those of two ranges at most. */
class AngleEnds
{
public:
    AngleEnds() : angles_{0, CV_PI} {}

    /** For each s that is not on the left side, [e0, e1) and [e2, e3), each maybe empty; as
    isInInterval() tells for every chord. Kept for the next call. */
    const std::vector<Vec4i>& of(const Cell& frame, const AngleInterval& angles);

private:
    Cell frame_;
    AngleInterval angles_;
    std::vector<Vec4i> ranges_;
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_ANGLE_ENDS_HPP
