// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The CPU path: the stages cut into tasks for cv::parallel_for_, with inner loops dispatched once
// per task to the best instruction set (cascade.simd.hpp). Tasks write disjoint parts of a table
// and read what no task writes, so the result does not depend on the number of threads.

#include "chord_counter.hpp"
#include "stages.hpp"

#include "cascade.simd.hpp"
#include "cascade.simd_declarations.hpp"

namespace cv {
namespace linespace {

namespace {

void addPlanes(const uchar* const* planes, int count, size_t cells, void* votes, int depth)
{
    CV_CPU_DISPATCH(addPlanes, (planes, count, cells, votes, depth), CV_CPU_DISPATCH_MODES_ALL);
}

void choosePixels(const uchar* plane, const uchar* bits, uchar bit, size_t cells, uchar* chosen)
{
    CV_CPU_DISPATCH(choosePixels, (plane, bits, bit, cells, chosen), CV_CPU_DISPATCH_MODES_ALL);
}

void mergeRows(const Merge& merge, int firstRow, int lastRow, size_t cells, const void* child,
               int childDepth, void* parent, int parentDepth)
{
    CV_CPU_DISPATCH(mergeRows,
                    (merge, firstRow, lastRow, cells, child, childDepth, parent, parentDepth),
                    CV_CPU_DISPATCH_MODES_ALL);
}

void exactRow(const Cell& frame, int s, const ExactMaps& maps, void* votes, int depth)
{
    CV_CPU_DISPATCH(exactRow, (frame, s, maps, votes, depth), CV_CPU_DISPATCH_MODES_ALL);
}

//! Cells of level 0 that a task takes: their planes stay in a second-level cache.
size_t cellsPerTask(const Cell& cell)
{
    const size_t planes = (size_t)cell.width * cell.height;
    return std::max<size_t>(64, ((size_t)1 << 16) / planes);
}

const int FIRST_ROWS_PER_TASK = 4; // of level 0
const int ROWS_PER_TASK = 16;

int taskCount(size_t items, size_t itemsPerTask)
{
    return (int)((items + itemsPerTask - 1) / itemsPerTask);
}

class CpuExecutor : public Executor
{
public:
    int backend() const CV_OVERRIDE { return BACKEND_CPU; }

    void clear() CV_OVERRIDE
    {
        planes_.release();
        directionPlanes_.release();
        transposed_.release();
        directionsTransposed_.release();
        edgePlanes_.clear();
    }

    void firstCells(const EdgeMap& edges, const Plan& plan, VoteTable& table) CV_OVERRIDE
    {
        makePlanes(edges, plan);
        const Cell cell = plan.level(0).cell;
        const size_t perTask = cellsPerTask(cell);
        const int tasksOfCells = taskCount(table.cells, perTask);
        // The chords of one bin, or those of some rows.
        const std::vector<uchar> bins = edges.isOriented() ? binsOf(cell) : std::vector<uchar>();
        const int parts = edges.isOriented()
                              ? DIRECTION_BINS
                              : taskCount(cell.firstPoint(SIDE_LEFT), FIRST_ROWS_PER_TASK);
        parallel_for_(Range(0, tasksOfCells * parts),
                      [&](const Range& range)
                      {
                          Buffer chosen;
                          for (int task = range.start; task < range.end; ++task)
                          {
                              const size_t begin = task / parts * perTask;
                              const Range block((int)begin,
                                                (int)std::min(begin + perTask, table.cells));
                              if (edges.isOriented())
                                  countBin(cell, bins, task % parts, block, chosen, table);
                              else
                                  countRows(cell, task % parts * FIRST_ROWS_PER_TASK, block, table);
                          }
                      });
    }

