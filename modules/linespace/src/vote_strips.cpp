// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "vote_strips.hpp"

namespace cv {
namespace linespace {

namespace {

const int PARALLEL = ChordCounter::PARALLEL;

int blocksOf(int length)
{
    return (length + PARALLEL - 1) / PARALLEL;
}

double stripCount(const Cell& frame)
{
    return (2. * frame.width - 1) * blocksOf(frame.width) +
           (2. * frame.height - 1) * blocksOf(frame.height);
}

} // namespace

double VoteStrips::memory(const Cell& frame)
{
    return stripCount(frame) * sizeof(int);
}

double VoteStrips::stripMemory(const Cell& frame, double strips)
{
    // A vector that grows holds its old contents as well for a moment.
    return std::min(strips, stripCount(frame)) * 2 * PARALLEL * sizeof(int);
}

void VoteStrips::clear()
{
    std::vector<int>().swap(slots_);
    std::vector<size_t>().swap(wanted_);
    std::vector<int>().swap(votes_);
}

void VoteStrips::reset(const Cell& frame)
{
    frame_ = frame;
    size_t strips = 0;
    for (int i = 0; i < 2; ++i)
    {
        Pair& pair = pairs_[i];
        pair.length = frame.pointCount(i);
        pair.blocks = blocksOf(pair.length);
        pair.firstStrip = strips;
        pair.firstS = frame.firstPoint(i);
        pair.lastE = frame.firstPoint(i + 2) + pair.length - 1;
        strips += (2 * (size_t)pair.length - 1) * pair.blocks;
    }
    slots_.assign(strips, -1);
    wanted_.clear();
    votes_.clear();
}

bool VoteStrips::hasNeighbourhood(Chord chord, int radius) const
{
    const int side = frame_.sideOf(chord.s);
    if (side > SIDE_RIGHT || frame_.sideOf(chord.e) != side + 2)
        return false;
    const Pair& pair = pairs_[side];
    const int u = chord.s - pair.firstS, v = pair.lastE - chord.e;
    return std::min(u, v) >= radius && std::max(u, v) + radius < pair.length;
}

void VoteStrips::want(Chord chord, int radius)
{
    const Place place = placeOf(chord);
    for (int family = -2 * radius; family <= 2 * radius; ++family)
    {
        // The chords of a family in the neighbourhood, i + j = family.
        const int first = std::max(-radius, family - radius),
                  last = std::min(radius, family + radius);
        const size_t begin = stripOf(place, place.u + first, family),
                     end = stripOf(place, place.u + last, family);
        for (size_t strip = begin; strip <= end; ++strip)
            if (slots_[strip] < 0)
            {
                slots_[strip] = (int)(votes_.size() / PARALLEL + wanted_.size());
                wanted_.push_back(strip);
            }
    }
}

void VoteStrips::countWanted(const ChordCounter& counter)
{
    if (wanted_.empty())
        return;
    const size_t before = votes_.size();
    votes_.reserve(before + wanted_.size() * PARALLEL); // not more; it is asked for a few times
    votes_.resize(before + wanted_.size() * PARALLEL);
    // Strips that were asked for together are near one another.
    const int atOnce = ChordCounter::MOST_PARALLEL;
    const auto countRange = [&](const Range& range)
    {
        ChordCounter::ParallelChords chords[atOnce];
        for (int i = range.start; i < range.end; ++i)
        {
            const size_t first = (size_t)i * atOnce;
            const int count = (int)std::min<size_t>(atOnce, wanted_.size() - first);
            for (int k = 0; k < count; ++k)
                chords[k] = chordsOf(wanted_[first + k]);
            counter.countParallel(chords, count, &votes_[before + first * PARALLEL]);
        }
    };
    const Range all(0, (int)((wanted_.size() + atOnce - 1) / atOnce));
    if (all.end < 4) // not worth waking up other threads
        countRange(all);
    else
        parallel_for_(all, countRange);
    wanted_.clear();
}

ChordCounter::ParallelChords VoteStrips::chordsOf(size_t strip) const
{
    const Pair& pair = pairs_[strip >= pairs_[1].firstStrip];
    const size_t own = strip - pair.firstStrip;
    const int family = (int)(own / pair.blocks), first = (int)(own % pair.blocks) * PARALLEL;
    // The first of its chords that does not begin or end before the sides do.
    const int shift = family - (pair.length - 1), u = std::max(first, shift);
    const ChordCounter::ParallelChords result = {{pair.firstS + u, pair.lastE - (u - shift)},
                                                 u - first};
    return result;
}

} // namespace linespace
} // namespace cv
