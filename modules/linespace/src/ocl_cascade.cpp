// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "ocl_cascade.hpp"

#include <cvconfig.h>

#ifdef HAVE_OPENCL

#include "cell_chords.hpp"
#include "ocl_ascent.hpp"
#include "ocl_directions.hpp"
#include "ocl_houghlines.hpp"
#include "ocl_launch.hpp"
#include "ocl_maxima.hpp"
#include "ocl_pruning.hpp"
#include "ocl_segments.hpp"

#include <list>

namespace cv {
namespace linespace {

namespace {

//! As Segment in segments.cl.
struct DeviceSegment : RunOfChords
{
    DeviceCrossings crossings;
};

DeviceSegment deviceSegment(const Merge& merge, int s, const Segment& segment)
{
    DeviceSegment result;
    static_cast<RunOfChords&>(result) = runOfChords(segment);
    const CrossingRun run = // of nothing, if it does not cross
        segment.isCrossing ? CrossingRun(merge, s, segment.firstEnd) : CrossingRun();
    result.crossings = deviceCrossings(run, 1, segment.count);
    return result;
}

//! What the device needs to know of a level of the plan.
struct LevelTables
{
    bool isReady; //!< but for the next two
    bool knowsCells;
    UMat rowBits, columnBits; //!< Plan::cellOrder
    UMat segments, rows;
    int longestRow, rowCount;

    LevelTables() : isReady(false), knowsCells(false), longestRow(0), rowCount(0) {}
    void setSize(const std::vector<BorderRow>& borderRows)
    {
        rowCount = (int)borderRows.size();
        for (int s = 0; s < rowCount; ++s)
            longestRow = std::max(longestRow, borderRows[s].count);
        isReady = true;
    }
};

//! What is kept of a plan between calls.
struct PlanTables
{
    typedef Vec<int, 5> Key; //!< what tells plans apart
    Key key;
    bool knowsCells;
    UMat corners, pixels, starts, bins; //!< of cells and chords of level 0, if it does
    std::vector<LevelTables> levels;
    DevicePruning pruning;
    DeviceMaxima maxima;

    PlanTables() : knowsCells(false) {}
    static Key keyOf(const Plan& plan)
    {
        const Cell& cell = plan.level(0).cell;
        return Key(plan.imageSize().width, plan.imageSize().height, cell.width, cell.height,
                   plan.levelCount());
    }
};

class OpenClExecutor : public Executor
{
public:
    OpenClExecutor() : context_(ocl::Context::getDefault().ptr())
    {
        // Tables go there and back as they are in memory, masks of maxima are written by bytes and
        // read by words, and bytes of pixels become bits of a word (searchBlocks, packRows).
        const int one = 1;
        const bool isHostLittle = *reinterpret_cast<const uchar*>(&one) == 1;
        if (!isHostLittle || !ocl::Device::getDefault().endianLittle())
            throw DeviceFailure("the host or the device does not begin numbers with the low byte");
    }

    int backend() const CV_OVERRIDE { return BACKEND_OPENCL; }

    bool isUsable() const CV_OVERRIDE { return context_ == ocl::Context::getDefault().ptr(); }

    bool takesUMats() const CV_OVERRIDE { return true; }

    void end() CV_OVERRIDE { ascent_.reset(DevicePixels(), false, Cell()); }

    void allocate(const Level& level, int depth, VoteTable& table) CV_OVERRIDE
    {
        table.setShape(level, depth);
        if (table.chords > INT_MAX)
            throw DeviceFailure("the frame has too many chords for 32-bit numbers");
        allocateOn(table.device, table.bytes());
    }

