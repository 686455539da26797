// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The seam between the detector and its back ends: the stages that each back end implements, and
// the memory order of what passes between them. A back end is an executor of one plan; it derives
// no geometry of its own and decides nothing, so all give the same votes. What follows the table
// is host code that all share: candidates (peaks.hpp), their exact votes (ascent.hpp,
// chord_counter.hpp; rescore() serves those that do not climb), selection.hpp, refine.hpp. A device
// may do the first two itself, as findMaxima() tells.
//
// What a stage combines is a vote count, but nothing here depends on that beyond VoteTable::depth:
// a later table may hold other monoids (for segments: best run, prefix, suffix, sum) in the same
// order.

#ifndef OPENCV_LINESPACE_STAGES_HPP
#define OPENCV_LINESPACE_STAGES_HPP

#include "memory.hpp"
#include "orientation.hpp"
#include "stage_times.hpp"

namespace cv {
namespace linespace {

//! Memory of a device of which OpenCV knows nothing.
class DeviceMemory
{
public:
    virtual ~DeviceMemory() {}
    virtual size_t bytes() const = 0;
};

/** Votes of all chords of all cells of one level. The votes of chord i of the cell with index c
(see Plan::cellOrder) stand at data[i * cells + c], as unsigned integers of `depth` bytes (1, 2 or
4). */
struct VoteTable
{
    size_t chords, cells;
    int depth;
    Buffer buffer;
    UMat device; //!< the same on a device: a row of bytes; what is in buffer, fetch() tells
    Ptr<DeviceMemory> memory; //!< the same on another device, in an order of its own

    VoteTable() : chords(0), cells(0), depth(0) {}

    void setShape(const Level& level, int bytesPerVote)
    {
        chords = level.cell.chordCount();
        cells = level.cellCount();
        depth = bytesPerVote;
    }
    size_t bytes() const { return chords * cells * depth; }
    template<class Votes>
    Votes* ptr() const
    {
        CV_DbgAssert(sizeof(Votes) == (size_t)depth);
        return (Votes*)buffer.data();
    }
    //! Votes of chord i of cell c, whatever the depth.
    int at(size_t chord, size_t cell) const
    {
        const size_t i = chord * cells + cell;
        return depth == 1   ? buffer.data()[i]
               : depth == 2 ? ((const ushort*)buffer.data())[i]
                            : ((const int*)buffer.data())[i];
    }

    //! Bytes after the last entry that may be read, so that vector loads need no tail.
    enum
    {
        PADDING = 64
    };
};

/** What votes: CV_8UC1 of the size of the image, continuous; 0 or 1, with weights 0 to 255. */
struct EdgeMap
{
    //! May be empty if the source is not, for an executor that takes UMats, or if isTaken.
    Mat votes;
    //! The image that the votes come from, on OpenCV's device; empty if it is not there.
    UMat source;
    //! Where it counts, on the host; empty: everywhere. The votes are of that part already.
    Mat mask;
    //! Whether the executor has the votes already, by takeTexture().
    bool isTaken;
    int voters; //!< how many pixels vote; -1: that is not known yet
    bool weighted;
    //! CV_16UC1 of the same size, continuous: a pixel votes for the chords of the bins in its bits
    //! (orientation.hpp); empty: for all.
    Mat directions;
    UMat directionsOnDevice; //!< the same where the source is; may be empty
    bool isEstimated;        //!< the directions, from the edge pixels themselves
    //! The gradients as they were given, CV_16SC1 or CV_32FC1 of the same size, for the refinement;
    //! empty: none were.
    Mat dx, dy;

    EdgeMap() : isTaken(false), voters(-1), weighted(false), isEstimated(false) {}
    bool isOriented() const { return !directions.empty(); }
    //! Bytes that hold `count` edge pixels' votes.
    int depthFor(int count) const
    {
        const int64 most = (int64)count * (weighted ? 255 : 1);
        return most <= UCHAR_MAX ? 1 : most <= USHRT_MAX ? 2 : 4;
    }
};

//! What an oriented map is made of, in one block of memory, as it comes from a device.
struct OrientedPixels
{
    Mat memory;
    Mat votes, directions, dx, dy; //!< as in EdgeMap; dx and dy may be empty
    bool areFinite;                //!< the gradients that the directions were found from
};

struct Candidate; // peaks.hpp
struct Wanted;
class EdgeBits; // edge_bits.hpp
struct VoteTables;
struct HoughGrid; // houghgrid.hpp
struct GridLine;

//! A device cannot do what is asked for; the CPU path can.
struct DeviceFailure
{
    String reason;
    explicit DeviceFailure(const String& why) : reason(why) {}
};

/** One back end. Calls of one object come from one thread at a time; it may keep buffers between
them. */
class Executor
{
public:
    virtual ~Executor() {}

