// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "merge_rectangles.hpp"

#include <algorithm>

namespace cv {
namespace linespace {

namespace {

//! How a coordinate changes along a part; of one point, 0.
void relativeSteps(const Merge& merge, const BorderPart& part, int& along, int& across,
                   int& alongStep, int& acrossStep)
{
    merge.relativeTo(part.first, along, across);
    alongStep = acrossStep = 0;
    if (part.count < 2)
        return;
    merge.relativeTo(part.first + 1, alongStep, acrossStep);
    alongStep -= along;
    acrossStep -= across;
}

} // namespace

std::vector<BorderPart> borderParts(const Merge& merge)
{
    // Each side of a child that is not the shared one is one part, but its points follow one
    // another on the parent as well.
    std::vector<BorderPart> parts;
    for (int side = SIDE_TOP; side <= SIDE_LEFT; ++side)
    {
        const int first = merge.parent.firstPoint(side), count = merge.parent.pointCount(side),
                  childCount = merge.child.pointCount(side);
        for (int begin = 0; begin < count; begin += childCount)
        {
            const BorderPart part = {first + begin, childCount};
            parts.push_back(part);
        }
    }
    return parts;
}

MergeRectangle mergeRectangle(const Merge& merge, const BorderPart& ofS, const BorderPart& ofE)
{
    const Cell &parent = merge.parent, &child = merge.child;
    const int s = ofS.first, e = ofE.first;
    const int childS = merge.childOf(s), childE = merge.childOf(e);
    const int pointS = merge.childPoint(s), pointE = merge.childPoint(e);
    MergeRectangle result = MergeRectangle();
    result.start = parent.chordIndex(s, e);
    result.rows = ofS.count;
    result.columns = ofE.count;
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
    relativeSteps(merge, ofS, result.alongS, result.acrossS, result.alongStepS, result.acrossStepS);
    relativeSteps(merge, ofE, result.alongE, result.acrossE, result.alongStepE, result.acrossStepE);
    return result;
}

std::vector<MergeRectangle> mergeRectangles(const Merge& merge)
{
    const std::vector<BorderPart> parts = borderParts(merge);
    std::vector<MergeRectangle> rectangles;
    for (size_t i = 0; i < parts.size(); ++i)
        for (size_t k = i + 1; k < parts.size(); ++k)
            if (merge.parent.isChord(parts[i].first, parts[k].first))
                rectangles.push_back(mergeRectangle(merge, parts[i], parts[k]));
    return rectangles;
}

std::vector<std::vector<MergeRectangle>> alikeRectangles(const Merge& merge)
{
    std::vector<std::vector<MergeRectangle>> groups;
    for (const MergeRectangle& rectangle : mergeRectangles(merge))
    {
        const auto group = std::find_if(groups.begin(), groups.end(),
                                        [&](const std::vector<MergeRectangle>& others)
                                        {
                                            const MergeRectangle& other = others.front();
                                            return other.isCrossing == rectangle.isCrossing &&
                                                   other.rows == rectangle.rows &&
                                                   other.columns == rectangle.columns;
                                        });
        if (group != groups.end())
            group->push_back(rectangle);
        else
            groups.push_back(std::vector<MergeRectangle>(1, rectangle));
    }
    return groups;
}

} // namespace linespace
} // namespace cv