    void firstCells(const EdgeMap& edges, const Plan& plan, VoteTable& table) CV_OVERRIDE
    {
        prepare(plan);
        const Level& level = plan.level(0);
        const int pixels = level.cell.width * level.cell.height, cells = (int)table.cells;
        if (!planTables().knowsCells)
            listCells(plan);
        const DevicePixels votes = takePixels(edges, plan);
        allocateOn(gathered_, (size_t)pixels * cells);
        const int together = (int)std::min<size_t>(table.cells, MOST_TOGETHER);
        const bool byPieces = isProcessor() && together == MOST_TOGETHER;
        Launch gather(CASCADE_PROGRAM, "gatherPixels",
                      format("-D FIRST_CELLS -D PARENT=uchar -D CELLS=%d", byPieces ? 16 : 1) +
                          votes.options);
        votes.giveTo(gather);
        gather.with(in(planTables().corners), cells, pixels, level.cell.width, out(gathered_));
        if (byPieces)
            gather.run(cells / together, (level.cell.width + 7) / 8 * level.cell.height);
        else
            gather.run(cells, pixels);
        if (edges.isOriented())
        {
            allocateOn(gatheredDirections_, (size_t)pixels * cells * sizeof(ushort));
            Launch(CASCADE_PROGRAM, "gatherDirections", "-D FIRST_CELLS -D PARENT=uchar -D CELLS=1")
                .with(ocl::KernelArg::ReadOnly(votes.directions), in(planTables().corners), cells,
                      pixels, level.cell.width, out(gatheredDirections_))
                .run(cells, pixels);
        }
        Launch first(
            CASCADE_PROGRAM, "firstCells",
            format("-D FIRST_CELLS -D PARENT=%s -D CELLS=%d", typeOf(table.depth), together) +
                (edges.isOriented() ? " -D ORIENTED" : ""));
        first.with(in(gathered_));
        if (edges.isOriented())
            first.with(in(gatheredDirections_), in(planTables().bins));
        first
            .with(in(planTables().pixels), in(planTables().starts), cells, (int)table.chords,
                  out(table.device))
            .run(cells / together, table.chords);
    }

    void mergeCells(const Plan& plan, int l, const VoteTable& child, VoteTable& parent) CV_OVERRIDE
    {
        prepare(plan);
        const LevelTables& level = rowsOfLevel(plan, l);
        const int together = (int)std::min<size_t>(parent.cells, MOST_TOGETHER);
        const int run = chordsPerItem();
        Launch(CASCADE_PROGRAM, "mergeCells",
               format("-D MERGE -D MAX_SEGMENTS=%d -D RUN=%d -D CHILD=%s -D PARENT=%s -D CELLS=%d",
                      MAX_SEGMENTS, run, typeOf(child.depth), typeOf(parent.depth), together))
            .with(in(level.segments), in(level.rows), level.rowCount, (int)parent.cells,
                  in(child.device), out(parent.device))
            .run((level.longestRow + run - 1) / run, level.rowCount, run > 1);
    }

    void exactVotes(const EdgeMap& edges, const Plan& plan, VoteTable& table) CV_OVERRIDE
    {
        prepare(plan);
        const Cell& frame = plan.frame();
        checkRasters(frame);
        LevelTables& level = planTables().levels[0];
        if (!level.isReady)
        {
            const std::vector<BorderRow> rows = rowsOf(frame);
            upload(rows, level.rows);
            level.setSize(rows);
        }
        const DevicePixels votes = takePixels(edges, plan);
        Launch launch(CASCADE_PROGRAM, "exactVotes",
                      format("-D EXACT -D PARENT=%s -D CELLS=1", typeOf(table.depth)) +
                          votes.options + votes.directionOptions());
        votes.giveTo(launch);
        votes.giveDirectionsTo(launch);
        launch.with(in(level.rows), level.rowCount, frame.width, frame.height, out(table.device))
            .run(level.longestRow, level.rowCount);
    }

    bool findMaxima(const EdgeMap& edges, const Plan& plan, const VoteTable& table,
                    const Wanted& wanted, int suppression, int radius, int ascentRadius,
                    std::vector<Candidate>& found, bool& areCounted) CV_OVERRIDE
    {
        planTables().maxima.find(edges, plan, table, wanted, suppression, radius, 0,
                                 counting(ascentRadius, areCounted), found);
        return true;
    }

