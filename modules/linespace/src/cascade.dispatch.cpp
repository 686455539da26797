// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The CPU path: the stages cut into tasks for cv::parallel_for_, with inner loops dispatched once
// per task to the best instruction set (cascade.simd.hpp). Tasks write disjoint parts of a table
// and read what no task writes, so the result does not depend on the number of threads.

#include "cell_chords.hpp"
#include "chord_counter.hpp"
#include "stages.hpp"

#include "cascade.simd.hpp"
#include "cascade.simd_declarations.hpp"

#include <atomic>

namespace cv {
namespace linespace {

namespace {

void gatherPixels(const uchar* row, int width, const size_t* offsets, size_t cells, uchar* planes)
{
    CV_CPU_DISPATCH(gatherPixels, (row, width, offsets, cells, planes), CV_CPU_DISPATCH_MODES_ALL);
}

void gatherDirections(const ushort* pixel, const size_t* offsets, size_t cells, uchar* low,
                      uchar* high)
{
    CV_CPU_DISPATCH(gatherDirections, (pixel, offsets, cells, low, high),
                    CV_CPU_DISPATCH_MODES_ALL);
}

void choosePixels(const uchar* pixels, const uchar* bits, uchar bit, size_t count, uchar* chosen)
{
    CV_CPU_DISPATCH(choosePixels, (pixels, bits, bit, count, chosen), CV_CPU_DISPATCH_MODES_ALL);
}

void addPlanes(const uchar* planes, const ushort* pixels, int count, size_t cells, void* votes,
               int depth)
{
    CV_CPU_DISPATCH(addPlanes, (planes, pixels, count, cells, votes, depth),
                    CV_CPU_DISPATCH_MODES_ALL);
}

void mergeRows(const Merge& merge, int firstRow, int lastRow, size_t cells, const void* child,
               int childDepth, void* parent, int parentDepth)
{
    CV_CPU_DISPATCH(mergeRows,
                    (merge, firstRow, lastRow, cells, child, childDepth, parent, parentDepth),
                    CV_CPU_DISPATCH_MODES_ALL);
}

bool mergeRowsNarrow(const Merge& merge, int firstRow, int lastRow, size_t cells,
                     const uchar* child, uchar* parent)
{
    CV_CPU_DISPATCH(mergeRowsNarrow, (merge, firstRow, lastRow, cells, child, parent),
                    CV_CPU_DISPATCH_MODES_ALL);
}

void exactRow(const Cell& frame, int s, const ExactMaps& maps, void* votes, int depth)
{
    CV_CPU_DISPATCH(exactRow, (frame, s, maps, votes, depth), CV_CPU_DISPATCH_MODES_ALL);
}

//! Cells of level 0 that are counted together: their pixels stay in a second-level cache, and many
//! threads have work.
size_t cellsPerTask(const Level& level)
{
    const size_t pixels = (size_t)level.cell.width * level.cell.height;
    size_t cells = 64;
    while (2 * cells * pixels <= ((size_t)1 << 16) && 16 * cells <= level.cellCount())
        cells *= 2;
    return cells;
}

const int ROWS_PER_TASK = 16;

int taskCount(size_t items, size_t itemsPerTask)
{
    return (int)((items + itemsPerTask - 1) / itemsPerTask);
}

class CpuExecutor : public Executor
{
public:
    int backend() const CV_OVERRIDE { return BACKEND_CPU; }

