// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// A merge as a few rectangles of chords, within which all indices are affine: what a device that
// computes them for each chord needs to know (doc/algorithm.md, section 3.3).

#ifndef OPENCV_LINESPACE_MERGE_RECTANGLES_HPP
#define OPENCV_LINESPACE_MERGE_RECTANGLES_HPP

#include "plan.hpp"

namespace cv {
namespace linespace {

//! Consecutive border points of the parent on one side of one child.
struct BorderPart
{
    int first, count;
};

//! Those of a merge, in the order of the parent's border.
std::vector<BorderPart> borderParts(const Merge& merge);

/** The chords (s + a, e + b) of the parent, a = 0 .. rows - 1, b = 0 .. columns - 1, all s + a on
one side of one child, and all e + b on one side of one child.

Their indices are start + a rowLength + b. Either all lie in child childS, where they are chords
partS + a stepS + b stepE; or all cross the shared side, at m = crossing(s + a, e + b), and are the
sums of chords partS + a stepS + m sharedS of child childS and partE + b stepE + m sharedE of the
other one. */
struct MergeRectangle
{
    size_t start;
    int rows, columns, rowLength;
    bool isCrossing;
    int childS;
    size_t partS, partE;
    ptrdiff_t stepS, stepE, sharedS, sharedE;
    //! Merge::relativeTo of s and e, and how they change with a and b.
    int alongS, acrossS, alongStepS, acrossStepS;
    int alongE, acrossE, alongStepE, acrossStepE;
};

//! The chords between two such parts on different sides of the parent, or within them, the one of s
//! first.
MergeRectangle mergeRectangle(const Merge& merge, const BorderPart& ofS, const BorderPart& ofE);

//! All chords of the parent, each once.
std::vector<MergeRectangle> mergeRectangles(const Merge& merge);

//! The same, those of one kind and shape together.
std::vector<std::vector<MergeRectangle>> alikeRectangles(const Merge& merge);

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_MERGE_RECTANGLES_HPP
