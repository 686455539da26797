// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "gl_ascent.hpp"

#ifdef LINESPACE_OPENGL

#include "gl_maxima.hpp"
#include "vote_squares.hpp"

#include <climits>
#include <cmath>

namespace cv {
namespace linespace {

namespace {

const int SQUARE = VoteSquares::SQUARE; // as in ascent.glsl
//! Steps that all take together.
const int ROUNDS = 4;
//! Then those that are left go on alone, if a launch of so many turns of loops is worth it.
const int MOST_TURNS = 65000, LAUNCHES_ALONE = 6;
//! Lists of rounds: the first one of a call that goes on has the number 1.
const int LISTS = ROUNDS + 1;

} // namespace

void GlAscent::release()
{
    bits_.release();
    marks_.release();
    listed_.release();
    votes_.release();
}

void GlAscent::reset(const GlPixels& pixels, bool isWeighted)
{
    pixels_ = pixels;
    isWeighted_ = isWeighted;
    isPacked_ = false;
}

void GlAscent::pack(GlDevice& device)
{
    if (isPacked_)
        return;
    const size_t words = asShaderInt(EdgeBits::wordsOf(pixels_.frame)),
                 most = device.limits().blockBytes / sizeof(uint);
    device.allocate(bits_, words * sizeof(uint));
    for (size_t first = 0; first < words; first += most)
    {
        const size_t count = std::min(most, words - first);
        GlLaunch launch(device, GL_BITS,
                        define("MAP_BLOCK", 1) + define("MARGIN", EdgeBits::MARGIN));
        launch.block(bits_, first * sizeof(uint), count * sizeof(uint))
            .block(*pixels_.image)
            .runItems(pixels_.numbers({(int)first, (int)count}), count);
    }
    isPacked_ = true;
}

bool GlAscent::count(GlDevice& device, int radius, const GlBuffer& candidates, int room,
                     bool goesOn)
{
    const Cell& frame = pixels_.frame;
    const GlLimits& limits = device.limits();
    radius = mostRadius(frame, radius);
    const double bitBytes = EdgeBits::wordsOf(frame) * sizeof(uint);
    const bool hasBits = !isWeighted_ && !pixels_.directions && bitBytes <= limits.blockBytes;
    const auto mapOptions = [&](int block)
    {
        return hasBits ? define("MAP_BLOCK", block) + define("BITS") +
                             define("MARGIN", EdgeBits::MARGIN)
                       : pixels_.options(block);
    };
    const auto giveMap = [&](GlLaunch& launch, int block)
    {
        if (hasBits)
            launch.blockAt(block, bits_, (size_t)bitBytes);
        else
            pixels_.giveTo(launch, block);
    };
    const double placeCount = (double)VoteSquares::runsOf(frame).chordCount() * SQUARE * SQUARE,
                 most = std::min(placeCount, (double)room * (2 * radius + 1) * (2 * radius + 1)),
                 listBytes = (LISTS + most) * sizeof(int),
                 windows = std::ceil(placeCount * sizeof(uint) / limits.blockBytes);
    if (radius > 0 && (placeCount > INT_MAX || listBytes > limits.blockBytes ||
                       windows + (pixels_.directions ? 4 : 3) > limits.blocks))
        return false;
    if (hasBits)
        pack(device);
    const auto launch = [&](const char* step, const std::string& options)
    {
        return GlLaunch(device, GL_ASCENT,
                        define(step) + define("RADIUS", radius) + define("ROUNDS", LISTS) +
                            options);
    };
    if (radius == 0)
    {
        GlLaunch counting = launch("COUNT_CANDIDATES", mapOptions(1));
        counting.block(candidates);
        giveMap(counting, 1);
        counting.runItems(pixels_.numbers({room}), room);
        return true;
    }
    const int places = (int)placeCount, marks = places / 32;
    const size_t bytes = places * sizeof(uint), together = limits.blockBytes / sizeof(uint);
    const std::string windowed = windowOptions(limits, bytes);
    device.allocate(marks_, marks * sizeof(uint));
    device.allocate(listed_, (size_t)listBytes);
    device.allocate(votes_, bytes);
    launch("CLEAR_MARKS", std::string())
        .block(marks_)
        .block(listed_)
        .runItems(pixels_.numbers({room, 0, 0, marks}), marks);
    for (int round = goesOn; round < ROUNDS + goesOn; ++round)
    {
        launch("LIST_NEIGHBOURS", std::string())
            .block(candidates)
            .block(marks_)
            .block(listed_)
            .runItems(pixels_.numbers({room, round}), room);
        for (size_t first = 0; first < (size_t)places; first += together)
        {
            const size_t count = std::min(together, places - first);
            GlLaunch counting = launch("COUNT_LISTED", mapOptions(2));
            counting.block(listed_).block(votes_, first * sizeof(uint), count * sizeof(uint));
            giveMap(counting, 2);
            counting.runItems(pixels_.numbers({room, round, (int)first, (int)count}), (size_t)most);
        }
        launch("TAKE_STEPS", windowed)
            .windows(votes_, bytes)
            .block(candidates)
            .runItems(pixels_.numbers({room, round}), room);
    }
    // A step is the pixels of a neighbourhood.
    const int pixels = std::max(frame.width, frame.height) + 2,
              steps = MOST_TURNS / ((2 * radius + 1) * (2 * radius + 1) * pixels) - 1;
    for (int k = 0; k < LAUNCHES_ALONE && steps > 0; ++k)
    {
        GlLaunch alone =
            launch("CLIMB_ON", define("STEPS", steps) + windowed + mapOptions((int)windows + 2));
        alone.windows(votes_, bytes).block(candidates).block(marks_);
        giveMap(alone, (int)windows + 2);
        alone.runItems(pixels_.numbers({room}), room);
    }
    return true;
}

void GlAscent::readBits(GlDevice& device, EdgeBits& bits)
{
    pack(device);
    device.finish();
    device.read(bits_, (size_t)EdgeBits::wordsOf(pixels_.frame) * sizeof(uint),
                bits.create(pixels_.frame));
}

} // namespace linespace
} // namespace cv

#endif // LINESPACE_OPENGL
