// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "ocl_houghlines.hpp"

#include <cvconfig.h>

#ifdef HAVE_OPENCL

#include "ocl_launch.hpp"

#include <climits>

namespace cv {
namespace linespace {

namespace {

//! As in houghlines.cl.
enum
{
    TILE = 256
};
const size_t THREE = 3 * sizeof(int);

static_assert(sizeof(GridLine) == THREE, "votes, angle and number, as the device writes them");
static_assert(sizeof(SampleRun) == 64, "six longs and four ints there");

//! Buffers that are larger are not kept.
const int MOST_KEPT_BYTES = 256 * (1 << 20);

//! Local memory that is not for bins.
const size_t LOCAL_REST = 1024;

String commonOptions()
{
    return format("-D GROUP=%d", (int)Launch::GROUP) + (isProcessor() ? " -D PROCESSOR" : "");
}

} // namespace

//! Returns how many there are, after waiting for the device.
int DeviceHoughLines::listPixels(const UMat& image, bool weighted)
{
    const int tilesPerRow = (image.cols + TILE - 1) / TILE;
    const int tiles = tilesPerRow * image.rows;
    asInt((double)image.cols * image.rows);
    const ocl::KernelArg pixels = ocl::KernelArg::ReadOnly(image);
    const String options = commonOptions() + (weighted ? " -D WEIGHTED" : "");
    allocateOn(tiles_, (1 + (size_t)tiles) * sizeof(int));
    Launch(HOUGHLINES_PROGRAM, "countPixels", options)
        .with(pixels, tilesPerRow, out(tiles_))
        .run(tiles, 1);
    Launch(HOUGHLINES_PROGRAM, "scanCounts", options).with(inOut(tiles_), tiles).run(1, 1);
    int count;
    download(tiles_, sizeof(count), &count);

    const size_t bytes = std::max(1, count) * sizeof(float);
    allocateOn(x_, bytes);
    allocateOn(y_, bytes);
    Launch write(HOUGHLINES_PROGRAM, "writePixels", options);
    write.with(pixels, tilesPerRow, in(tiles_), out(x_), out(y_));
    if (weighted)
    {
        allocateOn(weights_, bytes);
        write.with(out(weights_));
    }
    write.run(tiles, 1);
    return count;
}

void DeviceHoughLines::listAngles(const HoughGrid& grid)
{
    std::vector<DeviceAngle> angles;
    double most = 0;
    for (int angle = 0; angle < grid.angles; ++angle)
    {
        int first, last;
        grid.distanceRange(angle, first, last);
        const DeviceAngle one = {grid.cosines[angle], grid.sines[angle], first, last - first + 1,
                                 grid.isAxisParallel(angle)};
        angles.push_back(one);
        most = std::max(most, (double)one.count);
    }
    columns_ = asInt(most + 2);
    uploadNew(angles, angleList_, angles_);
}

//! Marks the lines that the table of the frame supports.
void DeviceHoughLines::findSupported(Executor& cascade, const EdgeMap& edges, const Plan& plan,
                                     const HoughGrid& grid, int needed)
{
    const int last = plan.levelCount() - 1;
    StageTimes times;
    countVotes(cascade, edges, plan, false, last, tables_, times);
    std::vector<SampleRun> runs((size_t)grid.angles * MOST_RUNS);
    for (int angle = 0; angle < grid.angles; ++angle)
        findSampleRuns(plan.frame(), grid, angle, &runs[(size_t)angle * MOST_RUNS]);
    uploadNew(runs, runList_, runs_);
    const VoteTable& table = tables_.of(last);
    allocateOn(supported_, (size_t)grid.angles * columns_);
    Launch(HOUGHLINES_PROGRAM, "findSupported",
           commonOptions() + format(" -D VOTES=%s", typeOf(table.depth)))
        .with(in(table.device), plan.frame().width, plan.frame().height, in(runs_), in(angles_),
              grid.angles, columns_, samplesPerLine(grid), needed, out(supported_))
        .run(columns_ - 2, grid.angles);
}

//! Reads the lines of votes_ that have more votes than `least`; as many as starts_ tells.
void DeviceHoughLines::readLines(int least, std::vector<GridLine>& found)
{
    const int angles = (int)angleList_.size();
    for (;;)
    {
        allocateOn(lines_, (1 + (size_t)room_) * THREE);
        Launch(HOUGHLINES_PROGRAM, "writeLines", commonOptions())
            .with(in(votes_), in(angles_), angles, columns_, least, in(starts_), out(lines_), room_)
            .run(Launch::GROUP, angles);
        found.resize(1 + (size_t)room_);
        download(lines_, found.size() * THREE, found.data());
        const int count = found.front().votes;
        // The next image may have somewhat more, and is to need one read.
        const int wanted = asInt(std::max<double>(LEAST_ROOM, 1.25 * count));
        if (count > room_)
        {
            room_ = wanted;
            continue;
        }
        room_ = std::min(room_, wanted);
        found.erase(found.begin());
        found.resize(count);
        return;
    }
}

void DeviceHoughLines::forgetLarge()
{
    for (int i = 0; i < 2; ++i)
        if (tables_.of(i).device.cols > MOST_KEPT_BYTES)
            tables_.of(i).device.release();
    UMat* const others[] = {&image_, &x_, &y_, &weights_, &supported_, &votes_, &lines_};
    for (UMat* other : others)
        if (!other->empty() && (double)other->total() * other->elemSize() > MOST_KEPT_BYTES)
            other->release();
}

void DeviceHoughLines::count(Executor& cascade, const EdgeMap& edges, const Plan& plan,
                             const HoughGrid& grid, int threshold, std::vector<GridLine>& found)
{
    if (!(ocl::Device::getDefault().singleFPConfig() & ocl::Device::FP_ROUND_TO_NEAREST))
        throw DeviceFailure("the device does not round to nearest");
    EdgeMap map = edges;
    if (map.source.empty())
    {
        copyOnDevice([&]() { edges.votes.copyTo(image_); });
        checkIsOnDevice(image_);
        map.source = image_;
    }
    const UMat& image = map.source;
    const int pixels = listPixels(image, edges.weighted);
    listAngles(grid);
    const bool isSupported = !countsAllLines(plan, grid, edges.weighted, pixels);
    if (isSupported)
        findSupported(cascade, map, plan, grid, neededSupport(threshold));

    const size_t binBytes = columns_ * sizeof(int);
    const bool hasLocalBins =
        !isProcessor() && binBytes + LOCAL_REST <= ocl::Device::getDefault().localMemSize();
    const int least = std::max(threshold, 0);
    allocateOn(votes_, grid.angles * binBytes);
    allocateOn(starts_, (1 + (size_t)grid.angles) * sizeof(int));
    Launch counting(HOUGHLINES_PROGRAM, "countVotes",
                    commonOptions() + (edges.weighted ? " -D WEIGHTED" : "") +
                        (grid.isSmall() ? "" : " -D WIDE") +
                        (hasLocalBins ? " -D LOCAL_BINS" : "") +
                        (isSupported ? " -D SUPPORTED" : ""));
    counting.with(in(x_), in(y_));
    if (edges.weighted)
        counting.with(in(weights_));
    counting.with(pixels, in(angles_), grid.angles, columns_, least);
    if (isSupported)
        counting.with(ocl::KernelArg::ReadOnly(image), in(supported_),
                      mostWalkedLines(grid, pixels));
    if (hasLocalBins)
        counting.with(ocl::KernelArg::Local(binBytes));
    counting.with(inOut(votes_), out(starts_)).run(Launch::GROUP, grid.angles);
    Launch(HOUGHLINES_PROGRAM, "scanCounts", commonOptions())
        .with(inOut(starts_), grid.angles)
        .run(1, 1);
    readLines(least, found);
    forgetLarge();
}

} // namespace linespace
} // namespace cv

#endif // HAVE_OPENCL