    void mergeCells(const Plan& plan, int level, const VoteTable& child,
                    VoteTable& parent) CV_OVERRIDE
    {
        const Merge merge = plan.merge(level);
        const int rows = merge.parent.firstPoint(SIDE_LEFT);
        parallel_for_(Range(0, taskCount(rows, ROWS_PER_TASK)),
                      [&](const Range& range)
                      {
                          mergeRows(merge, range.start * ROWS_PER_TASK,
                                    std::min(rows, range.end * ROWS_PER_TASK), parent.cells,
                                    child.buffer.data(), child.depth, parent.buffer.data(),
                                    parent.depth);
                      });
    }

    void exactVotes(const EdgeMap& edges, const Plan& plan, VoteTable& table) CV_OVERRIDE
    {
        const Cell frame = plan.frame();
        ExactMaps maps = {edges.votes.data, transposed<uchar>(edges.votes, transposed_), 0, 0};
        if (edges.isOriented())
        {
            maps.bits = edges.directions.ptr<ushort>();
            maps.bitsTransposed = transposed<ushort>(edges.directions, directionsTransposed_);
        }
        parallel_for_(Range(0, frame.firstPoint(SIDE_LEFT)),
                      [&](const Range& range)
                      {
                          for (int s = range.start; s < range.end; ++s)
                              exactRow(frame, s, maps,
                                       table.buffer.data() + frame.rowStart(s) * table.depth,
                                       table.depth);
                      });
    }

    void rescore(const EdgeMap& edges, const Plan& plan, const std::vector<Chord>& chords,
                 std::vector<int>& votes) CV_OVERRIDE
    {
        votes.resize(chords.size());
        edgePlanes_.reset(edges, plan.frame());
        const ChordCounter counter(edgePlanes_);
        const size_t perTask = 64;
        parallel_for_(Range(0, taskCount(chords.size(), perTask)),
                      [&](const Range& range)
                      {
                          const size_t end = std::min(chords.size(), range.end * perTask);
                          for (size_t i = range.start * perTask; i < end; ++i)
                              votes[i] = counter.votes(chords[i]);
                      });
    }

private:
    //! The bins of all chords of a cell, by their indices.
    static std::vector<uchar> binsOf(const Cell& cell)
    {
        std::vector<uchar> bins(cell.chordCount());
        for (int s = 0; s < cell.firstPoint(SIDE_LEFT); ++s)
            for (int e = cell.firstPartner(cell.sideOf(s)); e < cell.borderCount(); ++e)
            {
                const Chord chord = {s, e};
                bins[cell.chordIndex(s, e)] = (uchar)directionBin(cell, chord);
            }
        return bins;
    }

    //! The votes of the chords of one bin of level 0, of a block of cells.
    void countBin(const Cell& cell, const std::vector<uchar>& bins, int bin, const Range& block,
                  Buffer& chosen, VoteTable& table) const
    {
        // The pixels that vote for the bin, once for all its chords.
        const size_t cells = table.cells, planes = (size_t)cell.width * cell.height;
        chosen.allocate(planes * block.size());
        const uchar* own = planes_.data() + block.start;
        const uchar* bits = directionPlanes_.data() + bin / 8 * planes * cells + block.start;
        for (size_t i = 0; i < planes; ++i)
            choosePixels(own + i * cells, bits + i * cells, (uchar)(1 << bin % 8), block.size(),
                         chosen.data() + i * block.size());
        std::vector<const uchar*> pixels(std::max(cell.width, cell.height));
        for (int s = 0; s < cell.firstPoint(SIDE_LEFT); ++s)
            for (int e = cell.firstPartner(cell.sideOf(s)); e < cell.borderCount(); ++e)
                if (bins[cell.chordIndex(s, e)] == bin)
                {
                    const Chord chord = {s, e};
                    countChord(cell, chord, chosen.data(), block.size(), block, pixels, table);
                }
    }

