// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "gl_maxima.hpp"

#ifdef LINESPACE_OPENGL

#include "gl_pixels.hpp"

namespace cv {
namespace linespace {

namespace {

//! As in maxima.glsl.
const int TILE = GlDevice::GROUP * 32;
const int NUMBERS = 8;
//! A search of a sample looks at one chord of so many.
const int SAMPLE = 32;

const size_t THREE = 3 * sizeof(int);
static_assert(sizeof(Candidate) == THREE, "votes, s and e, as the device writes them");

} // namespace

std::string windowOptions(const GlLimits& limits, size_t bytes)
{
    const int windows = (int)((bytes + limits.blockBytes - 1) / limits.blockBytes);
    int log = 0;
    while (((size_t)sizeof(uint) << (log + 1)) <= limits.blockBytes && log < 30)
        ++log;
    return define("WINDOWS", windows) + define("WINDOW_LOG", log) + define("BLOCK_A", windows) +
           define("BLOCK_B", windows + 1) + define("BLOCK_C", windows + 2);
}

void GlMaxima::release()
{
    state_.release();
    masks_.release();
    requirement_.release();
    maxima_.release();
}

//! What else is wanted than votes, as maxima.glsl reads it.
std::vector<int> GlMaxima::requirementOf(const Wanted& wanted)
{
    std::vector<int> numbers;
    if (wanted.ends)
        for (const Vec4i& ends : *wanted.ends)
            numbers.insert(numbers.end(), ends.val, ends.val + 4);
    for (const std::vector<int>& byLength : wanted.leastVotes)
        numbers.insert(numbers.end(), byLength.begin(), byLength.end());
    return numbers;
}

bool GlMaxima::find(GlDevice& device, const EdgeMap& edges, const Plan& plan, const GlBuffer& table,
                    const Wanted& wanted, int suppression, int radius,
                    const std::function<void(const GlBuffer&, int, bool)>& count,
                    std::vector<Candidate>& found)
{
    const Cell& frame = plan.frame();
    const Size image = plan.imageSize();
    const size_t tableBytes = frame.chordCount() * sizeof(uint);
    const std::vector<int> requirement = requirementOf(wanted);
    const bool isRequired = !requirement.empty();
    const size_t windows =
        (tableBytes + device.limits().blockBytes - 1) / device.limits().blockBytes;
    if ((int)windows + 3 > device.limits().blocks)
        return false;
    const int chords = (int)frame.chordCount(), tiles = chords / TILE + (chords % TILE > 0);
    const int most = (int)std::min<size_t>(wanted.most, chords);
    const bool isFew = most < chords / SAMPLE && tiles >= SAMPLE;
    const int bins = asShaderInt(
        (double)plan.level(plan.levelCount() - 1).maxVotes * (edges.weighted ? 255 : 1) + 1);
    const size_t stateBytes = (NUMBERS + (size_t)bins + 2 * (size_t)tiles) * sizeof(int),
                 maskBytes = (size_t)tiles * GlDevice::GROUP * sizeof(uint);
    if (std::max({stateBytes, maskBytes, requirement.size() * sizeof(int)}) >
        device.limits().blockBytes)
        return false;
    device.allocate(state_, stateBytes);
    device.allocate(masks_, maskBytes);
    if (isRequired)
        device.upload(requirement, requirement_);

    radius = mostRadius(frame, radius);
    const std::string tableOptions = windowOptions(device.limits(), tableBytes),
                      searchOptions =
                          define("SEARCH") + tableOptions + define("RING_RADIUS", radius) +
                          (suppression == SUPPRESS_BLOCKS ? define("SQUARE", blockSide(radius))
                                                          : std::string()) +
                          (wanted.leastVotes.empty() ? std::string() : define("REQUIRED")) +
                          (wanted.leastVotes.size() > 1 ? orientedOptions() : std::string()) +
                          (wanted.ends ? define("INTERVAL") : std::string());
    const auto numbers = [&](int fifth, int sixth, int seventh)
    {
        return std::vector<int>{chords, frame.width, frame.height, bins,
                                tiles,  fifth,       sixth,        seventh};
    };
    const auto search = [&](bool isSample)
    {
        GlLaunch launch(device, GL_MAXIMA, searchOptions);
        launch.windows(table, tableBytes).block(state_).block(masks_);
        if (isRequired)
            launch.block(requirement_);
        launch.run(numbers(isSample, image.width, image.height), tiles);
    };
    const auto decide = [&](const char* kernel, int fifth, int sixth)
    {
        GlLaunch(device, GL_MAXIMA, define(kernel)).block(state_).run(numbers(fifth, sixth, 0), 1);
    };
    GlLaunch(device, GL_MAXIMA, define("RESET"))
        .block(state_)
        .runItems(numbers(wanted.threshold, 0, 0), bins);
    if (isFew)
    {
        search(true);
        // Half as many again, as the maxima of strong lines stand together.
        decide("RAISE_CUT", (most + most / 2) / SAMPLE + 1, 0);
    }
    search(false);
    if (isFew)
    {
        decide("CHECK_CUT", most, wanted.threshold);
        search(false);
    }
    decide("CHOOSE_LEAST", most, 0);
    GlLaunch(device, GL_MAXIMA, define("COUNT") + tableOptions)
        .windows(table, tableBytes)
        .block(state_)
        .block(masks_)
        .run(numbers(0, 0, 0), tiles);
    decide("SCAN", 0, 0);

    // One read, if there are no more than the last time.
    int room = isFew ? most : std::min(most, room_);
    for (;; room = room_)
    {
        if ((1 + (size_t)room) * THREE > device.limits().blockBytes)
            return false;
        device.allocate(maxima_, (1 + (size_t)room) * THREE);
        GlLaunch(device, GL_MAXIMA, define("WRITE") + tableOptions)
            .windows(table, tableBytes)
            .block(state_)
            .block(masks_)
            .block(maxima_)
            .run(numbers(room, 0, 0), tiles);
        count(maxima_, room, false);
        device.finish();
        Candidate head;
        device.read(maxima_, THREE, &head);
        const int there = head.votes;
        if (there > room)
        {
            room_ = there;
            continue;
        }
        found.resize(1 + (size_t)there);
        device.read(maxima_, found.size() * THREE, found.data());
        const auto climbs = [](const Candidate& candidate)
        {
            return candidate.votes < 0;
        };
        while (std::any_of(found.begin(), found.end(), climbs))
        {
            count(maxima_, room, true);
            device.finish();
            device.read(maxima_, found.size() * THREE, found.data());
        }
        found.erase(found.begin());
        return true;
    }
}

} // namespace linespace
} // namespace cv

#endif // LINESPACE_OPENGL