    int levelForPruning(const Plan& plan, bool weighted) CV_OVERRIDE
    {
        prepare(plan);
        const int base = DevicePruning::baseLevel(plan, weighted);
        return base >= 0 && planTables().pruning.isWorthATry() ? base : -1;
    }

    bool findMaximaPruned(const EdgeMap& edges, const Plan& plan, int base, VoteTables& tables,
                          const Wanted& wanted, int radius, int ascentRadius,
                          std::vector<Candidate>& found, bool& areCounted) CV_OVERRIDE
    {
        prepare(plan);
        const VoteTable& whole = tables.of(base);
        std::vector<DevicePruning::Votes> above;
        for (int l = base + 1; l < plan.levelCount(); ++l)
        {
            const LevelTables& level = rowsOfLevel(plan, l);
            const DevicePruning::Votes own = {level.segments, level.rows, UMat(),
                                              edges.depthFor(plan.level(l).maxVotes)};
            above.push_back(own);
            if ((l - base) % 2 == 1)
            {
                allocate(plan.level(l), own.depth, tables.of(l));
                above.back().table = tables.of(l).device;
                continue;
            }
            // The whole one must stay for a second count.
            allocateOn(between_, plan.level(l).tableSize() * own.depth);
            above.back().table = between_;
        }
        planTables().pruning.bound(plan, base, whole);
        PrunedVotes pruned;
        pruned.block = DevicePruning::BLOCK;
        pruned.count = [&](int cut, int sample)
        {
            planTables().pruning.count(whole, above, cut, sample);
        };
        pruned.needed = [&]()
        {
            return planTables().pruning.needed();
        };
        pruned.learn = [&](int count)
        {
            planTables().pruning.learn(count);
        };
        planTables().maxima.find(edges, plan, tables.of(plan.levelCount() - 1), wanted,
                                 SUPPRESS_RING, radius, &pruned, counting(ascentRadius, areCounted),
                                 found);
        return true;
    }

    bool readsBits(const EdgeMap& edges) const CV_OVERRIDE
    {
        return !edges.source.empty() && !edges.isOriented();
    }
    void readBits(const EdgeMap& edges, const Plan& plan, EdgeBits& bits) CV_OVERRIDE
    {
        prepare(plan);
        takePixels(edges, plan);
        ascent_.readBits(bits);
    }

    void rescore(const EdgeMap& edges, const Plan& plan, const std::vector<Chord>& chords,
                 std::vector<int>& votes) CV_OVERRIDE
    {
        votes.resize(chords.size());
        if (chords.empty())
            return;
        prepare(plan);
        const Cell& frame = plan.frame();
        checkRasters(frame);
        static_assert(sizeof(Chord) == 2 * sizeof(int), "an int2 of the device");
        upload(chords, chords_);
        allocateOn(sums_, votes.size() * sizeof(int));
        const DevicePixels map = votesOf(edges);
        Launch launch(CASCADE_PROGRAM, "rescore",
                      "-D EXACT -D PARENT=int -D CELLS=1" + map.options + map.directionOptions());
        map.giveTo(launch);
        map.giveDirectionsTo(launch);
        launch.with(in(chords_), (int)chords.size(), frame.width, frame.height, out(sums_))
            .run(chords.size(), 1);
        download(sums_, votes.size() * sizeof(int), votes.data());
    }

    UMat findDirections(const EdgeMap& edges, const Plan& plan, const UMat& dx, const UMat& dy,
                        double tolerance) CV_OVERRIDE
    {
        prepare(plan);
        return dx.empty() ? deviceDirections_.estimate(votesOf(edges), tolerance)
                          : deviceDirections_.find(votesOf(edges), dx, dy, tolerance);
    }

    void readOriented(const EdgeMap& edges, const Plan& plan, const UMat& dx, const UMat& dy,
                      OrientedPixels& pixels) CV_OVERRIDE
    {
        prepare(plan);
        deviceDirections_.read(votesOf(edges), dx, dy, pixels);
    }

