// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The memory of the cascade of strips: rows of votes with zeros around them, so that nothing that
// reads along a row has to look where it ends.

#ifndef OPENCV_LINESPACE_STRIP_TABLES_HPP
#define OPENCV_LINESPACE_STRIP_TABLES_HPP

#include "../memory.hpp"
#include "strip_plan.hpp"

#include <cstring>

namespace cv {
namespace linespace {

//! Zeros around rows of votes.
enum
{
    ROW_BEFORE = 64,         //!< entries before a row
    ROW_BEHIND = 64 + STRIP, //!< and behind the longest one, of which the next row's are a part
    KEPT_BEFORE = 32,        //!< the same of the tables of strips, which no merge reads
    KEPT_BEHIND = 64
};

/** The votes of the chords of one strip: row t = -reach .. reach holds those of (y, t), the chords
that enter at border point y and leave at y + t, for all y from first(t) to end(t) - 1; all others
miss the image. */
template<class Votes>
struct StripRows
{
    Votes* data; //!< of row -reach, entry 0
    ptrdiff_t stride;
    int reach;

    Votes* row(int t) const { return data + (t + reach) * stride + std::max(t, 0); }
    static int first(int t) { return -std::max(t, 0); }
    static int end(int t, int across) { return across + std::max(-t, 0); }
};

//! Bundles in rows T of entries Y, see BundleGrid.
template<class Votes>
struct BundleRows
{
    enum
    {
        BEFORE = 32, //!< zeros before a row
        BEHIND = 80  //!< and behind
    };
    Votes* data; //!< of row -reach, entry 0
    ptrdiff_t stride;
    BundleGrid grid;

    BundleRows() : data(0), stride(0) {}
    Votes* row(int T) const { return data + (T + grid.reach) * stride + std::max(T + 1, 0); }
    static size_t strideOf(const BundleGrid& grid)
    {
        return (BEFORE + grid.across + grid.reach + BEHIND + 15) / 16 * 16;
    }
    static size_t sizeOf(const BundleGrid& grid) { return 2 * grid.reach * strideOf(grid); }
    //! Lays out rows in memory of sizeOf(grid) entries.
    void layOut(const BundleGrid& bundles, Votes* memory)
    {
        grid = bundles;
        stride = strideOf(grid);
        data = memory + BEFORE;
    }
};
typedef BundleRows<uchar> LeafRows;
typedef BundleRows<ushort> NodeRows;

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_STRIP_TABLES_HPP