    //! One of enum Backend.
    virtual int backend() const = 0;

    bool isDevice() const { return backend() == BACKEND_OPENCL || backend() == BACKEND_OPENGL; }

    //! Whether it still can run: a device may not be the one in use any more.
    virtual bool isUsable() const { return true; }

    //! Around all the work of one call, in one thread; end() throws nothing.
    virtual void begin() {}
    virtual void end() {}

    //! Whether it works where the data of a UMat are: it reads EdgeMap::source, and writeTable()
    //! works.
    virtual bool takesUMats() const { return false; }

    /** The directions of a map (directionBits) from gradients that are on the device, as its source is,
    or from those that are estimated, if these are empty; they stay valid until the next call.
    @return an empty array if the host is to find them. */
    virtual UMat findDirections(const EdgeMap&, const Plan&, const UMat& /*dx*/, const UMat& /*dy*/,
                                double /*tolerance*/)
    {
        return UMat();
    }
    //! Reads the map of which it found the directions last, with its gradients if these are not
    //! empty.
    virtual void readOriented(const EdgeMap&, const Plan&, const UMat& /*dx*/, const UMat& /*dy*/,
                              OrientedPixels& /*pixels*/)
    {
    }

    //! Makes room for a level's votes of so many bytes, where the stages want them.
    virtual void allocate(const Level& level, int bytesPerVote, VoteTable& table)
    {
        table.setShape(level, bytesPerVote);
        table.buffer.allocate(table.bytes() + VoteTable::PADDING);
    }

    //! Puts the votes into table.buffer, where they are not there already.
    virtual void fetch(VoteTable& /*table*/) {}

    /** Level 0 of the cascade: the votes of every chord of every cell, by its raster; of an
    oriented map, of the pixels that vote for the bin of that chord of the cell. Pixels of
    cells beyond the image are 0. `table` is allocated for level 0. */
    virtual void firstCells(const EdgeMap& edges, const Plan& plan, VoteTable& table) = 0;

    /** Level `level` >= 1 from the level below: each chord is a copy of one child's, or the sum of
    a part in each child. `parent` is allocated for the level; its depth is not less than the
    child's. */
    virtual void mergeCells(const Plan& plan, int level, const VoteTable& child,
                            VoteTable& parent) = 0;

    /** The same for a child and a parent of one byte per vote, where the parent's could need more.
    @return false if they do, or if it is not worth a try. */
    virtual bool mergeCellsNarrow(const Plan&, int /*level*/, const VoteTable& /*child*/,
                                  VoteTable& /*parent*/)
    {
        return false;
    }

    /** METHOD_EXACT: the votes of every chord of the plan's only cell, by its raster; of an
    oriented map, of the pixels that vote for the chord's bin. */
    virtual void exactVotes(const EdgeMap& edges, const Plan& plan, VoteTable& table) = 0;

    /** The local maxima of the frame's table, where the votes are, of the map that was counted last.
    @param suppression SUPPRESS_RING, or SUPPRESS_BLOCKS, as of findCandidates.
    @param radius of findCandidates, or with SUPPRESS_RING -1: findParallelMaxima.
    @param ascentRadius of climbToMaxima, which may then be done with them, but for the order and for
    those that came to the same maximum; 0: they may be counted exactly; -1: neither.
    @param areCounted set if that was done.
    @return false if they are better found in table.buffer after fetch(). */
    virtual bool findMaxima(const EdgeMap&, const Plan&, const VoteTable& /*table*/, const Wanted&,
                            int /*suppression*/, int /*radius*/, int /*ascentRadius*/,
                            std::vector<Candidate>& /*found*/, bool& /*areCounted*/)
    {
        return false;
    }

