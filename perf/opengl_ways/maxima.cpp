// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "ways.hpp"

#include "gl_maxima.hpp"
#include "gl_shaders_ways.hpp"

#include <set>

namespace ways {

namespace {

using ls::Candidate;
using ls::Cell;
using ls::define;
using ls::GlBuffer;
using ls::GlLaunch;

//! As in reduction.glsl.
const int TILE = ls::GlDevice::GROUP * 32;
//! By a launch where tiles are kept: llvmpipe ends loops after 65536 turns, of which one takes
//! some hundreds.
const int TAKEN_AT_ONCE = 32;

ls::Wanted allUpTo(int most)
{
    ls::Wanted wanted;
    wanted.threshold = 0;
    wanted.most = most;
    return wanted;
}

void putInOrder(std::vector<Candidate>& candidates)
{
    std::sort(candidates.begin(), candidates.end(), ls::isStronger);
}

bool areSame(const std::vector<Candidate>& a, const std::vector<Candidate>& b)
{
    return a.size() == b.size() &&
           std::equal(a.begin(), a.end(), b.begin(),
                      [](const Candidate& one, const Candidate& other)
                      { return one.votes == other.votes && ls::isSameChord(one, other); });
}

int ringRadius(const Cell& frame, int radius)
{
    return std::min(radius, (frame.borderCount() - 1) / 2);
}

//! Maxima one after the other, by reductions of a copy of the table.
class Reduction
{
public:
    //! @param radius of what is deleted; negative: local maxima are found, and nothing around them.
    Reduction(Input& input, int most, int radius, bool keepsTiles)
        : input_(input), most_(most), keepsTiles_(keepsTiles), frame_(input.plan->frame()),
          chords_((int)frame_.chordCount()), tiles_((chords_ + TILE - 1) / TILE),
          copy_(define("COPY") + ls::windowOptions(input.device.limits(), bytesOf(input.last())) +
                (radius < 0 ? define("RING_RADIUS", -1) : std::string())),
          take_(define("TAKE") + define("DELETED_RADIUS", std::max(0, ringRadius(frame_, radius))) +
                (keepsTiles ? define("KEPT") : std::string()))
    {
        ls::GlDevice& device = input.device;
        device.allocate(left_, chords_ * sizeof(int));
        device.allocate(strongest_, 2 * tiles_ * sizeof(int));
    }

    void clear() { input_.device.upload(std::vector<Candidate>(1 + most_), taken_); }

    void run()
    {
        GlLaunch(input_.device, reduction_glsl, copy_)
            .windows(bufferOf(input_.last()), bytesOf(input_.last()))
            .block(left_)
            .runItems(numbers(0, 0), chords_);
        if (keepsTiles_)
        {
            reduce();
            for (int k = 0; k < most_; k += TAKEN_AT_ONCE)
                take(k, std::min(TAKEN_AT_ONCE, most_ - k));
        }
        else
            for (int k = 0; k < most_; ++k)
            {
                reduce();
                take(k, 1);
            }
    }

    std::vector<Candidate> found() { return readCandidates(input_.device, taken_); }

private:
    std::vector<int> numbers(int fifth, int sixth) const
    {
        return {chords_, frame_.width, frame_.height, tiles_, fifth, sixth};
    }
    void reduce()
    {
        GlLaunch(input_.device, reduction_glsl, define("REDUCE"))
            .block(left_)
            .block(strongest_)
            .run(numbers(0, 0), tiles_);
    }
    void take(int first, int count)
    {
        GlLaunch(input_.device, reduction_glsl, take_)
            .block(left_)
            .block(strongest_)
            .block(taken_)
            .run(numbers(first, count), 1);
    }