    bool countGridLines(const EdgeMap& edges, const Plan& plan, const HoughGrid& grid,
                        int threshold, std::vector<GridLine>& found) CV_OVERRIDE
    {
        prepare(plan);
        if (!houghLines_)
            houghLines_ = makePtr<DeviceHoughLines>();
        houghLines_->count(*this, edges, plan, grid, threshold, found);
        return true;
    }

    void writeTable(const Plan& plan, int l, const VoteTable& table, const UMat& out) CV_OVERRIDE
    {
        prepare(plan);
        LevelTables& level = planTables().levels[l];
        if (!level.knowsCells)
        {
            std::vector<int> rowBits, columnBits;
            plan.cellOrder(l, rowBits, columnBits);
            upload(rowBits, level.rowBits);
            upload(columnBits, level.columnBits);
            level.knowsCells = true;
        }
        const Cell& cell = plan.level(l).cell;
        Launch(TABLE_PROGRAM, "writeTable", format("-D VOTES=%s", typeOf(table.depth)))
            .with(in(table.device), cell.width, cell.height, (int)table.cells, in(level.rowBits),
                  in(level.columnBits), ocl::KernelArg::WriteOnly(out))
            .run(out.cols, out.rows);
    }

    void fetch(VoteTable& table) CV_OVERRIDE
    {
        table.buffer.allocate(table.bytes() + VoteTable::PADDING);
        download(table.device, table.bytes(), table.buffer.data());
    }

private:
    enum
    {
        MOST_TOGETHER = 16, //!< cells of a work item
        MOST_PLANS = 4      //!< whose tables are kept: of cameras, or steps of a pyramid, in turns
    };

    //! Consecutive chords that a work item merges.
    static int chordsPerItem() { return isProcessor() ? 64 : 1; }

    //! What counts candidates exactly, with an ascentRadius as that of findMaxima.
    std::function<void(const UMat&, int)> counting(int ascentRadius, bool& areCounted)
    {
        if (ascentRadius >= 0)
            areCounted = true;
        return [=](const UMat& candidates, int room)
        {
            if (ascentRadius >= 0)
                ascent_.count(ascentRadius, candidates, room);
        };
    }

    //! The pixels of the map of this call, which is kept for what reads them again.
    DevicePixels takePixels(const EdgeMap& edges, const Plan& plan)
    {
        if (!ascent_.hasPixels())
            ascent_.reset(votesOf(edges), edges.weighted, plan.frame());
        return ascent_.pixels();
    }

    DevicePixels votesOf(const EdgeMap& edges)
    {
        DevicePixels votes;
        if (!edges.directionsOnDevice.empty())
            votes.directions = edges.directionsOnDevice;
        else if (edges.isOriented())
        {
            copyOnDevice([&]() { edges.directions.copyTo(directions_); });
            checkIsOnDevice(directions_);
            votes.directions = directions_;
        }
        if (edges.source.empty())
        {
            copyOnDevice([&]() { edges.votes.copyTo(votes_); });
            checkIsOnDevice(votes_);
            votes.image = votes_;
            return votes;
        }
        votes.image = edges.source;
        if (!edges.mask.empty())
            votes.mask = maskOnDevice(edges.mask);
        if (!edges.weighted)
            votes.options += " -D BINARY";
        if (!votes.mask.empty())
            votes.options += " -D MASKED";
        return votes;
    }

    //! A mask of the host, which is copied once.
    const UMat& maskOnDevice(const Mat& mask)
    {
        if (mask_.data != mask.data)
        {
            mask_.release();
            copyOnDevice([&]() { mask.copyTo(maskOnDevice_); });
            checkIsOnDevice(maskOnDevice_);
            mask_ = mask;
        }
        return maskOnDevice_;
    }

