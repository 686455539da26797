// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The loops of strip_kernels.hpp as plainly as they can be said: what the reference runs, and every
// back end where vectors have no fixed size.

#ifndef OPENCV_LINESPACE_STRIP_KERNELS_GENERIC_HPP
#define OPENCV_LINESPACE_STRIP_KERNELS_GENERIC_HPP

#include "strip_kernels.hpp"

namespace cv {
namespace linespace {
namespace generic {

template<class Votes>
void addColumns(const Votes* const* columns, const int* offsets, int count, int t, int across,
                const StripRows<Votes>& out)
{
    for (int y = out.first(t); y < out.end(t, across); ++y)
    {
        int votes = 0;
        for (int i = 0; i < count; ++i)
            votes += columns[i][y + offsets[i]];
        out.row(t)[y] = (Votes)votes;
    }
}

template<class Votes>
void mergeStrips(const StripRows<Votes>& a, const StripRows<Votes>& b, int across,
                 const StripRows<Votes>& out)
{
    for (int t = -out.reach; t <= out.reach; ++t)
    {
        // The chord crosses the common side at y + t / 2, of two nearest border points the larger.
        const int left = (int)floorDiv(t + 1, 2);
        for (int y = out.first(t); y < out.end(t, across); ++y)
            out.row(t)[y] = (Votes)(a.row(left)[y] + b.row(t - left)[y + left]);
    }
}

template<class Votes>
void poolStrip(const StripRows<Votes>& chords, const LeafRows& out)
{
    const int unit = voteUnit<Votes>();
    for (int T = -out.grid.reach; T < out.grid.reach; ++T)
        for (int Y = out.grid.first(T); Y < out.grid.end(T); ++Y)
        {
            int most = 0;
            for (int t = 4 * T; t < 4 * T + 4; ++t)
                for (int y = 4 * Y; y < 4 * Y + 4; ++y)
                    most = std::max<int>(most, chords.row(t)[y]);
            out.row(T)[Y] = (uchar)((most + unit - 1) / unit);
        }
}

template<class Votes>
void addChords(const Votes* tables, const int* offsets, int first, int last, int* sums)
{
    std::fill(sums, sums + 16, 0);
    for (int i = first; i < last; ++i)
        for (int k = 0; k < 16; ++k)
            sums[k] += tables[offsets[i] + k];
}

inline void widenLeaf(const LeafRows& from, const NodeRows& out)
{
    for (int T = -out.grid.reach; T < out.grid.reach; ++T)
        for (int Y = out.grid.first(T); Y < out.grid.end(T); ++Y)
            out.row(T)[Y] = from.row(T)[Y];
}

//! A bundle's entry, 0 outside of its rows.
inline int entryOf(const NodeRows& rows, int T, int Y)
{
    return Y >= rows.grid.first(T) && Y < rows.grid.end(T) ? rows.row(T)[Y] : 0;
}

inline void mergeBundles(const NodeRows& a, int nA, const NodeRows& b, int nB, const NodeRows& out)
{
    const int n = nA + nB;
    for (int T = -out.grid.reach; T < out.grid.reach; ++T)
    {
        // The middle of the bundles' chords crosses the common side (2 T + 1) nA / (2 n) bundles
        // farther than it enters.
        const int left = (int)floorDiv((2 * T + 1) * nA, 2 * n),
                  right = (int)floorDiv((2 * T + 1) * nB, 2 * n),
                  crossing = (int)floorDiv((2 * T + 1) * nA + n, 2 * n);
        for (int Y = out.grid.first(T); Y < out.grid.end(T); ++Y)
            out.row(T)[Y] =
                (ushort)(entryOf(a, left, Y) + std::max(entryOf(b, right, Y + crossing),
                                                        entryOf(b, right, Y + crossing + 1)));
    }
}

inline void poolBundles(const NodeRows& from, const NodeRows& out)
{
    for (int T = -out.grid.reach; T < out.grid.reach; ++T)
        for (int Y = out.grid.first(T); Y < out.grid.end(T); ++Y)
        {
            int most = 0;
            for (int i = 0; i < 2; ++i)
                for (int k = 0; k < 2; ++k)
                    most = std::max(most, entryOf(from, 2 * T + i, 2 * Y + k));
            out.row(T)[Y] = (ushort)most;
        }
}

inline void addLeaves(const uchar* leaves, const int* offsets, int first, int last, ushort* sums)
{
    std::fill(sums, sums + 16, (ushort)0);
    for (int i = first; i < last; ++i)
    {
        const uchar* const row = leaves + offsets[i];
        for (int k = 0; k < 16; ++k)
            sums[k] = (ushort)(sums[k] + std::max(row[k], row[k + 1]));
    }
}

template<class Votes>
const StripKernels<Votes>& stripKernels()
{
    static const StripKernels<Votes> kernels = {addColumns<Votes>, mergeStrips<Votes>,
                                                poolStrip<Votes>, addChords<Votes>};
    return kernels;
}

inline const BundleKernels& bundleKernels()
{
    static const BundleKernels kernels = {widenLeaf, mergeBundles, poolBundles, addLeaves};
    return kernels;
}

} // namespace generic
} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_STRIP_KERNELS_GENERIC_HPP