    void firstCells(const EdgeMap& edges, const Plan& plan, VoteTable& table) CV_OVERRIDE
    {
        const Cell cell = plan.level(0).cell;
        chords_.reset(cell, edges.isOriented());
        const Mat votes = framed(edges.votes, plan.frame(), frame_),
                  directions = framed(edges.directions, plan.frame(), directionFrame_);
        listOffsets(plan, votes.step1());
        const size_t perTask = cellsPerTask(plan.level(0));
        parallel_for_(Range(0, taskCount(table.cells, perTask)),
                      [&](const Range& range)
                      {
                          FirstCells cells;
                          for (int task = range.start; task < range.end; ++task)
                          {
                              const size_t begin = task * perTask;
                              cells.block =
                                  Range((int)begin, (int)std::min(begin + perTask, table.cells));
                              gather(votes, directions, cell, cells);
                              countBlock(cell, edges.isOriented(), cells, table);
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

    bool mergeCellsNarrow(const Plan& plan, int level, const VoteTable& child,
                          VoteTable& parent) CV_OVERRIDE
    {
        if (parent.cells % 8 != 0)
            return false;
        const Merge merge = plan.merge(level);
        const int rows = merge.parent.firstPoint(SIDE_LEFT);
        std::atomic<bool> fits(true);
        parallel_for_(Range(0, taskCount(rows, ROWS_PER_TASK)),
                      [&](const Range& range)
                      {
                          if (fits && !mergeRowsNarrow(merge, range.start * ROWS_PER_TASK,
                                                       std::min(rows, range.end * ROWS_PER_TASK),
                                                       parent.cells, child.ptr<uchar>(),
                                                       parent.ptr<uchar>()))
                              fits = false;
                      });
        return fits;
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
    /** Some cells of level 0, and their pixels sorted by their place in the cell: plane y width + x
    holds pixel (x, y) of all of them, so that one chord of all cells is a sum of whole planes. The
    low and the high bytes of the directions make as many planes each. */
    struct FirstCells
    {
        Range block;
        Buffer pixels, low, high, chosen;
    };

    //! An image with zeros up to the frame; the image itself if that is as large.
    static Mat framed(const Mat& image, const Cell& frame, Mat& buffer)
    {
        if (image.empty() || (image.cols == frame.width && image.rows == frame.height))
            return image;
        copyMakeBorder(image, buffer, 0, frame.height - image.rows, 0, frame.width - image.cols,
                       BORDER_CONSTANT);
        return buffer;
    }

    //! Where the cells of level 0 begin, in the order of the table.
    void listOffsets(const Plan& plan, size_t stride)
    {
        const Level& level = plan.level(0);
        std::vector<int> rowBits, columnBits;
        plan.cellOrder(0, rowBits, columnBits);
        offsets_.resize(level.cellCount());
        for (int row = 0; row < level.grid.height; ++row)
            for (int column = 0; column < level.grid.width; ++column)
                offsets_[rowBits[row] + columnBits[column]] =
                    row * level.cell.height * stride + column * level.cell.width;
    }

    void gather(const Mat& votes, const Mat& directions, const Cell& cell, FirstCells& cells) const
    {
        const size_t count = cells.block.size(), size = count * cell.width * cell.height;
        const size_t* const offsets = &offsets_[cells.block.start];
        cells.pixels.allocate(size);
        if (!directions.empty())
        {
            cells.low.allocate(size);
            cells.high.allocate(size);
            cells.chosen.allocate(size);
        }
        for (int y = 0, plane = 0; y < cell.height; ++y)
        {
            gatherPixels(votes.ptr<uchar>(y), cell.width, offsets, count,
                         cells.pixels.data() + plane * count);
            for (int x = 0; x < cell.width; ++x, ++plane)
                if (!directions.empty())
                    gatherDirections(directions.ptr<ushort>(y) + x, offsets, count,
                                     cells.low.data() + plane * count,
                                     cells.high.data() + plane * count);
        }
    }

    void countBlock(const Cell& cell, bool isOriented, const FirstCells& cells,
                    VoteTable& table) const
    {
        const size_t count = cells.block.size();
        std::vector<ushort> buffer(chords_.longest() + 1);
        const uchar* voting = cells.pixels.data();
        int bin = -1;
        for (size_t i = 0; i < chords_.count(); ++i)
        {
            if (isOriented && chords_.binOf(i) != bin)
            {
                // The pixels that vote for the bin, once for all its chords.
                bin = chords_.binOf(i);
                choosePixels(cells.pixels.data(), (bin < 8 ? cells.low : cells.high).data(),
                             (uchar)(1 << bin % 8), count * cell.width * cell.height,
                             cells.chosen.data());
                voting = cells.chosen.data();
            }
            int pixelCount = 0;
            const ushort* pixels = chords_.pixels(i, buffer.data(), pixelCount);
            addPlanes(voting, pixels, pixelCount, count,
                      table.buffer.data() +
                          (chords_.indexOf(i) * table.cells + cells.block.start) * table.depth,
                      table.depth);
        }
    }

    template<class Pixel>
    static const Pixel* transposed(const Mat& image, Buffer& buffer)
    {
        buffer.allocate(image.total() * sizeof(Pixel));
        Mat result(image.cols, image.rows, image.type(), buffer.data());
        transpose(image, result);
        return result.ptr<Pixel>();
    }

    CellChords chords_;
    Mat frame_, directionFrame_; // the edge map where the frame is larger
    std::vector<size_t> offsets_;
    Buffer transposed_, directionsTransposed_;
    EdgePlanes edgePlanes_; // of rescore
};

} // namespace

Ptr<Executor> createCpuExecutor()
{
    return makePtr<CpuExecutor>();
}

} // namespace linespace
} // namespace cv