    /** Puts the tables of a plan first. Each thread has a queue of its own: what another one still has
    to do with the buffers comes first. */
    void prepare(const Plan& plan)
    {
        if (queue_.ptr() != ocl::Queue::getDefault().ptr())
        {
            if (queue_.ptr())
                queue_.finish();
            queue_ = ocl::Queue::getDefault();
        }
        const PlanTables::Key key = PlanTables::keyOf(plan);
        const auto isThis = [&](const PlanTables& tables)
        {
            return tables.key == key;
        };
        const auto known = std::find_if(plans_.begin(), plans_.end(), isThis);
        if (known != plans_.end())
        {
            plans_.splice(plans_.begin(), plans_, known);
            return;
        }
        if (plans_.size() == MOST_PLANS)
            plans_.pop_back();
        plans_.push_front(PlanTables());
        plans_.front().key = key;
        plans_.front().levels.resize(plan.levelCount());
    }

    //! Of the plan that was prepared last.
    PlanTables& planTables() { return plans_.front(); }

    const LevelTables& rowsOfLevel(const Plan& plan, int l)
    {
        LevelTables& level = planTables().levels[l];
        if (!level.isReady)
            listRows(plan.merge(l), level);
        return level;
    }

    //! The corners of the cells of level 0 in the order of the table, and the pixels of its chords.
    void listCells(const Plan& plan)
    {
        const Level& level = plan.level(0);
        upload(plan.cellCorners(), planTables().corners);

        std::vector<ushort> pixels;
        std::vector<int> starts;
        std::vector<uchar> bins;
        for (int s = 0; s < level.cell.firstPoint(SIDE_LEFT); ++s)
            for (int e = level.cell.firstPartner(level.cell.sideOf(s));
                 e < level.cell.borderCount(); ++e)
            {
                const Chord chord = {s, e};
                starts.push_back((int)pixels.size());
                bins.push_back((uchar)directionBin(level.cell, chord));
                Raster(level.cell, chord)
                    .forEachPixel([&](int x, int y)
                                  { pixels.push_back((ushort)(y * level.cell.width + x)); });
            }
        starts.push_back((int)pixels.size());
        pixels.push_back(0); // cells of one pixel have chords without any
        upload(pixels, planTables().pixels);
        upload(starts, planTables().starts);
        upload(bins, planTables().bins);
        planTables().knowsCells = true;
    }

    static void listRows(const Merge& merge, LevelTables& level)
    {
        std::vector<BorderRow> rows = rowsOf(merge.parent);
        std::vector<DeviceSegment> segments(rows.size() * MAX_SEGMENTS);
        for (int s = 0; s < (int)rows.size(); ++s)
        {
            Segment own[MAX_SEGMENTS];
            rows[s].segments = rowSegments(merge, s, own);
            for (int k = 0; k < rows[s].segments; ++k)
                segments[s * MAX_SEGMENTS + k] = deviceSegment(merge, s, own[k]);
        }
        upload(segments, level.segments);
        upload(rows, level.rows);
        level.setSize(rows);
    }

    void* context_;
    ocl::Queue queue_;            //!< of the thread that worked last
    std::list<PlanTables> plans_; //!< that used last first
    UMat votes_, directions_;     //!< the edge map, where it was on the host
    Mat mask_;                    //!< what maskOnDevice_ holds
    UMat maskOnDevice_;
    UMat gathered_, gatheredDirections_;
    UMat chords_, sums_; //!< of rescore
    UMat between_;       //!< the table of the last level but one, where it is pruned
    DeviceAscent ascent_;
    DeviceDirections deviceDirections_;
    Ptr<DeviceHoughLines> houghLines_; //!< empty until it is needed
};

} // namespace

bool isOpenClActive()
{
    return ocl::useOpenCL();
}

Ptr<Executor> createOpenClExecutor()
{
    return makePtr<OpenClExecutor>();
}

} // namespace linespace
} // namespace cv

#else

namespace cv {
namespace linespace {

bool isOpenClActive()
{
    return false;
}

Ptr<Executor> createOpenClExecutor()
{
    throw DeviceFailure("built without OpenCL");
}

} // namespace linespace
} // namespace cv

#endif
