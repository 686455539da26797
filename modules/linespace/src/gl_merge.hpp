// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Tables of votes in OpenGL, and what the launches of a merge have in common.
//
// Tables are in the order of stages.hpp, [chord][cell], in words of 32 bits: the votes of
// consecutive cells share a word, the first in its lowest bits, and a chord has at least one word,
// so that those of the last table, of one cell, have one each.

#ifndef OPENCV_LINESPACE_GL_MERGE_HPP
#define OPENCV_LINESPACE_GL_MERGE_HPP

#include "gl_device.hpp"
#include "merge_rectangles.hpp"

namespace cv {
namespace linespace {

int logOf(size_t powerOfTwo);

//! Words of a chord's votes, or of a pixel's.
size_t wordsOf(size_t cells, int bytes);
size_t wordsOf(const VoteTable& table);
size_t bytesOf(const VoteTable& table);

inline const GlBuffer& bufferOf(const VoteTable& table)
{
    return static_cast<const GlBuffer&>(*table.memory);
}

//! How shaders after children.glsl make a parent's table of a child's.
struct GlMerging
{
    enum
    {
        MOST_RECTANGLES = 13 //!< of a launch
    };

    const VoteTable &child, &parent;
    std::string options; //!< the windows show the child's table
    int words;           //!< of a chord of the parent
    int lanesLog;        //!< of the invocations that share one

    GlMerging(const GlDevice& device, const VoteTable& childTable, const VoteTable& parentTable);
    std::vector<int> numbers() const;

    /** Rectangles of one kind and shape.
    @param offset,bytes of the part of the parent's table that has them; their starts count from
    there.
    @param isBeside as GlLaunch::runRows has it. */
    void run(GlDevice& device, const std::vector<MergeRectangle>& rectangles, size_t offset,
             size_t bytes, bool isBeside) const;
    //! The same by another shader that takes them as merge.glsl does, with so many items and rows
    //! of a rectangle.
    void run(GlLaunch launch, const std::vector<MergeRectangle>& rectangles, size_t offset,
             size_t bytes, int items, int rows, bool isBeside) const;
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_GL_MERGE_HPP
