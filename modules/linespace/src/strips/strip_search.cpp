// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "strip_search.hpp"

#include "../orientation.hpp"

namespace cv {
namespace linespace {

namespace {

//! Rows a power of two apart share the lines of a cache.
ptrdiff_t strideFor(ptrdiff_t entries, int entryBytes)
{
    const ptrdiff_t line = 64 / entryBytes, stride = (entries + line - 1) / line * line;
    return stride * entryBytes % 1024 == 0 ? stride + line : stride;
}

//! Where a chord of a narrow strip has its pixels: the crossings of its halves, rounded as in every
//! merge, down to single columns.
void pixelOffsets(int columns, int t, int start, int* offsets)
{
    if (columns == 1)
    {
        *offsets = start + (t == 1);
        return;
    }
    const int half = columns / 2, left = (int)floorDiv(t + 1, 2);
    pixelOffsets(half, left, start, offsets);
    pixelOffsets(half, t - left, start + left, offsets + half);
}

//! Keeps the entries with the most votes: all above a number of votes, and of those that have this
//! number as many as there is room for, evenly spread in the order given.
void keepMost(std::vector<Bundle>& entries, size_t most)
{
    if (entries.size() <= most)
        return;
    int strongest = 0;
    for (size_t i = 0; i < entries.size(); ++i)
        strongest = std::max(strongest, entries[i].votes);
    std::vector<size_t> counts(strongest + 1, 0);
    for (size_t i = 0; i < entries.size(); ++i)
        ++counts[entries[i].votes];
    size_t above = 0;
    int cut = strongest;
    while (above + counts[cut] <= most)
        above += counts[cut--];
    const uint64 tied = counts[cut], room = most - above;
    size_t kept = 0;
    uint64 passed = 0;
    for (size_t i = 0; i < entries.size(); ++i)
    {
        bool isTaken = entries[i].votes > cut;
        if (entries[i].votes == cut)
        {
            isTaken = (passed + 1) * room / tied != passed * room / tied;
            ++passed;
        }
        if (isTaken)
            entries[kept++] = entries[i];
    }
    entries.resize(kept);
}

//! The bin of the parts of a chord, of which a strip of so many columns has one.
int binOf(const StripFamily& family, int columns, int t)
{
    return family.xMajor ? directionBin(columns, t) : directionBin(t, columns);
}

//! The entries that StripSearch::build uses, the result included.
size_t nodeMemory(const StripFamily& family, int strips, int side)
{
    const auto sizeOf = [&](int n, int s)
    {
        return NodeRows::sizeOf(BundleGrid(family, n, s));
    };
    const size_t own = sizeOf(strips, side);
    size_t rest = 0;
    int from = LEAF_BUNDLE;
    if (strips > 1)
    {
        const int left = (strips + 1) / 2, right = strips - left;
        from = std::min(side, bundleSide(left));
        rest = std::max(nodeMemory(family, left, from),
                        sizeOf(left, from) + nodeMemory(family, right, from));
        rest = std::max(rest, sizeOf(left, from) + sizeOf(right, from));
        for (int s = from; s < side; s *= 2)
            rest += sizeOf(strips, s);
    }
    else
        for (int s = from; s < side; s *= 2)
            rest += sizeOf(1, s);
    return own + rest;
}

//! Entries of a node, all 0.
NodeRows makeNode(const StripFamily& family, int strips, int side, ushort*& memory)
{
    NodeRows rows;
    const BundleGrid grid(family, strips, side);
    const size_t size = NodeRows::sizeOf(grid);
    std::memset(memory, 0, size * sizeof(ushort));
    rows.layOut(grid, memory);
    memory += size;
    return rows;
}

} // namespace

template<class Votes>
void StripSearch<Votes>::clear()
{
    image_ = Size();
    for (int k = 0; k < 2; ++k)
    {
        tables_[k].kept.release();
        tables_[k].leaves.release();
        tables_[k].nodes.release();
        std::vector<int>().swap(tables_[k].chordOffsets);
        std::vector<int>().swap(tables_[k].leafOffsets);
        std::vector<ushort>().swap(tables_[k].visible);
    }
    std::vector<Bundle>().swap(bundles_);
    std::vector<Bundle>().swap(split_);
    std::vector<StripChord>().swap(chords_);
}

template<class Votes>
double StripSearch<Votes>::memory(Size image)
{
    double bytes = 0;
    for (int k = 0; k < 2; ++k)
    {
        const StripFamily family(image, k == 0);
        const double n = family.strips, width = n * STRIP;
        const double stride = (double)strideFor(
            KEPT_BEFORE + (ptrdiff_t)family.across + STRIP + KEPT_BEHIND, sizeof(Votes));
        bytes += n * (2 * STRIP + 1) * stride * sizeof(Votes); // kept
        bytes += n * LeafRows::sizeOf(BundleGrid(family, 1, LEAF_BUNDLE));
        bytes += (2 * width + 1) * n * sizeof(int) * (1 + 1. / LEAF_BUNDLE); // offsets
        bytes += width * family.across / 4;                                  // nodes, about
    }
    return bytes;
}

template<class Votes>
void StripSearch<Votes>::reset(Size image)
{
    if (image == image_)
        return;
    image_ = Size();
    for (int k = 0; k < 2; ++k)
        resetFamily(tables_[k], StripFamily(image, k == 0));
    // Bundles of both families compete, so that they have one size.
    side_ = bundleSide(std::max(tables_[0].family.strips, tables_[1].family.strips));
    for (int k = 0; k < 2; ++k)
    {
        Tables& tables = tables_[k];
        tables.nodes.allocate(nodeMemory(tables.family, tables.family.strips, side_) *
                              sizeof(ushort));
        tables.visible.clear();
    }
    image_ = image;
}

template<class Votes>
void StripSearch<Votes>::resetFamily(Tables& tables, const StripFamily& family)
{
    tables.family = family;
    const int n = family.strips, width = family.width();
    const ptrdiff_t stride =
        strideFor(KEPT_BEFORE + family.across + STRIP + KEPT_BEHIND, sizeof(Votes));
    const size_t table = (2 * STRIP + 1) * stride, kept = n * table + KEPT_BEHIND;
    tables.kept.allocate(kept * sizeof(Votes));
    std::memset(tables.kept.data(), 0, kept * sizeof(Votes));
    const BundleGrid grid(family, 1, LEAF_BUNDLE);
    const size_t leaf = LeafRows::sizeOf(grid);
    tables.leaves.allocate(n * leaf);
    std::memset(tables.leaves.data(), 0, n * leaf);
    tables.strips.resize(n);
    tables.leafRows.resize(n);
    for (int i = 0; i < n; ++i)
    {
        tables.strips[i].data = (Votes*)tables.kept.data() + i * table + KEPT_BEFORE;
        tables.strips[i].stride = stride;
        tables.strips[i].reach = STRIP;
        tables.leafRows[i].layOut(grid, tables.leaves.data() + i * leaf);
    }
    tables.chordOffsets.resize((size_t)(2 * width + 1) * n);
    int* offset = tables.chordOffsets.data();
    for (int t = -width; t <= width; ++t)
        for (int i = 0, from = 0; i < n; ++i)
        {
            const int to = family.crossing(t, i + 1);
            *offset++ = (int)(tables.strips[i].row(to - from) + from - (Votes*)tables.kept.data());
            from = to;
        }
    const int reach = n * grid.reach;
    tables.leafOffsets.resize((size_t)2 * reach * n);
    offset = tables.leafOffsets.data();
    for (int T = -reach; T < reach; ++T)
    {
        const int leafT = (int)floorDiv(2 * T + 1, 2 * n);
        for (int i = 0; i < n; ++i)
            *offset++ = (int)(tables.leafRows[i].row(leafT) - tables.leaves.data()) +
                        (int)floorDiv((int64)(2 * T + 1) * i, 2 * n);
    }
}

template<class Votes>
void StripSearch<Votes>::resetScratch(Scratch& scratch, int across) const
{
    const ptrdiff_t stride = strideFor(ROW_BEFORE + across + STRIP / 2 + ROW_BEHIND, sizeof(Votes));
    size_t rows = 8;
    for (int level = 0; level < 4; ++level)
        rows += 2 * (2 * (4 << level) + 1);
    const size_t bytes = (rows * stride + ROW_BEHIND) * sizeof(Votes);
    scratch.buffer.allocate(bytes);
    std::memset(scratch.buffer.data(), 0, bytes);
    Votes* memory = (Votes*)scratch.buffer.data() + ROW_BEFORE;
    for (int i = 0; i < 8; ++i, memory += stride)
        scratch.columns[i] = memory;
    for (int level = 0; level < 4; ++level)
        for (int half = 0; half < 2; ++half)
        {
            StripRows<Votes>& strip = scratch.rows[level][half];
            strip.data = memory;
            strip.stride = stride;
            strip.reach = 4 << level;
            memory += (2 * strip.reach + 1) * stride;
        }
}

//! The votes of a run of columns: 4 of a map that is not oriented, else 8, by their pixels; more by
//! those of the halves.
template<class Votes>
void StripSearch<Votes>::countColumns(const EdgePlanes& planes, const StripFamily& family,
                                      int first, int columns, const StripKernels<Votes>& kernels,
                                      Scratch& scratch, const StripRows<Votes>& out) const
{
    const int across = family.across;
    if (columns > (planes.isOriented() ? 8 : 4))
    {
        int level = 0;
        while (8 << level < columns)
            ++level;
        const StripRows<Votes>&a = scratch.rows[level][0], &b = scratch.rows[level][1];
        countColumns(planes, family, first, columns / 2, kernels, scratch, a);
        countColumns(planes, family, first + columns / 2, columns / 2, kernels, scratch, b);
        kernels.mergeStrips(a, b, across, out);
        return;
    }
    const EdgePlanes::Plane* const all = planes.across(family.xMajor);
    int bin = -1;
    for (int t = -columns; t <= columns; ++t)
    {
        const int own = planes.isOriented() ? binOf(family, columns, t) : 0;
        for (int i = 0; own != bin && i < columns; ++i)
        {
            Votes* const pixels = scratch.columns[i];
            if (first + i >= family.length)
            {
                std::fill(pixels, pixels + across, (Votes)0);
                continue;
            }
            const uchar* const votes =
                planes.has(EdgePlanes::VOTES) ? all[EdgePlanes::VOTES].row(first + i) : 0;
            if (!planes.isOriented())
            {
                std::copy(votes, votes + across, pixels);
                continue;
            }
            const uchar* const bits = all[EdgePlanes::planeOf(own)].row(first + i);
            const uchar bit = EdgePlanes::bitOf(own);
            if (votes)
                for (int y = 0; y < across; ++y)
                    pixels[y] = (Votes)(bits[y] & bit ? votes[y] : 0);
            else
                for (int y = 0; y < across; ++y)
                    pixels[y] = (Votes)((bits[y] & bit) != 0);
        }
        bin = own;
        int offsets[8];
        pixelOffsets(columns, t, 0, offsets);
        kernels.addColumns(scratch.columns, offsets, columns, t, across, out);
    }
}

template<class Votes>
void StripSearch<Votes>::countStrip(const EdgePlanes& planes, Tables& tables, int strip,
                                    const StripKernels<Votes>& kernels, Scratch& scratch) const
{
    countColumns(planes, tables.family, strip * STRIP, STRIP, kernels, scratch,
                 tables.strips[strip]);
    kernels.poolStrip(tables.strips[strip], tables.leafRows[strip]);
}

/** The bundles of a node. Its memory is at `memory` on entry, which is behind it on return; what is
needed on the way comes after that. */
template<class Votes>
NodeRows StripSearch<Votes>::build(Tables& tables, const BundleKernels& kernels, int first,
                                   int strips, int side, ushort*& memory) const
{
    const StripFamily& family = tables.family;
    ushort* result = memory;
    ushort* rest = memory + NodeRows::sizeOf(BundleGrid(family, strips, side));
    memory = rest;
    NodeRows rows;
    if (strips == 1)
    {
        rows = makeNode(family, 1, LEAF_BUNDLE, side == LEAF_BUNDLE ? result : rest);
        kernels.widenLeaf(tables.leafRows[first], rows);
    }
    else
    {
        const int left = (strips + 1) / 2, right = strips - left,
                  childSide = std::min(side, bundleSide(left));
        const NodeRows a = build(tables, kernels, first, left, childSide, rest),
                       b = build(tables, kernels, first + left, right, childSide, rest);
        rows = makeNode(family, strips, childSide, side == childSide ? result : rest);
        kernels.mergeBundles(a, left, b, right, rows);
    }
    while (rows.grid.side < side)
    {
        const int next = 2 * rows.grid.side;
        const NodeRows pooled = makeNode(family, strips, next, next == side ? result : rest);
        kernels.poolBundles(rows, pooled);
        rows = pooled;
    }
    return rows;
}

template<class Votes>
void StripSearch<Votes>::find(const EdgePlanes& planes, Size image, const StripRequest& request,
                              const StripKernels<Votes>& kernels, const BundleKernels& bundles,
                              std::vector<StripChord>& found)
{
    reset(image);
    const int n0 = tables_[0].family.strips, n1 = tables_[1].family.strips;
    parallel_for_(
        Range(0, n0 + n1),
        [&](const Range& range)
        {
            Scratch scratch;
            int last = -1;
            for (int i = range.start; i < range.end; ++i)
            {
                const int k = i >= n0;
                if (request.slopes[k].empty())
                    continue;
                if (k != last)
                    resetScratch(scratch, tables_[k].family.across);
                last = k;
                countStrip(planes, tables_[k], k ? i - n0 : i, kernels, scratch);
            }
        },
        4 * std::max(1, getNumThreads()));
    for (int k = 0; k < 2; ++k)
        if (!request.slopes[k].empty())
        {
            ushort* memory = (ushort*)tables_[k].nodes.data();
            tables_[k].frame =
                build(tables_[k], bundles, 0, tables_[k].family.strips, side_, memory);
        }
    selectBundles(request);
    splitBundles(request, bundles);
    chords_.clear();
    const int side = std::min<int>(side_, FINE_BUNDLE);
    for (size_t i = 0; i < bundles_.size(); ++i)
        addChordsOf(bundles_[i], side, request, kernels, chords_);
    // By votes.
    int most = 0;
    for (size_t i = 0; i < chords_.size(); ++i)
        most = std::max(most, chords_[i].votes);
    std::vector<size_t> starts(most + 2, 0);
    for (size_t i = 0; i < chords_.size(); ++i)
        ++starts[most - chords_[i].votes + 1];
    for (int k = 0; k <= most; ++k)
        starts[k + 1] += starts[k];
    found.resize(chords_.size());
    for (size_t i = 0; i < chords_.size(); ++i)
        found[starts[most - chords_[i].votes]++] = chords_[i];
}

template<class Votes>
void StripSearch<Votes>::findVisible(Tables& tables) const
{
    const BundleGrid& grid = tables.frame.grid;
    tables.visible.clear();
    for (int T = -grid.reach; T < grid.reach; ++T)
        for (int Y = grid.first(T); Y < grid.end(T); ++Y)
        {
            int fewest = tables.family.length;
            for (int corner = 0; corner < 4; ++corner)
                fewest = std::min(fewest, tables.family.visibleColumns(
                                              Y * grid.side + (corner & 1 ? grid.side - 1 : 0),
                                              T * grid.side + (corner & 2 ? grid.side - 1 : 0)));
            tables.visible.push_back((ushort)fewest);
        }
}

template<class Votes>
void StripSearch<Votes>::selectBundles(const StripRequest& request)
{
    bundles_.clear();
    // A bundle of so many units may hold a chord with more votes than the threshold.
    const int unit = voteUnit<Votes>(), threshold = request.threshold / unit;
    for (int k = 0; k < 2; ++k)
    {
        Tables& tables = tables_[k];
        if (request.slopes[k].empty())
            continue;
        const std::vector<int>& least = request.leastVotes[k];
        if (!least.empty() && tables.visible.empty())
            findVisible(tables);
        const NodeRows& frame = tables.frame;
        const int side = frame.grid.side / LEAF_BUNDLE;
        size_t index = 0;
        for (int T = -frame.grid.reach; T < frame.grid.reach; ++T)
        {
            const int first = frame.grid.first(T), end = frame.grid.end(T);
            const size_t row = index;
            index += end - first;
            if ((T + 1) * side <= request.slopes[k].start || T * side >= request.slopes[k].end)
                continue;
            const ushort* const votes = frame.row(T);
            for (int Y = first; Y < end; ++Y)
                if (votes[Y] > threshold &&
                    (least.empty() || votes[Y] * unit >= least[tables.visible[row + (Y - first)]]))
                {
                    const Bundle bundle = {votes[Y], k, T, Y};
                    bundles_.push_back(bundle);
                }
        }
    }
    keepMost(bundles_, request.bundles);
}

template<class Votes>
void StripSearch<Votes>::splitBundles(const StripRequest& request, const BundleKernels& kernels)
{
    if (side_ <= FINE_BUNDLE)
        return;
    split_.clear();
    for (size_t i = 0; i < bundles_.size(); ++i)
        addSubBundles(bundles_[i], kernels, request.threshold / voteUnit<Votes>(), split_);
    keepMost(split_, request.subBundles);
    bundles_.swap(split_);
}

//! The bundles of side FINE_BUNDLE in a larger one that have more votes than some.
template<class Votes>
void StripSearch<Votes>::addSubBundles(const Bundle& bundle, const BundleKernels& kernels,
                                       int threshold, std::vector<Bundle>& found) const
{
    const Tables& tables = tables_[bundle.family];
    const int n = tables.family.strips, leaves = side_ / LEAF_BUNDLE,
              reach = n * STRIP / LEAF_BUNDLE;
    const int firstT = bundle.T * leaves, firstY = bundle.Y * leaves;
    const BundleGrid& grid = tables.leafRows[0].grid;
    ushort votes[MOST_BUNDLE / LEAF_BUNDLE][16];
    for (int j = 0; j < leaves; ++j)
    {
        const int T = firstT + j, leafT = (int)floorDiv(2 * T + 1, 2 * n);
        // Where a strip's row of bundles begins, and ends with the next of the 16th.
        const auto isOutside = [&](int i)
        {
            const int Y = firstY + (int)floorDiv((int64)(2 * T + 1) * i, 2 * n);
            return Y + 16 < grid.first(leafT) || Y >= grid.end(leafT);
        };
        int from = 0, to = n;
        while (from < to && isOutside(from))
            ++from;
        while (from < to && isOutside(to - 1))
            --to;
        const int* const offsets = &tables.leafOffsets[(size_t)(T + reach) * n];
        kernels.addLeaves(tables.leaves.data() + firstY, offsets, from, to, votes[j]);
    }
    for (int j = 0; j < leaves; j += 2)
        for (int i = 0; i < leaves; i += 2)
        {
            const int most = std::max(std::max(votes[j][i], votes[j][i + 1]),
                                      std::max(votes[j + 1][i], votes[j + 1][i + 1]));
            if (most <= threshold)
                continue;
            // firstT and firstY are even.
            const Bundle sub = {most, bundle.family, (firstT + j) / 2, (firstY + i) / 2};
            found.push_back(sub);
        }
}

//! The strongest chord of each square of a bundle.
template<class Votes>
void StripSearch<Votes>::addChordsOf(const Bundle& bundle, int side, const StripRequest& request,
                                     const StripKernels<Votes>& kernels,
                                     std::vector<StripChord>& found) const
{
    const Tables& tables = tables_[bundle.family];
    const StripFamily& family = tables.family;
    const int n = family.strips, firstT = bundle.T * side, firstY = bundle.Y * side,
              lastY = firstY + 15;
    int votes[FINE_BUNDLE][16];
    for (int j = 0; j < side; ++j)
    {
        const int t = firstT + j;
        // The strips where one of the 16 chords from firstY on meets the image.
        int from = 0, to = n;
        if (std::min(firstY, firstY + t) < 0 || std::max(lastY, lastY + t) >= family.across)
        {
            const auto isOutside = [&](int i)
            {
                const int enters = family.crossing(t, i), leaves = family.crossing(t, i + 1);
                return lastY + std::max(enters, leaves) < 0 ||
                       firstY + std::min(enters, leaves) >= family.across;
            };
            while (from < to && isOutside(from))
                ++from;
            while (from < to && isOutside(to - 1))
                --to;
        }
        const int* const offsets = &tables.chordOffsets[(size_t)(t + family.width()) * n];
        kernels.addChords((const Votes*)tables.kept.data() + firstY, offsets, from, to, votes[j]);
    }
    const int square = request.square, threshold = request.threshold;
    for (int y = 0; y < side; y += square)
        for (int t = 0; t < side; t += square)
        {
            StripChord best = {threshold, bundle.family, 0, 0};
            for (int j = t; j < t + square; ++j)
                for (int i = y; i < y + square; ++i)
                    if (votes[j][i] > best.votes)
                    {
                        best.votes = votes[j][i];
                        best.t = firstT + j;
                        best.y = firstY + i;
                    }
            if (best.votes > threshold)
                found.push_back(best);
        }
}

template class StripSearch<uchar>;
template class StripSearch<ushort>;

} // namespace linespace
} // namespace cv
