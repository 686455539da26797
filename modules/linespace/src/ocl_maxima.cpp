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
    NUMBERS = 5
};
//! A cut for the search comes from one run of so many.
const int SAMPLE = 32;

const size_t THREE = 3 * sizeof(int);

static_assert(sizeof(Candidate) == THREE, "votes, s and e, as the device writes them");

} // namespace

bool DeviceMaxima::find(const EdgeMap& edges, const Plan& plan, const VoteTable& table,
                        const Wanted& wanted, int radius,
                        const std::function<void(const UMat&, int)>& count,
                        std::vector<Candidate>& found)
{
    if (wanted.accepts && !wanted.leastVotesDecide)
        return false;
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
    const bool isRequired = !wanted.leastVotes.empty();
    if (isRequired)
    {
        checkRasters(frame);
        upload(wanted.leastVotes, leastVotes_);
    }
    // On a ring of fewer points a neighbourhood would meet itself.
    const String options =
        format("-D VOTES=%s -D RADIUS=%d -D GROUP=%d", typeOf(table.depth),
               std::min(radius, (frame.borderCount() - 1) / 2), (int)Launch::GROUP);
    const auto launch = [&](const char* kernel)
    {
        return Launch(MAXIMA_PROGRAM, kernel, options);
    };
    const auto search = [&](int sample)
    {
        if (isRequired)
            Launch(MAXIMA_PROGRAM, "searchMaxima", options + " -D REQUIRED")
                .with(in(table.device), chords, frame.width, frame.height, in(leastVotes_),
                      image.width, image.height, in(numbers_), sample, inOut(histogram_),
                      out(masks_))
                .run(runs / sample, 1);
        else
            launch("searchMaxima")
                .with(in(table.device), chords, frame.width, frame.height, in(numbers_), sample,
                      inOut(histogram_), out(masks_))
                .run(runs / sample, 1);
    };
    launch("resetSearch").with(out(histogram_), bins, wanted.threshold, out(numbers_)).run(bins, 1);
    if (isFew)
    {
        search(SAMPLE);
        // Half as many again, as the maxima of strong lines stand together.
        const int rank = (most + most / 2) / SAMPLE + 1;
        launch("raiseCut").with(inOut(histogram_), bins, rank, inOut(numbers_)).run(1, 1);
    }
    search(1);
    if (isFew)
    {
        launch("checkCut")
            .with(inOut(histogram_), bins, most, wanted.threshold, inOut(numbers_))
            .run(1, 1);
        search(1);
    }
    launch("chooseLeast").with(in(histogram_), bins, most, inOut(numbers_)).run(1, 1);
    launch("countTiles")
        .with(in(table.device), in(masks_), runs, in(numbers_), out(counts_), tiles)
        .run(tiles, 1);
    launch("scanTiles").with(inOut(counts_), tiles).run(1, 1);

    // One read, if there are no more than the last time.
    int room = isFew ? most : std::min(most, room_);
    for (;; room = room_)
    {
        allocateOn(maxima_, (1 + (size_t)room) * THREE);
        launch("writeMaxima")
            .with(in(table.device), frame.width, frame.height, in(masks_), runs, in(numbers_),
                  in(counts_), tiles, out(maxima_), room)
            .run(tiles, 1);
        count(maxima_, room);
        found.resize(1 + (size_t)room);
        download(maxima_, found.size() * THREE, found.data());
        const int there = found.front().votes;
        if (there > room)
        {
            room_ = there;
            continue;
        }
        found.erase(found.begin());
        found.resize(there);
        return true;
    }
}

} // namespace linespace
} // namespace cv

#endif // HAVE_OPENCL
