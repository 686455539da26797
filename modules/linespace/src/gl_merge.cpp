// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "gl_merge.hpp"

#ifdef LINESPACE_OPENGL

#include "gl_maxima.hpp"

namespace cv {
namespace linespace {

int logOf(size_t powerOfTwo)
{
    int log = 0;
    while (((size_t)1 << log) < powerOfTwo)
        ++log;
    return log;
}

size_t wordsOf(size_t cells, int bytes)
{
    return std::max<size_t>(1, cells * bytes / sizeof(uint));
}

size_t wordsOf(const VoteTable& table)
{
    return wordsOf(table.cells, table.depth);
}

size_t bytesOf(const VoteTable& table)
{
    return table.chords * wordsOf(table) * sizeof(uint);
}

GlMerging::GlMerging(const GlDevice& device, const VoteTable& childTable,
                     const VoteTable& parentTable)
    : child(childTable), parent(parentTable), words((int)wordsOf(parent)),
      lanesLog(logOf(std::min<size_t>(words, GlDevice::GROUP)))
{
    options = windowOptions(device.limits(), bytesOf(child)) +
              define("CHILD_BITS", 8 * child.depth) + define("PARENT_BITS", 8 * parent.depth) +
              define("RECTANGLES", MOST_RECTANGLES);
}

std::vector<int> GlMerging::numbers() const
{
    // Of the child's votes that come to a word of the parent.
    const int bits =
        8 * child.depth * (int)std::min<size_t>(parent.cells, sizeof(uint) / parent.depth);
    const int mask = bits == 32 ? -1 : (int)((1u << bits) - 1);
    return {0, 0, lanesLog, logOf(parent.cells), words, (int)wordsOf(child), mask};
}

void GlMerging::run(GlDevice& device, const std::vector<MergeRectangle>& rectangles, size_t offset,
                    size_t bytes, bool isBeside) const
{
    const MergeRectangle& any = rectangles.front();
    run(GlLaunch(device, GL_MERGE, options + (any.isCrossing ? define("CROSSING") : std::string())),
        rectangles, offset, bytes, any.columns << lanesLog, any.rows, isBeside);
}

void GlMerging::run(GlLaunch launch, const std::vector<MergeRectangle>& rectangles, size_t offset,
                    size_t bytes, int items, int rows, bool isBeside) const
{
    CV_DbgAssert(rectangles.size() <= (size_t)MOST_RECTANGLES);
    std::vector<Vec4i> fours;
    for (const MergeRectangle& r : rectangles)
    {
        fours.push_back(Vec4i(r.columns, r.rows, (int)r.start, r.rowLength));
        fours.push_back(Vec4i(r.childS, (int)r.partS, (int)r.stepS, (int)r.sharedS));
        fours.push_back(Vec4i((int)r.stepE, (int)r.partE, (int)r.stepE, (int)r.sharedE));
        fours.push_back(Vec4i(r.alongS, r.alongStepS, r.acrossS, r.acrossStepS));
        fours.push_back(Vec4i(r.alongE, r.alongStepE, r.acrossE, r.acrossStepE));
    }
    launch.windows(bufferOf(child), bytesOf(child))
        .block(bufferOf(parent), offset, bytes)
        .fours(fours)
        .runRows(numbers(), items, rows, (int)rectangles.size(), isBeside);
}

} // namespace linespace
} // namespace cv

#endif // LINESPACE_OPENGL