    //! The level from whose table findMaximaPruned() goes on; -1: it is of no use.
    virtual int levelForPruning(const Plan&, bool /*weighted*/) { return -1; }

    /** As findMaxima, from the table of that level, which stays: most chords of those above are not
    counted. */
    virtual bool findMaximaPruned(const EdgeMap&, const Plan&, int /*base*/, VoteTables&,
                                  const Wanted&, int /*radius*/, int /*ascentRadius*/,
                                  std::vector<Candidate>& /*found*/, bool& /*areCounted*/)
    {
        return false;
    }

    //! Whether readBits() works for a map, and spares the host what it is read for.
    virtual bool readsBits(const EdgeMap&) const { return false; }
    //! Reads the edge pixels of a map, whatever their weights. Unless its source is on OpenCV's device
    //! it has been counted.
    virtual void readBits(const EdgeMap&, const Plan&, EdgeBits& /*bits*/) {}

    //! The size of a texture of OpenGL. Throws cv::Exception if it is none of those that
    //! detectTexture takes.
    virtual Size textureSize(unsigned int /*texture*/) { return Size(); }

    //! Takes what votes from a texture, as EdgeMap::votes; `mask` may be empty.
    virtual void takeTexture(unsigned int /*texture*/, bool /*weighted*/, const Mat& /*mask*/) {}
    //! Of what it took last, how many pixels vote.
    virtual int countTaken() { return 0; }
    //! And those pixels.
    virtual void readTaken(Mat& /*votes*/) {}

    //! Writes a level's table as LineSpaceDetector::computeLevel does, to CV_32SC1 of that size.
    virtual void writeTable(const Plan&, int /*level*/, const VoteTable&, const UMat& /*out*/) {}

    //! The same as exactVotes for some chords of the frame, one result each.
    virtual void rescore(const EdgeMap& edges, const Plan& plan, const std::vector<Chord>& chords,
                         std::vector<int>& votes) = 0;

    /** The lines of the grid with more votes than the threshold, and at least one, that the drop-in
    counts (grid_support.hpp), by angles and distances.
    @return false if they are better counted by the host. */
    virtual bool countGridLines(const EdgeMap&, const Plan&, const HoughGrid&, int /*threshold*/,
                                std::vector<GridLine>& /*found*/)
    {
        return false;
    }

    //! Ends a stage of votes. A device that only queues it takes a note of its own clock.
    virtual void endStage(const String& name, StageTimes& times) { times.end(name); }
    //! Puts the times of the device in the place of those of queueing; it has done everything.
    virtual void settleTimes(StageTimes& /*times*/) {}
};

Ptr<Executor> createReferenceExecutor(); // reference.cpp
Ptr<Executor> createCpuExecutor();       // cascade.dispatch.cpp

//! The tables of a level and the one before: levels take turns in two.
struct VoteTables
{
    VoteTable& of(int level) { return tables_[level % 2]; }
    const VoteTable& of(int level) const { return tables_[level % 2]; }
    //! Memory that is free until the next level is merged.
    Buffer& besides(int level) { return of(level + 1).buffer; }
    void release()
    {
        for (int i = 0; i < 2; ++i)
        {
            tables_[i].buffer.release();
            tables_[i].device.release();
            tables_[i].memory.reset();
        }
    }

private:
    VoteTable tables_[2];
};

/** Runs the cascade (or the exact method, for a plan of one level made for it) up to a level, whose
votes are in tables.of(level) on return.
@param times has a stage for each level on return. */
void countVotes(Executor& executor, const EdgeMap& edges, const Plan& plan, bool exact, int level,
                VoteTables& tables, StageTimes& times);

//! Goes on from level `from`, which was counted, to level `to`.
void mergeVotes(Executor& executor, const EdgeMap& edges, const Plan& plan, int from, int to,
                VoteTables& tables, StageTimes& times);

/** Bytes that countVotes needs for its two tables, and everybody for copies of the edge map, but
for EdgePlanes. */
double workingMemory(const Plan& plan, bool weighted, bool oriented, int level);

//! Votes of a chord of the frame on the edge map, of the pixels that vote for its bin; pixels
//! beyond the image are 0.
int chordVotes(const EdgeMap& edges, const Cell& frame, Chord chord);

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_STAGES_HPP
