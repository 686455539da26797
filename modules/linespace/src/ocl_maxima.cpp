// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "ocl_maxima.hpp"

#include <cvconfig.h>

#ifdef HAVE_OPENCL

#include "ocl_launch.hpp"

namespace cv {
namespace linespace {

namespace {

//! As in maxima.cl.
enum
{
    RUN = 32,
    TILE = 64,
    USUAL = 3,
    NUMBERS = 5
};

//! The first image's cut comes from one run or block of so many.
const int SAMPLE = 32;

const int LEAST_ROOM = 1 << 12;

const size_t THREE = 3 * sizeof(int);

static_assert(sizeof(Candidate) == THREE, "votes, s and e, as the device writes them");

} // namespace

void DeviceMaxima::find(const EdgeMap& edges, const Plan& plan, const VoteTable& table,
                        const Wanted& wanted, int suppression, int radius,
                        const PrunedVotes* pruned,
                        const std::function<void(const UMat&, int)>& count,
                        std::vector<Candidate>& found)
{
    const Cell& frame = plan.frame();
    const Size image = plan.imageSize();
    const int chords = (int)table.chords, runs = (chords + RUN - 1) / RUN;
    const int tiles = (runs + TILE - 1) / TILE;
    const int most = (int)std::min<size_t>(wanted.most, table.chords);
    const bool isFew = most < chords / SAMPLE && runs >= SAMPLE;
    const int bins =
        asInt((double)plan.level(plan.levelCount() - 1).maxVotes * (edges.weighted ? 255 : 1) + 1);
    allocateOn(histogram_, bins * sizeof(int));
    allocateOn(numbers_, NUMBERS * sizeof(int));
    allocateOn(masks_, runs * sizeof(uint));
    allocateOn(counts_, tiles * sizeof(Vec2i));
    const int requiredBins = (int)wanted.leastVotes.size();
    if (requiredBins > 0)
    {
        checkRasters(frame);
        std::vector<int> leastVotes;
        for (const std::vector<int>& byLength : wanted.leastVotes)
            leastVotes.insert(leastVotes.end(), byLength.begin(), byLength.end());
        uploadNew(leastVotes, leastVotesList_, leastVotes_);
    }
    if (wanted.ends)
        uploadNew(*wanted.ends, endsList_, ends_);
    radius = mostRadius(frame, radius);
    String options = format("-D VOTES=%s -D RADIUS=%d -D GROUP=%d", typeOf(table.depth), radius,
                            (int)Launch::GROUP);
    if (suppression == SUPPRESS_BLOCKS)
        options += format(" -D SQUARE=%d", blockSide(radius));
    const auto launch = [&](const char* kernel)
    {
        return Launch(MAXIMA_PROGRAM, kernel, options);
    };
    const String required = String(requiredBins > 0 ? " -D REQUIRED" : "") +
                            (requiredBins > 1 ? directionBinOptions() : String()) +
                            (wanted.ends ? " -D INTERVAL" : "");
    const auto require = [&](Launch& search)
    {
        if (requiredBins > 0)
            search.with(in(leastVotes_), (int)wanted.leastVotes.front().size(), image.width,
                        image.height);
        if (wanted.ends)
            search.with(in(ends_));
    };
    const auto searchAbove = [&](int cut, int sample)
    {
        launch("resetSearch")
            .with(out(histogram_), bins, out(masks_), runs, out(numbers_))
            .run(std::max(bins, runs), 1);
        if (!pruned)
        {
            Launch search(MAXIMA_PROGRAM, "searchMaxima", options + required);
            search.with(in(table.device), chords, frame.width, frame.height);
            require(search);
            search.with(cut, sample, inOut(histogram_), out(masks_)).run(runs / sample, 1);
            return;
        }
        pruned->count(cut, sample);
        const int run = isProcessor() ? 16 : 1;
        Launch search(MAXIMA_PROGRAM, "searchBlocks",
                      options + required + format(" -D BLOCK=%d -D PIECES=%d", pruned->block, run));
        search.with(in(table.device), in(pruned->needed()), frame.width, frame.height);
        require(search);
        search.with(cut, inOut(histogram_), out(masks_), inOut(numbers_))
            .run((frame.rowLength(SIDE_TOP) / 8 + run - 1) / run,
                 frame.firstPoint(SIDE_LEFT) / pruned->block, run > 1);
    };

    const auto chooseLeast = [&](int rank)
    {
        launch("chooseLeast").with(in(histogram_), bins, rank, inOut(numbers_)).run(1, 1);
    };

    if (isFew && usual_ < 0)
    {
        // Half as many again, as the maxima of strong lines stand together.
        searchAbove(wanted.threshold, SAMPLE);
        chooseLeast((most + most / 2) / SAMPLE + 1);
        int numbers[NUMBERS];
        download(numbers_, sizeof(numbers), numbers);
        usual_ = numbers[USUAL];
    }
    int cut = isFew ? std::max(usual_, wanted.threshold) : wanted.threshold;
    // One read, if the last image's cut and room are enough.
    int room = isFew ? most : std::min(most, room_);
    for (;;)
    {
        searchAbove(cut, 1);
        chooseLeast(most);
        launch("countTiles")
            .with(in(table.device), in(masks_), runs, in(numbers_), out(counts_), tiles)
            .run(tiles, 1);
        launch("scanTiles").with(inOut(counts_), tiles).run(1, 1);
        allocateOn(maxima_, (1 + (size_t)room) * THREE);
        launch("writeMaxima")
            .with(in(table.device), frame.width, frame.height, in(masks_), runs, in(numbers_),
                  in(counts_), tiles, out(maxima_), room)
            .run(tiles, 1);
        count(maxima_, room);
        found.resize(1 + (size_t)room);
        download(maxima_, found.size() * THREE, found.data());
        const Candidate head = found.front();
        if (head.votes < most && cut > wanted.threshold)
        {
            cut = wanted.threshold;
            continue;
        }
        // The next image may have somewhat more, and is to need one search.
        if (!isFew)
            room_ = asInt(std::max<double>(LEAST_ROOM, 1.25 * head.votes));
        if (head.votes > room)
        {
            room = std::min(most, room_);
            continue;
        }
        // Of a cut that was too low nothing is to be learnt.
        if (pruned && (!isFew || head.s <= cut))
            pruned->learn(head.e);
        if (isFew)
            usual_ = std::max(0, head.s);
        found.erase(found.begin());
        found.resize(head.votes);
        return;
    }
}

} // namespace linespace
} // namespace cv

#endif // HAVE_OPENCL
