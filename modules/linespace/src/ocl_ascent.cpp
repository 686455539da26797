// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include <cvconfig.h>

#ifdef HAVE_OPENCL

#include "ocl_ascent.hpp"

#include "orientation.hpp"
#include "vote_squares.hpp"

#include <climits>

namespace cv {
namespace linespace {

namespace {

const int SQUARE = VoteSquares::SQUARE; // as in ascent.cl
//! After so many steps that all take together those that are left go on alone.
const int ROUNDS = 4;
//! n (n + 1) < 2^26, see countLanes in ascent.cl.
const int MOST_PIXELS_OF_LANES = 8191;

} // namespace

void DeviceAscent::reset(const DevicePixels& pixels, bool isWeighted, const Cell& frame)
{
    pixels_ = pixels;
    isWeighted_ = isWeighted;
    frame_ = frame;
    isPacked_ = false;
}

String DeviceAscent::bitOptions() const
{
    // Weights count as pixels here.
    return " -D BITS" + pixels_.options + pixels_.directionOptions() +
           (pixels_.options.find("BINARY") == String::npos ? " -D BINARY" : "");
}

void DeviceAscent::pack()
{
    if (isPacked_)
        return;
    const int bins = pixels_.directions.empty() ? 1 : DIRECTION_BINS;
    allocateOn(bits_, (size_t)asInt(bins * EdgeBits::wordsOf(frame_)) * sizeof(unsigned));
    const String options = "-D LANES=1 -D RADIUS=1 -D EXACT=int" + bitOptions();
    const struct
    {
        const char* kernel;
        int width, height;
    } both[2] = {{"packColumns", (frame_.width + 15) / 16, bins * EdgeBits::wordsOf(frame_.height)},
                 {"packRows", EdgeBits::wordsOf(frame_.width), bins * frame_.height}};
    for (const auto& one : both)
    {
        Launch launch(ASCENT_PROGRAM, one.kernel, options);
        pixels_.giveTo(launch);
        pixels_.giveDirectionsTo(launch);
        launch.with(frame_.width, frame_.height, out(bits_)).run(one.width, one.height);
    }
    isPacked_ = true;
}

void DeviceAscent::count(int radius, const UMat& candidates, int room)
{
    checkRasters(frame_);
    radius = mostRadius(frame_, radius);
    const int pixels = std::max(frame_.width, frame_.height);
    const bool hasBits = !isWeighted_ && pixels <= MOST_PIXELS_OF_LANES;
    if (hasBits)
        pack();
    const int lanes = hasBits && isProcessor() ? 16 : 1;
    const double most = (double)pixels * (isWeighted_ ? UCHAR_MAX : 1);
    const int depth = most <= USHRT_MAX ? 2 : 4;
    const String options =
        format("-D LANES=%d -D RADIUS=%d -D EXACT=%s", lanes, radius, typeOf(depth)) +
        (hasBits ? bitOptions() : pixels_.options + pixels_.directionOptions());
    const auto launch = [&](const char* kernel)
    {
        return Launch(ASCENT_PROGRAM, kernel, options);
    };
    const auto giveMap = [&](Launch& counting)
    {
        if (hasBits)
        {
            counting.with(in(bits_));
            return;
        }
        pixels_.giveTo(counting);
        pixels_.giveDirectionsTo(counting);
    };
    const int width = frame_.width, height = frame_.height;
    if (radius == 0)
    {
        Launch counting = launch("countCandidates");
        counting.with(inOut(candidates), room, width, height);
        giveMap(counting);
        counting.run(room, 1);
        return;
    }
    const int squares = asInt((double)VoteSquares::runsOf(frame_).chordCount());
    allocateOn(wanted_, squares * sizeof(uint64));
    allocateOn(counted_, squares * sizeof(uint64));
    allocateOn(votes_, (size_t)squares * SQUARE * SQUARE * depth);
    launch("clearMarks").with(out(wanted_), out(counted_), squares).run(squares, 1);
    for (int round = 0; round < ROUNDS; ++round)
    {
        launch("wantNeighbours")
            .with(inOut(candidates), room, width, height, (int)(round == 0), inOut(wanted_))
            .run(room, 1);
        Launch counting = launch("countWanted");
        counting.with(width, height, squares, in(wanted_), in(counted_));
        giveMap(counting);
        counting.with(out(votes_)).run(squares, lanes > 1 ? 1 : SQUARE * SQUARE);
        launch("markCounted").with(inOut(wanted_), inOut(counted_), squares).run(squares, 1);
        launch("takeSteps").with(inOut(candidates), room, width, height, in(votes_)).run(room, 1);
    }
    Launch alone = launch("climbOn");
    alone.with(inOut(candidates), room, width, height, in(counted_), in(votes_));
    giveMap(alone);
    alone.run(room, 1);
}

void DeviceAscent::readBits(EdgeBits& bits)
{
    pack();
    download(bits_, (size_t)EdgeBits::wordsOf(frame_) * sizeof(unsigned), bits.create(frame_));
}

} // namespace linespace
} // namespace cv

#endif // HAVE_OPENCL