    Input& input_;
    const int most_;
    const bool keepsTiles_;
    const Cell frame_;
    const int chords_, tiles_;
    const std::string copy_, take_;
    GlBuffer left_, strongest_, taken_;
};

//! Tiles of the table that the neighbourhood of a chord touches.
size_t touchedTiles(const Cell& frame, const Candidate& candidate, int radius)
{
    std::set<size_t> tiles;
    const int points = frame.borderCount();
    for (int i = -radius; i <= radius; ++i)
        for (int j = -radius; j <= radius; ++j)
        {
            const int p = (candidate.s + i + points) % points,
                      q = (candidate.e + j + points) % points;
            if (frame.isChord(p, q))
                tiles.insert(frame.chordIndexOf(p, q) / TILE);
        }
    return tiles.size();
}

Way histogramWay(Input& input, const std::vector<Candidate>& expected, int most)
{
    struct Search
    {
        ls::GlMaxima maxima;
        std::vector<Candidate> found;
    };
    const auto search = std::make_shared<Search>();
    const auto queue = [&input, search, most]()
    {
        // Its time ends where the candidates would be counted.
        search->maxima.find(
            input.device, input.edges, *input.plan, bufferOf(input.last()), allUpTo(most),
            cv::linespace::SUPPRESS_RING, -1,
            [&](const GlBuffer&, int, bool) { input.device.stamp(); }, search->found);
    };
    const auto isRight = [search, expected]()
    {
        putInOrder(search->found);
        return areSame(search->found, expected);
    };
    const double chords = (double)input.plan->frame().chordCount();
    const bool isFew = most < chords / 32 && chords >= 31 * TILE;
    const double loads = chords * (1 + (isFew ? 1. / 32 : 0) + 2. / 32);
    return {"local maxima", "histogram (the library)",
            most,           nullptr,
            queue,          isRight,
            false,          loads,
            chords / 32,    loads};
}

Way reductionWay(Input& input, const std::vector<Candidate>& expected, int most, int radius,
                 bool keepsTiles)
{
    const auto reduction = std::make_shared<Reduction>(input, most, radius, keepsTiles);
    const Cell& frame = input.plan->frame();
    const double chords = (double)frame.chordCount(), tiles = std::ceil(chords / TILE);
    double loads = chords, stores = chords + 2 * tiles;
    for (const Candidate& candidate : expected)
    {
        const int deleted = std::max(radius, 0);
        loads += 2 * tiles +
                 (keepsTiles ? TILE * (double)touchedTiles(frame, candidate, deleted) : chords);
        stores += (2 * deleted + 1) * (2 * deleted + 1) + (keepsTiles ? 2 : 2 * tiles);
    }
    loads += keepsTiles ? chords : 0;
    return {radius < 0 ? "local maxima" : "neighbourhoods deleted",
            keepsTiles ? "reductions, tiles kept" : "reductions of the table",
            most,
            [reduction]() { reduction->clear(); },
            [reduction]() { reduction->run(); },
            [reduction, expected]() { return areSame(reduction->found(), expected); },
            false,
            loads,
            stores,
            loads};
}

} // namespace

std::vector<Candidate> readCandidates(ls::GlDevice& device, const GlBuffer& from)
{
    std::vector<Candidate> all(from.bytes() / sizeof(Candidate));
    device.read(from, all.size() * sizeof(Candidate), all.data());
    const size_t count = std::min<size_t>(all.front().votes, all.size() - 1);
    return std::vector<Candidate>(all.begin() + 1, all.begin() + 1 + count);
}

std::vector<Candidate> strongestMaxima(Input& input, int most)
{
    std::vector<Candidate> found =
        ls::findParallelMaxima(input.last(), input.plan->frame(), allUpTo(most));
    putInOrder(found);
    return found;
}

std::vector<Candidate> greedyMaxima(Input& input, int most, int radius)
{
    std::vector<Candidate> found = ls::findCandidates(input.last(), input.plan->frame(),
                                                      allUpTo(most), ls::SUPPRESS_GREEDY, radius);
    putInOrder(found);
    return found;
}

std::vector<Way> maximaWays(Input& input, int most, bool isSlow)
{
    const int radius = 2; // what a detector has
    const std::vector<Candidate> maxima = strongestMaxima(input, most),
                                 greedy = greedyMaxima(input, most, radius);
    std::vector<Way> ways = {histogramWay(input, maxima, most),
                             reductionWay(input, maxima, most, -1, true),
                             reductionWay(input, greedy, most, radius, true)};
    if (isSlow)
    {
        ways.push_back(reductionWay(input, maxima, most, -1, false));
        ways.push_back(reductionWay(input, greedy, most, radius, false));
    }
    return ways;
}

} // namespace ways
