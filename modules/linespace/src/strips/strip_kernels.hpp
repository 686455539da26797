// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The inner loops of the cascade of strips as functions of the running processor's instruction set
// (strip_kernels.simd.hpp).

#ifndef OPENCV_LINESPACE_STRIP_KERNELS_HPP
#define OPENCV_LINESPACE_STRIP_KERNELS_HPP

#include "strip_tables.hpp"

namespace cv {
namespace linespace {

/** Loops over the votes of chords, which are uchar, or ushort for a map with weights. The rows that
they read have zeros around them (ROW_BEFORE, ROW_BEHIND). */
template<class Votes>
struct StripKernels
{
    /** Narrow strips: the votes of the chords (y, t) of one t.
    @param columns of pixels, of which those of chord (y, t) are columns[i][y + offsets[i]].
    @param count of the columns, 4 or 8.
    @param across pixels of a column. */
    void (*addColumns)(const Votes* const* columns, const int* offsets, int count, int t,
                       int across, const StripRows<Votes>& out);
    //! A strip from its two halves.
    void (*mergeStrips)(const StripRows<Votes>& a, const StripRows<Votes>& b, int across,
                        const StripRows<Votes>& out);
    /** The bundles of a strip from its chords: the most votes of 4 x 4 chords, in units of
    voteUnit<Votes>(), rounded up. */
    void (*poolStrip)(const StripRows<Votes>& chords, const LeafRows& out);
    /** The votes of 16 chords in a row of each strip, added up.
    @param offsets for i = first .. last - 1, tables + offsets[i] is the first one of a row.
    @param sums 16 of them. */
    void (*addChords)(const Votes* tables, const int* offsets, int first, int last, int* sums);
};

template<class Votes>
const StripKernels<Votes>& stripKernels();

//! Votes that bundles count as one: what 64 pixels of weight 255 give is 255 units, then.
template<class Votes>
inline int voteUnit()
{
    return sizeof(Votes) == 1 ? 1 : 64;
}

//! Loops over bundles.
struct BundleKernels
{
    //! The bundles of one strip as those of a node.
    void (*widenLeaf)(const LeafRows& from, const NodeRows& out);
    /** The bundles of a run of strips from those of its two parts, all of one side. Two chords of two
    bundles that meet cross the parts' common side in one bundle of the second part or the next.
    @param nA,nB strips of the parts. */
    void (*mergeBundles)(const NodeRows& a, int nA, const NodeRows& b, int nB, const NodeRows& out);
    //! Bundles of twice the side.
    void (*poolBundles)(const NodeRows& from, const NodeRows& out);
    /** The most votes of 16 bundles in a row of each leaf and their next ones, added up.
    @param offsets for i = first .. last - 1, leaves + offsets[i] is the first one of a row.
    @param sums 16 of them. */
    void (*addLeaves)(const uchar* leaves, const int* offsets, int first, int last, ushort* sums);
};

const BundleKernels& bundleKernels();

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_STRIP_KERNELS_HPP
