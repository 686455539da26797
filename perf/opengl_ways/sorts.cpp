// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "ways.hpp"

#include "gl_shaders_ways.hpp"

#include <climits>
#include <cstring>

namespace ways {

namespace {

using ls::Candidate;
using ls::define;
using ls::GlBuffer;
using ls::GlLaunch;

const int BLOCK = 1024; // of bitonic.glsl: 12 KiB of a group's memory, of which each has 16 KiB
const int DIGIT = 4;    // bits of radix.glsl

//! Candidates in an order, as a device sorts them: without a head.
bool areThere(ls::GlDevice& device, const GlBuffer& buffer, const std::vector<Candidate>& expected)
{
    std::vector<Candidate> read(expected.size());
    device.read(buffer, read.size() * sizeof(Candidate), read.data());
    return std::memcmp(read.data(), expected.data(), read.size() * sizeof(Candidate)) == 0;
}

Way bitonicWay(Input& input, const std::vector<Candidate>& list,
               const std::vector<Candidate>& sorted)
{
    int items = BLOCK, steps = 0, blocks = 1;
    while (items < (int)list.size())
        items *= 2;
    std::vector<Candidate> padded = list;
    padded.resize(items, {-1, INT_MAX, INT_MAX});
    for (int length = 2 * BLOCK; length <= items; length *= 2)
    {
        steps += ls::logOf(length / BLOCK);
        ++blocks;
    }
    const auto buffer = std::make_shared<GlBuffer>();
    const auto queue = [&input, buffer, items]()
    {
        const auto launch = [&](const char* kernel, int length, int span, size_t groups)
        {
            GlLaunch(input.device, bitonic_glsl, define(kernel) + define("BLOCK", BLOCK))
                .block(*buffer)
                .run({items, length, span}, groups);
        };
        launch("BLOCKS", 0, 0, items / BLOCK);
        for (int length = 2 * BLOCK; length <= items; length *= 2)
        {
            for (int span = length / 2; span >= BLOCK; span /= 2)
                launch("STEP", length, span, items / 2 / ls::GlDevice::GROUP);
            launch("MERGE", length, 0, items / BLOCK);
        }
    };
    const double log = ls::logOf(items), words = 3. * items * (steps + blocks);
    return {"sort", "bitonic",
            0,      [&input, buffer, padded]() { input.device.upload(padded, *buffer); },
            queue,  [&input, buffer, sorted]() { return areThere(input.device, *buffer, sorted); },
            false,  words,
            words,  items / 2. * log * (log + 1) / 2};
}

//! Of a list in the order of (s, e).
Way radixWay(Input& input, const std::vector<Candidate>& list, const std::vector<Candidate>& sorted)
{
    struct Buffers
    {
        GlBuffer lists[2], counts;
    };
    const auto buffers = std::make_shared<Buffers>();
    const int count = (int)list.size(),
              tiles = (count + ls::GlDevice::GROUP - 1) / ls::GlDevice::GROUP;
    int passes = 1;
    while (sorted.front().votes >> passes * DIGIT)
        ++passes;
    input.device.allocate(buffers->lists[1], count * sizeof(Candidate));
    input.device.allocate(buffers->counts, (tiles << DIGIT) * sizeof(int));
    const auto queue = [&input, buffers, count, tiles, passes]()
    {
        for (int pass = 0; pass < passes; ++pass)
        {
            const std::vector<int> numbers = {count, tiles, pass * DIGIT};
            const GlBuffer &from = buffers->lists[pass % 2], &to = buffers->lists[1 - pass % 2];
            GlLaunch(input.device, radix_glsl, define("COUNT"))
                .block(buffers->counts)
                .block(from)
                .run(numbers, tiles);
            GlLaunch(input.device, radix_glsl, define("SCAN"))
                .block(buffers->counts)
                .run(numbers, 1);
            GlLaunch(input.device, radix_glsl, define("SCATTER"))
                .block(buffers->counts)
                .block(from)
                .block(to)
                .run(numbers, tiles);
        }
    };
    const double counts = tiles << DIGIT;
    return {"sort",
            "radix",
            0,
            [&input, buffers, list]() { input.device.upload(list, buffers->lists[0]); },
            queue,
            [&input, buffers, sorted, passes]()
            { return areThere(input.device, buffers->lists[passes % 2], sorted); },
            false,
            passes * (4. * count + 3 * counts),
            passes * (3. * count + 2 * counts),
            passes * (double)count};
}

Way hostWay(const std::vector<Candidate>& list, const std::vector<Candidate>& sorted)
{
    const auto work = std::make_shared<std::vector<Candidate>>();
    const double words = 3. * (double)list.size();
    return {"sort",
            "on the host (the library)",
            0,
            [work, list]() { *work = list; },
            [work]() { std::sort(work->begin(), work->end(), ls::isStronger); },
            [work, sorted]() {
                return std::memcmp(work->data(), sorted.data(),
                                   sorted.size() * sizeof(Candidate)) == 0;
            },
            true,
            words,
            words,
            (double)list.size() * std::log2(std::max<double>(2, (double)list.size()))};
}

} // namespace

std::vector<Way> sortingWays(Input& input, int most)
{
    const std::vector<Candidate> sorted = strongestMaxima(input, most);
    if (sorted.empty())
        return {};
    std::vector<Candidate> list = sorted;
    std::sort(list.begin(), list.end(),
              [](const Candidate& a, const Candidate& b)
              { return a.s != b.s ? a.s < b.s : a.e < b.e; });
    std::vector<Way> ways = {hostWay(list, sorted), bitonicWay(input, list, sorted),
                             radixWay(input, list, sorted)};
    for (Way& way : ways)
        way.most = most;
    return ways;
}

} // namespace ways
