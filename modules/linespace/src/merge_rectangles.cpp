// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "merge_rectangles.hpp"

namespace cv {
namespace linespace {

namespace {

//! Consecutive border points of the parent on one side of one child.
struct Part
{
    int first, count;
};

//! How a coordinate changes along a part; of one point, 0.
void relativeSteps(const Merge& merge, const Part& part, int& along, int& across, int& alongStep,
                   int& acrossStep)
{
    merge.relativeTo(part.first, along, across);
    alongStep = acrossStep = 0;
    if (part.count < 2)
        return;
    merge.relativeTo(part.first + 1, alongStep, acrossStep);
    alongStep -= along;
    acrossStep -= across;
}

MergeRectangle rectangleOf(const Merge& merge, const Part& partOfS, const Part& partOfE)
{
    const Cell &parent = merge.parent, &child = merge.child;
    const int s = partOfS.first, e = partOfE.first;
    const int childS = merge.childOf(s), childE = merge.childOf(e);
    const int pointS = merge.childPoint(s), pointE = merge.childPoint(e);
    MergeRectangle result = MergeRectangle();
    result.start = parent.chordIndex(s, e);
    result.rows = partOfS.count;
    result.columns = partOfE.count;
    result.rowLength = parent.rowLength(parent.sideOf(s));
    result.isCrossing = childS != childE;
    result.childS = childS;
    if (!result.isCrossing)
    {
        result.partS = child.chordIndexOf(pointS, pointE);
        result.stepS = child.chordStride(pointS, pointE);
        result.stepE = child.chordStride(pointE, pointS);
        return result;
    }
    const int shareS = merge.sharedPoint(childS, 0), shareE = merge.sharedPoint(childE, 0);
    result.partS = child.chordIndexOf(pointS, shareS);
    result.stepS = child.chordStride(pointS, shareS);
    result.sharedS = merge.sharedDirection(childS) * child.chordStride(shareS, pointS);
    result.partE = child.chordIndexOf(pointE, shareE);
    result.stepE = child.chordStride(pointE, shareE);
    result.sharedE = merge.sharedDirection(childE) * child.chordStride(shareE, pointE);
    relativeSteps(merge, partOfS, result.alongS, result.acrossS, result.alongStepS,
                  result.acrossStepS);
    relativeSteps(merge, partOfE, result.alongE, result.acrossE, result.alongStepE,
                  result.acrossStepE);
    return result;
}

} // namespace

std::vector<MergeRectangle> mergeRectangles(const Merge& merge)
{
    // Each side of a child that is not the shared one is one part, but its points follow one
    // another on the parent as well.
    std::vector<Part> parts;
    for (int side = SIDE_TOP; side <= SIDE_LEFT; ++side)
    {
        const int first = merge.parent.firstPoint(side), count = merge.parent.pointCount(side),
                  childCount = merge.child.pointCount(side);
        for (int begin = 0; begin < count; begin += childCount)
        {
            const Part part = {first + begin, childCount};
            parts.push_back(part);
        }
    }
    std::vector<MergeRectangle> rectangles;
    for (size_t i = 0; i < parts.size(); ++i)
        for (size_t k = i + 1; k < parts.size(); ++k)
            if (merge.parent.isChord(parts[i].first, parts[k].first))
                rectangles.push_back(rectangleOf(merge, parts[i], parts[k]));
    return rectangles;
}

} // namespace linespace
} // namespace cv
