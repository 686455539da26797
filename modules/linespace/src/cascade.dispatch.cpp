// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The CPU path: the stages cut into tasks for cv::parallel_for_, with inner loops dispatched once
// per task to the best instruction set (cascade.simd.hpp). Tasks write disjoint parts of a table
// and read what no task writes, so the result does not depend on the number of threads.

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

void mergeRows(const Merge& merge, int firstRow, int lastRow, size_t cells, const void* child,
               int childDepth, void* parent, int parentDepth)
{
    CV_CPU_DISPATCH(mergeRows,
                    (merge, firstRow, lastRow, cells, child, childDepth, parent, parentDepth),
                    CV_CPU_DISPATCH_MODES_ALL);
}

void exactRow(const Cell& frame, int s, const uchar* map, const uchar* transposed, void* votes,
              int depth)
{
    CV_CPU_DISPATCH(exactRow, (frame, s, map, transposed, votes, depth), CV_CPU_DISPATCH_MODES_ALL);
}

const size_t CELLS_PER_TASK =
    2048; // of level 0: the planes of so many cells stay in a second-level cache
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
        transposed_.release();
    }

    void firstCells(const EdgeMap& edges, const Plan& plan, VoteTable& table) CV_OVERRIDE
    {
        makePlanes(edges, plan);
        const Level& level = plan.level(0);
        const Cell cell = level.cell;
        const size_t cells = table.cells;
        const int rows = cell.firstPoint(SIDE_LEFT);
        const int cellTasks = taskCount(cells, CELLS_PER_TASK), rowTasks = taskCount(rows, 4);
        parallel_for_(
            Range(0, cellTasks * rowTasks),
            [&](const Range& range)
            {
                std::vector<const uchar*> pixels(std::max(cell.width, cell.height));
                for (int task = range.start; task < range.end; ++task)
                {
                    const size_t begin = task / rowTasks * CELLS_PER_TASK;
                    const size_t count = std::min(CELLS_PER_TASK, cells - begin);
                    const int firstRow = task % rowTasks * 4,
                              lastRow = std::min(rows, firstRow + 4);
                    for (int s = firstRow; s < lastRow; ++s)
                        for (int e = cell.firstPartner(cell.sideOf(s)); e < cell.borderCount(); ++e)
                        {
                            const Chord chord = {s, e};
                            int n = 0;
                            Raster(cell, chord)
                                .forEachPixel(
                                    [&](int x, int y) {
                                        pixels[n++] = planes_.data() +
                                                      ((size_t)y * cell.width + x) * cells + begin;
                                    });
                            const size_t first = cell.chordIndex(s, e) * cells + begin;
                            addPlanes(pixels.data(), n, count,
                                      table.buffer.data() + first * table.depth, table.depth);
                        }
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
        const size_t pixels = (size_t)frame.width * frame.height;
        transposed_.allocate(pixels);
        Mat transposed(frame.width, frame.height, CV_8UC1, transposed_.data());
        transpose(edges.votes, transposed);
        parallel_for_(Range(0, frame.firstPoint(SIDE_LEFT)),
                      [&](const Range& range)
                      {
                          for (int s = range.start; s < range.end; ++s)
                              exactRow(frame, s, edges.votes.data, transposed_.data(),
                                       table.buffer.data() + frame.rowStart(s) * table.depth,
                                       table.depth);
                      });
    }

    void rescore(const EdgeMap& edges, const Plan& plan, const std::vector<Chord>& chords,
                 std::vector<int>& votes) CV_OVERRIDE
    {
        votes.resize(chords.size());
        const size_t perTask = 64;
        parallel_for_(Range(0, taskCount(chords.size(), perTask)),
                      [&](const Range& range)
                      {
                          const size_t end = std::min(chords.size(), range.end * perTask);
                          for (size_t i = range.start * perTask; i < end; ++i)
                              votes[i] = chordVotes(edges, plan.frame(), chords[i]);
                      });
    }

private:
    /** Sorts the edge pixels by their place in the cell: plane y width + x holds pixel (x, y) of
    all cells, in the order of the table, so that one chord of all cells is a sum of whole planes.
    */
    void makePlanes(const EdgeMap& edges, const Plan& plan)
    {
        const Level& level = plan.level(0);
        const Cell cell = level.cell;
        const size_t cells = level.cellCount(), size = cells * cell.width * cell.height;
        planes_.allocate(size + VoteTable::PADDING);
        if (level.grid.width * cell.width != edges.votes.cols ||
            level.grid.height * cell.height != edges.votes.rows)
            std::fill(planes_.data(), planes_.data() + size, (uchar)0);
        std::vector<int> rowBits, columnBits;
        plan.cellOrder(0, rowBits, columnBits);
        parallel_for_(Range(0, edges.votes.rows),
                      [&](const Range& range)
                      {
                          for (int y = range.start; y < range.end; ++y)
                          {
                              const uchar* from = edges.votes.ptr<uchar>(y);
                              const int row = y / cell.height, inner = y % cell.height;
                              for (int x = 0; x < cell.width; ++x)
                              {
                                  uchar* plane = planes_.data() +
                                                 ((size_t)inner * cell.width + x) * cells +
                                                 rowBits[row];
                                  for (int column = 0, at = x; at < edges.votes.cols;
                                       ++column, at += cell.width)
                                      plane[columnBits[column]] = from[at];
                              }
                          }
                      });
    }

    Buffer planes_, transposed_;
};

} // namespace

Ptr<Executor> createCpuExecutor()
{
    return makePtr<CpuExecutor>();
}

} // namespace linespace
} // namespace cv
