// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The inner loops of the cascade of strips, compiled once per instruction set and chosen at run
// time (strip_kernels.dispatch.cpp). All of them add or compare consecutive bytes or shorts.
//
// Why this is faster than a cascade of cells: a merge is one add of two rows that are shifted
// against one another, so no crossing is computed and nothing is gathered.

#include "../precomp.hpp"
#include "../vectors.hpp"
#include "strip_kernels_generic.hpp"

namespace cv {
namespace linespace {

CV_CPU_OPTIMIZATION_NAMESPACE_BEGIN

//! The functions of strip_kernels.hpp, compiled for this instruction set.
const StripKernels<uchar>& byteKernels();
const StripKernels<ushort>& shortKernels();
const BundleKernels& kernelsOfBundles();

#ifndef CV_CPU_OPTIMIZATION_DECLARATIONS_ONLY

namespace {

#if LINESPACE_SIMD

//! Entries of a vector.
template<class Votes>
inline int lanes()
{
    return CV_SIMD_WIDTH / (int)sizeof(Votes);
}

template<class Votes>
inline decltype(vx_load((const Votes*)0)) sumOfFour(const Votes* const* columns, int y)
{
    return v_add_wrap(v_add_wrap(vx_load(columns[0] + y), vx_load(columns[1] + y)),
                      v_add_wrap(vx_load(columns[2] + y), vx_load(columns[3] + y)));
}

template<class Votes>
void addColumns(const Votes* const* columns, const int* offsets, int count, int t, int across,
                const StripRows<Votes>& out)
{
    CV_DbgAssert(count == 4 || count == 8);
    Votes* const row = out.row(t);
    const Votes* pixels[8];
    for (int i = 0; i < count; ++i)
        pixels[i] = columns[i] + offsets[i];
    const int end = out.end(t, across);
    if (count == 4)
        for (int y = out.first(t); y < end; y += lanes<Votes>())
            v_store(row + y, sumOfFour(pixels, y));
    else
        for (int y = out.first(t); y < end; y += lanes<Votes>())
            v_store(row + y, v_add_wrap(sumOfFour(pixels, y), sumOfFour(pixels + 4, y)));
}

template<class Votes>
void mergeStrips(const StripRows<Votes>& a, const StripRows<Votes>& b, int across,
                 const StripRows<Votes>& out)
{
    for (int t = -out.reach; t <= out.reach; ++t)
    {
        const int left = (t + 1) >> 1;
        const Votes *const first = a.row(left), *const second = b.row(t - left) + left;
        Votes* const row = out.row(t);
        for (int y = out.first(t); y < out.end(t, across); y += lanes<Votes>())
            v_store(row + y, v_add_wrap(vx_load(first + y), vx_load(second + y)));
    }
}

//! The larger one of two neighbours each, in the lower halves.
inline v_uint16 pairMaxima(const v_uint8& bytes)
{
    const v_uint16 pairs = v_reinterpret_as_u16(bytes);
    return v_and(v_reinterpret_as_u16(v_max(bytes, v_reinterpret_as_u8(v_shr<8>(pairs)))),
                 vx_setall_u16(255));
}
inline v_uint32 pairMaxima(const v_uint16& shorts)
{
    const v_uint32 pairs = v_reinterpret_as_u32(shorts);
    return v_and(v_reinterpret_as_u32(v_max(shorts, v_reinterpret_as_u16(v_shr<16>(pairs)))),
                 vx_setall_u32(65535));
}

//! The most votes of the 4 x 4 chords of as many bundles as a vector of v_uint32 has entries.
template<class Votes>
inline decltype(vx_load((const Votes*)0)) mostOfRows(const Votes* const* rows, int y)
{
    return v_max(v_max(vx_load(rows[0] + y), vx_load(rows[1] + y)),
                 v_max(vx_load(rows[2] + y), vx_load(rows[3] + y)));
}
inline v_uint32 mostOfBundles(const uchar* const* rows, int y)
{
    return pairMaxima(pairMaxima(mostOfRows(rows, y)));
}
inline v_uint32 mostOfBundles(const ushort* const* rows, int y)
{
    const v_uint32 low = pairMaxima(mostOfRows(rows, y)),
                   high = pairMaxima(mostOfRows(rows, y + lanes<ushort>()));
    // Sums are at most 64 x 255, so the units fit into bytes.
    const v_uint16 units = v_shr<6>(v_add_wrap(v_pack(low, high), vx_setall_u16(63)));
    return pairMaxima(units);
}

template<class Votes>
void poolStrip(const StripRows<Votes>& chords, const LeafRows& out)
{
    const BundleGrid& grid = out.grid;
    const int quads = CV_SIMD_WIDTH / (int)sizeof(int);
    for (int T = -grid.reach; T < grid.reach; ++T)
    {
        uchar* const row = out.row(T);
        const Votes* rows[4];
        for (int i = 0; i < 4; ++i)
            rows[i] = chords.row(4 * T + i);
        for (int Y = grid.first(T); Y < grid.end(T); Y += CV_SIMD_WIDTH)
        {
            const v_uint16 low = v_pack(mostOfBundles(rows, 4 * Y),
                                        mostOfBundles(rows, 4 * (Y + quads))),
                           high = v_pack(mostOfBundles(rows, 4 * (Y + 2 * quads)),
                                         mostOfBundles(rows, 4 * (Y + 3 * quads)));
            v_store(row + Y, v_pack(low, high));
        }
    }
}

void widenLeaf(const LeafRows& from, const NodeRows& out)
{
    const BundleGrid& grid = out.grid;
    for (int T = -grid.reach; T < grid.reach; ++T)
    {
        const uchar* const leaf = from.row(T);
        ushort* const row = out.row(T);
        for (int Y = grid.first(T); Y < grid.end(T); Y += CV_SIMD_WIDTH / 2)
            v_store(row + Y, vx_load_expand(leaf + Y));
    }
}

void mergeBundles(const NodeRows& a, int nA, const NodeRows& b, int nB, const NodeRows& out)
{
    const int width = CV_SIMD_WIDTH / 2, n = nA + nB;
    for (int T = -out.grid.reach; T < out.grid.reach; ++T)
    {
        const int middle = (2 * T + 1) * nA, left = (int)floorDiv(middle, 2 * n),
                  right = (int)floorDiv((2 * T + 1) * nB, 2 * n),
                  crossing = (int)floorDiv(n + middle, 2 * n);
        const int first = out.grid.first(T), end = out.grid.end(T);
        ushort* const row = out.row(T);
        for (int Y = first; Y < end; Y += width)
            v_store(row + Y, vx_setzero_u16());
        const ushort* const rowA = a.row(left);
        const int endA = std::min(end, a.grid.end(left));
        for (int Y = std::max(first, a.grid.first(left)); Y < endA; Y += width)
            v_store(row + Y, vx_load(rowA + Y));
        const ushort* const rowB = b.row(right) + crossing;
        const int endB = std::min(end, b.grid.end(right) - crossing);
        for (int Y = std::max(first, b.grid.first(right) - crossing - 1); Y < endB; Y += width)
            v_store(row + Y,
                    v_add_wrap(vx_load(row + Y), v_max(vx_load(rowB + Y), vx_load(rowB + Y + 1))));
    }
}

void poolBundles(const NodeRows& from, const NodeRows& out)
{
    for (int T = -out.grid.reach; T < out.grid.reach; ++T)
    {
        const ushort *const even = from.row(2 * T), *const odd = from.row(2 * T + 1);
        ushort* const row = out.row(T);
        for (int Y = out.grid.first(T); Y < out.grid.end(T); Y += CV_SIMD_WIDTH / 2)
        {
            const int y = 2 * Y, next = y + CV_SIMD_WIDTH / 2;
            v_store(row + Y, v_pack(pairMaxima(v_max(vx_load(even + y), vx_load(odd + y))),
                                    pairMaxima(v_max(vx_load(even + next), vx_load(odd + next)))));
        }
    }
}

void addLeaves(const uchar* leaves, const int* offsets, int first, int last, ushort* sums)
{
    v_uint16x8 low = v_setzero_u16(), high = low;
    for (int i = first; i < last; ++i)
    {
        const uchar* const row = leaves + offsets[i];
        v_uint16x8 a, b;
        v_expand(v_max(v_load(row), v_load(row + 1)), a, b);
        low = v_add_wrap(low, a);
        high = v_add_wrap(high, b);
    }
    v_store(sums, low);
    v_store(sums + 8, high);
}

void addChords(const uchar* tables, const int* offsets, int first, int last, int* sums)
{
    v_uint16x8 low = v_setzero_u16(), high = low; // strips of 64 votes each: 1024 fit
    for (int i = first; i < last; ++i)
    {
        v_uint16x8 a, b;
        v_expand(v_load(tables + offsets[i]), a, b);
        low = v_add_wrap(low, a);
        high = v_add_wrap(high, b);
    }
    v_uint32x4 wide[4];
    v_expand(low, wide[0], wide[1]);
    v_expand(high, wide[2], wide[3]);
    for (int k = 0; k < 4; ++k)
        v_store(sums + 4 * k, v_reinterpret_as_s32(wide[k]));
}

void addChords(const ushort* tables, const int* offsets, int first, int last, int* sums)
{
    v_uint32x4 all[4];
    for (int k = 0; k < 4; ++k)
        all[k] = v_setzero_u32();
    for (int i = first; i < last; ++i)
        for (int half = 0; half < 2; ++half)
        {
            v_uint32x4 a, b;
            v_expand(v_load(tables + offsets[i] + 8 * half), a, b);
            all[2 * half] = v_add(all[2 * half], a);
            all[2 * half + 1] = v_add(all[2 * half + 1], b);
        }
    for (int k = 0; k < 4; ++k)
        v_store(sums + 4 * k, v_reinterpret_as_s32(all[k]));
}

#else

using namespace generic;

#endif

} // namespace

const StripKernels<uchar>& byteKernels()
{
    static const StripKernels<uchar> kernels = {addColumns<uchar>, mergeStrips<uchar>,
                                                poolStrip<uchar>, addChords};
    return kernels;
}

const StripKernels<ushort>& shortKernels()
{
    static const StripKernels<ushort> kernels = {addColumns<ushort>, mergeStrips<ushort>,
                                                 poolStrip<ushort>, addChords};
    return kernels;
}

const BundleKernels& kernelsOfBundles()
{
    static const BundleKernels kernels = {widenLeaf, mergeBundles, poolBundles, addLeaves};
    return kernels;
}

#endif // CV_CPU_OPTIMIZATION_DECLARATIONS_ONLY

CV_CPU_OPTIMIZATION_NAMESPACE_END

} // namespace linespace
} // namespace cv