    //! The votes of the chords of some rows of level 0, of a block of cells.
    void countRows(const Cell& cell, int first, const Range& block, VoteTable& table) const
    {
        std::vector<const uchar*> pixels(std::max(cell.width, cell.height));
        const int end = std::min(first + FIRST_ROWS_PER_TASK, cell.firstPoint(SIDE_LEFT));
        for (int s = first; s < end; ++s)
            for (int e = cell.firstPartner(cell.sideOf(s)); e < cell.borderCount(); ++e)
            {
                const Chord chord = {s, e};
                countChord(cell, chord, planes_.data() + block.start, table.cells, block, pixels,
                           table);
            }
    }

    //! @param planes the first plane of the block; the next one is `distance` bytes on.
    static void countChord(const Cell& cell, Chord chord, const uchar* planes, size_t distance,
                           const Range& block, std::vector<const uchar*>& pixels, VoteTable& table)
    {
        int n = 0;
        Raster(cell, chord)
            .forEachPixel([&](int x, int y)
                          { pixels[n++] = planes + ((size_t)y * cell.width + x) * distance; });
        addPlanes(pixels.data(), n, block.size(),
                  table.buffer.data() +
                      (cell.chordIndex(chord.s, chord.e) * table.cells + block.start) * table.depth,
                  table.depth);
    }

    /** Sorts the edge pixels by their place in the cell: plane y width + x holds pixel (x, y) of
    all cells, in the order of the table, so that one chord of all cells is a sum of whole planes.
    The directions' low bytes make as many planes again, the high bytes as many after these. */
    void makePlanes(const EdgeMap& edges, const Plan& plan)
    {
        const Level& level = plan.level(0);
        const size_t size = level.cellCount() * level.cell.width * level.cell.height;
        planes_.allocate(size);
        scatter<uchar>(edges.votes, plan, planes_.data(), [](uchar value) { return value; });
        if (!edges.isOriented())
            return;
        directionPlanes_.allocate(2 * size);
        scatter<ushort>(edges.directions, plan, directionPlanes_.data(),
                        [](ushort value) { return (uchar)(value & 0xFF); });
        scatter<ushort>(edges.directions, plan, directionPlanes_.data() + size,
                        [](ushort value) { return (uchar)(value >> 8); });
    }

    template<class Pixel, class ByteOf>
    static void scatter(const Mat& image, const Plan& plan, uchar* planes, ByteOf byteOf)
    {
        const Level& level = plan.level(0);
        const Cell cell = level.cell;
        const size_t cells = level.cellCount(), size = cells * cell.width * cell.height;
        if (level.grid.width * cell.width != image.cols ||
            level.grid.height * cell.height != image.rows)
            std::fill(planes, planes + size, (uchar)0);
        std::vector<int> rowBits, columnBits;
        plan.cellOrder(0, rowBits, columnBits);
        parallel_for_(Range(0, image.rows),
                      [&](const Range& range)
                      {
                          for (int y = range.start; y < range.end; ++y)
                          {
                              const Pixel* from = image.ptr<Pixel>(y);
                              const int row = y / cell.height, inner = y % cell.height;
                              for (int x = 0; x < cell.width; ++x)
                              {
                                  uchar* plane = planes + ((size_t)inner * cell.width + x) * cells +
                                                 rowBits[row];
                                  for (int column = 0, at = x; at < image.cols;
                                       ++column, at += cell.width)
                                      plane[columnBits[column]] = byteOf(from[at]);
                              }
                          }
                      });
    }

    template<class Pixel>
    static const Pixel* transposed(const Mat& image, Buffer& buffer)
    {
        buffer.allocate(image.total() * sizeof(Pixel));
        Mat result(image.cols, image.rows, image.type(), buffer.data());
        transpose(image, result);
        return result.ptr<Pixel>();
    }

    Buffer planes_, directionPlanes_, transposed_, directionsTransposed_;
    EdgePlanes edgePlanes_; // of rescore
};

} // namespace

Ptr<Executor> createCpuExecutor()
{
    return makePtr<CpuExecutor>();
}

} // namespace linespace
} // namespace cv
