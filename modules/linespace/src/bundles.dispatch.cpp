// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The search by bundles: what is done with the inner loops of bundles.simd.hpp, in threads.

#include "bundles.hpp"
#include "ring_maxima.hpp"

#include "bundles.simd.hpp"
#include "bundles.simd_declarations.hpp"

#include <climits>
#include <cmath>
#include <functional>
#include <limits>

namespace cv {
namespace linespace {

namespace {

void poolVotes(const VoteTable& table, const Cell& cell, const Range& rows, BundleLevel& level)
{
    CV_CPU_DISPATCH(poolVotes, (table, cell, rows, level), CV_CPU_DISPATCH_MODES_ALL);
}

void mergeBounds(const Merge& merge, const BundleLevel& child, const Range& rows,
                 BundleLevel& parent)
{
    CV_CPU_DISPATCH(mergeBounds, (merge, child, rows, parent), CV_CPU_DISPATCH_MODES_ALL);
}

void require(const Merge& merge, const BundleLevel& parent, int part, int parts, BundleLevel& child)
{
    CV_CPU_DISPATCH(require, (merge, parent, part, parts, child), CV_CPU_DISPATCH_MODES_ALL);
}

size_t countNeeded(const Range& rows, const BundleLevel& level)
{
    CV_CPU_DISPATCH(countNeeded, (rows, level), CV_CPU_DISPATCH_MODES_ALL);
}

void assignSlots(const Merge* merge, const Range& rows, int slot, BundleLevel& level)
{
    CV_CPU_DISPATCH(assignSlots, (merge, rows, slot, level), CV_CPU_DISPATCH_MODES_ALL);
}

void takeVotes(const VoteTable& table, const Cell& cell, const Range& rows, BundleLevel& level)
{
    CV_CPU_DISPATCH(takeVotes, (table, cell, rows, level), CV_CPU_DISPATCH_MODES_ALL);
}

void mergeVotes(const Merge& merge, const BundleLevel& child, const Range& rows,
                BundleLevel& parent)
{
    CV_CPU_DISPATCH(mergeVotes, (merge, child, rows, parent), CV_CPU_DISPATCH_MODES_ALL);
}

void collectAbove(int votes, bool isAlone, const Range& rows, const BundleLevel& level,
                  std::vector<Candidate>& found)
{
    CV_CPU_DISPATCH(collectAbove, (votes, isAlone, rows, level, found), CV_CPU_DISPATCH_MODES_ALL);
}

//! So many bundles tell how many survive a cut.
const size_t SAMPLES = 1 << 14;
//! Of a level's bundles, in percent: where more are needed tables are faster.
const int MOST_COUNTED = 50;

//! Calls work(rows) for blocks of rows of bundles, in parallel.
template<class Work>
void forRows(const BundleLevel& level, Work work)
{
    const int rows = level.coarse.firstPoint(SIDE_LEFT), perTask = 8;
    parallel_for_(Range(0, (rows + perTask - 1) / perTask), [&](const Range& range)
                  { work(Range(range.start * perTask, std::min(rows, range.end * perTask))); });
}

//! Slots for the bundles that are needed, in order, and room for their votes; false if these are
//! too many.
bool makeRoom(const Merge* merge, BundleLevel& level)
{
    const int rows = level.coarse.firstPoint(SIDE_LEFT), perTask = 32;
    const int tasks = (rows + perTask - 1) / perTask;
    const auto rowsOf = [&](int task)
    {
        return Range(task * perTask, std::min(rows, (task + 1) * perTask));
    };
    std::vector<size_t> slots(tasks + 1, 0);
    parallel_for_(Range(0, tasks),
                  [&](const Range& range)
                  {
                      for (int task = range.start; task < range.end; ++task)
                          slots[task + 1] = countNeeded(rowsOf(task), level);
                  });
    for (int task = 0; task < tasks; ++task)
        slots[task + 1] += slots[task];
    if (slots[tasks] > level.bundleCount() * MOST_COUNTED / 100)
        return false;
    level.votes.allocate(slots[tasks] * BUNDLE_CHORDS * sizeof(ushort));
    level.crossed.allocate(slots[tasks] * sizeof(BundleLevel::Crossed));
    parallel_for_(Range(0, tasks),
                  [&](const Range& range)
                  {
                      for (int task = range.start; task < range.end; ++task)
                          assignSlots(merge, rowsOf(task), (int)slots[task], level);
                  });
    return true;
}

//! The last level's votes that were counted, as a function on the ring of border points: any two of
//! them, in either order; 0 where they were not.
struct CountedVotes
{
    const BundleLevel& level;
    const Cell frame;

    int operator()(int p, int q) const
    {
        const int s = std::min(p, q), e = std::max(p, q);
        if (!frame.isChord(s, e))
            return 0;
        const size_t bundle = level.coarse.chordIndex(s / BUNDLE_SIDE, e / BUNDLE_SIDE);
        return level.required[bundle] == BundleLevel::NOT_NEEDED
                   ? 0
                   : level.votesOf(bundle)[s % BUNDLE_SIDE * BUNDLE_SIDE + e % BUNDLE_SIDE];
    }
};

//! The least of any bin.
std::vector<int> leastOfBins(const std::vector<std::vector<int>>& votes)
{
    std::vector<int> least;
    for (size_t bin = 0; bin < votes.size(); ++bin)
        if (bin == 0)
            least = votes[bin];
        else
            for (size_t length = 0; length < least.size(); ++length)
                least[length] = std::min(least[length], votes[bin][length]);
    return least;
}

} // namespace

int BundleSearch::baseLevel(const Plan& plan, bool weighted)
{
    const int last = plan.levelCount() - 1;
    for (int base = std::max(0, last - BUNDLE_LEVELS); base < last; ++base)
    {
        const Level& level = plan.level(base);
        // A chord crosses fewer cells than there are in a row and a column.
        const double most =
            (double)level.maxVotes * (weighted ? 255 : 1) * (level.grid.width + level.grid.height);
        if (level.cell.width % BUNDLE_SIDE == 0 && level.cell.height % BUNDLE_SIDE == 0 &&
            most < USHRT_MAX)
            return base;
    }
    return -1;
}

//! Bytes of slots and of both bounds, of all bundles.
double BundleSearch::roomBytes(const Plan& plan, int base)
{
    double chords = 0;
    for (int l = base; l < plan.levelCount(); ++l)
        chords += (double)plan.level(l).tableSize();
    return chords / BUNDLE_CHORDS * (sizeof(int) + 2 * sizeof(ushort));
}

double BundleSearch::memory(const Plan& plan, int base)
{
    const double room = roomBytes(plan, base);
    const double bundles = room / (sizeof(int) + 2 * sizeof(ushort));
    const double chords = (double)plan.frame().chordCount();
    return MOST_COUNTED / 100. * bundles *
               (BUNDLE_CHORDS * sizeof(ushort) + sizeof(BundleLevel::Crossed)) +
           chords / BUNDLE_CHORDS * sizeof(ushort) + std::max(0., room - chords);
}

void BundleSearch::clear()
{
    for (int i = 0; i <= BUNDLE_LEVELS; ++i)
    {
        levels_[i].crossed.release();
        levels_[i].votes.release();
    }
    std::vector<ushort>().swap(least_);
    std::vector<int>().swap(histogram_);
    size_ = Size();
}

bool BundleSearch::isWorthATry(Size size)
{
    if (size_ != size)
    {
        size_ = size;
        usual_ = -1;
        pause_ = rest_ = 0;
    }
    if (rest_ == 0)
        return true;
    --rest_;
    return false;
}

void BundleSearch::bound(const Plan& plan, int base, const VoteTable& table, Buffer& room)
{
    top_ = plan.levelCount() - 1 - base;
    cell_ = plan.level(base).cell;
    room.allocate((size_t)roomBytes(plan, base));
    int* next = (int*)room.data();
    for (int i = 0; i <= top_; ++i)
    {
        const Level& shape = plan.level(base + i);
        BundleLevel& level = levels_[i];
        level.coarse = Cell(shape.cell.width / BUNDLE_SIDE, shape.cell.height / BUNDLE_SIDE);
        level.cells = shape.cellCount();
        level.cellBits = 0;
        while ((size_t)1 << level.cellBits < level.cells)
            ++level.cellBits;
        level.slots = next;
        level.bounds = (ushort*)(next + level.bundleCount());
        level.required = level.bounds + level.bundleCount();
        next += 2 * level.bundleCount();
        if (i == 0)
        {
            forRows(level, [&](const Range& rows) { poolVotes(table, cell_, rows, level); });
            continue;
        }
        merges_[i - 1] = plan.merge(base + i);
        forRows(level, [&](const Range& rows)
                { mergeBounds(merges_[i - 1], levels_[i - 1], rows, level); });
    }
}

/** Finds the votes that any chord of each bundle of the last level needs, and counts the bounds of a
sample of those that can have as many. */
void BundleSearch::setLeast(const Plan& plan, const Wanted& wanted, int radius)
{
    const BundleLevel& last = levels_[top_];
    const Cell &coarse = last.coarse, &frame = plan.frame();
    least_.resize(wanted.leastVotes.empty() ? 0 : last.bundleCount());
    const std::vector<int> leastVotes = leastOfBins(wanted.leastVotes);
    if (!least_.empty())
        forRows(last,
                [&](const Range& rows)
                {
                    std::vector<int> lengths;
                    for (int s = rows.start; s < rows.end; ++s)
                    {
                        ushort* least = &least_[coarse.rowStart(s)];
                        for (int side = coarse.sideOf(s) + 1; side <= SIDE_LEFT; ++side)
                        {
                            const int count = coarse.pointCount(side);
                            lengths.resize(count);
                            // A chord that is refused can still be stronger than a neighbour that
                            // is not.
                            plan.leastVisibleLengths(
                                BUNDLE_SIDE * s, frame.firstPoint(side), BUNDLE_SIDE, count,
                                BUNDLE_SIDE - 1 + std::max(radius, 1), lengths.data());
                            for (int i = 0; i < count; ++i)
                                *least++ = (ushort)std::min<int>(leastVotes[lengths[i]],
                                                                 BundleLevel::NOT_NEEDED);
                        }
                    }
                });
    histogram_.assign(USHRT_MAX + 1, 0);
    RNG random(1); // no period that a pattern could have as well
    sampleStep_ = 1 + last.bundleCount() / SAMPLES;
    for (size_t i = 0; i < last.bundleCount(); i += random.uniform(1, 2 * (int)sampleStep_))
        if (least_.empty() || last.bounds[i] >= least_[i])
            ++histogram_[last.bounds[i]];
    while (histogram_.size() > 1 && histogram_.back() == 0)
        histogram_.pop_back();
}

//! About how many bundles of the last level can have chords with more votes than the cut.
size_t BundleSearch::survivors(int cut) const
{
    size_t count = 0;
    for (int votes = (int)histogram_.size() - 1; votes > cut; --votes)
        count += histogram_[votes];
    return sampleStep_ * count;
}

//! The largest cut with about that many survivors, but not less than `least`.
int BundleSearch::cutFor(size_t count, int least) const
{
    int cut = (int)histogram_.size() - 1;
    for (size_t above = 0; cut > least; --cut)
    {
        above += sampleStep_ * histogram_[cut];
        if (above >= count)
            break;
    }
    return std::max(cut - 1, least);
}

//! Requires those bundles of the last level that can have chords with more votes than the cut.
void BundleSearch::requireAbove(int cut)
{
    BundleLevel& last = levels_[top_];
    const int needed = cut + 1;
    const int count = (int)last.bundleCount(), perTask = 1 << 14;
    parallel_for_(Range(0, (count + perTask - 1) / perTask),
                  [&](const Range& range)
                  {
                      const int end = std::min(count, range.end * perTask);
                      for (int i = range.start * perTask; i < end; ++i)
                      {
                          const int votes =
                              least_.empty() ? needed : std::max<int>(needed, least_[i]);
                          last.required[i] =
                              (ushort)(last.bounds[i] >= votes ? votes : BundleLevel::NOT_NEEDED);
                      }
                  });
}

//! Counts the chords of the bundles that the last level requires; false if too many others have to
//! be, for that.
bool BundleSearch::count(const VoteTable& table)
{
    BundleLevel& last = levels_[top_];
    if (!makeRoom(&merges_[top_ - 1], last))
        return false;
    for (int i = top_; i > 0; --i)
    {
        BundleLevel& child = levels_[i - 1];
        std::fill(child.required, child.required + child.bundleCount(),
                  (ushort)BundleLevel::NOT_NEEDED);
        // Each part looks at all bundles of the parent, so there are not many.
        const int parts = std::max(1, std::min(4, getNumThreads()));
        parallel_for_(Range(0, parts),
                      [&](const Range& range)
                      {
                          for (int part = range.start; part < range.end; ++part)
                              require(merges_[i - 1], levels_[i], part, parts, child);
                      });
        if (!makeRoom(i > 1 ? &merges_[i - 2] : 0, child))
            return false;
    }
    for (int i = 0; i <= top_; ++i)
    {
        BundleLevel& level = levels_[i];
        forRows(level,
                [&](const Range& rows)
                {
                    if (i == 0)
                        takeVotes(table, cell_, rows, level);
                    else
                        mergeVotes(merges_[i - 1], levels_[i - 1], rows, level);
                });
    }
    return true;
}

bool BundleSearch::find(const Plan& plan, const Wanted& wanted, int radius, const VoteTable& table,
                        std::vector<Candidate>& found)
{
    setLeast(plan, wanted, radius);
    const size_t most = levels_[top_].bundleCount() * MOST_COUNTED / 100;
    const bool all = wanted.most == std::numeric_limits<size_t>::max();
    int cut = all || usual_ < wanted.threshold ? wanted.threshold : usual_;
    if (!all && usual_ < 0)
        cut = cutFor(wanted.most, wanted.threshold);
    for (;;)
    {
        bool isCounted = cut >= 0 && survivors(cut) <= most;
        if (isCounted)
        {
            requireAbove(cut);
            isCounted = count(table);
        }
        if (!isCounted)
        {
            pause_ = rest_ = std::min(16, std::max(1, 2 * pause_));
            return false;
        }
        maxima(cut, wanted, radius, found);
        if (cut == wanted.threshold || found.size() >= wanted.most)
        {
            pause_ = 0;
            usual_ = all ? -1 : usualCut(found, wanted, cut);
            keepStrongest(found, wanted.most);
            return true;
        }
        cut = lowerCut(found, wanted, cut);
    }
}

//! The cut that would have let a few more candidates through than are wanted.
int BundleSearch::usualCut(const std::vector<Candidate>& found, const Wanted& wanted, int cut)
{
    const size_t enough = wanted.most + wanted.most / 16;
    if (enough >= found.size())
        return cut;
    std::vector<int> votes(found.size());
    for (size_t i = 0; i < found.size(); ++i)
        votes[i] = found[i].votes;
    std::nth_element(votes.begin(), votes.begin() + enough, votes.end(), std::greater<int>());
    return votes[enough] - 1;
}

/** A lower cut that lets as many candidates through as are wanted. Their number grows as a power of
that of the survivors, which is known for every cut: the cut that had half as many as this one tells
the power. -1: these would be all bundles and more. */
int BundleSearch::lowerCut(const std::vector<Candidate>& found, const Wanted& wanted, int cut) const
{
    const size_t now = survivors(cut);
    const int higher = cutFor(now / 2, cut);
    size_t above = 0;
    for (size_t i = 0; i < found.size(); ++i)
        above += found[i].votes > higher;
    const double lacking = 1.1 * wanted.most / std::max<size_t>(1, found.size());
    const double doublings = above > 16
                                 ? std::log2(lacking) * std::log2((double)now / survivors(higher)) /
                                       std::log2((double)found.size() / above)
                                 : 2;
    // Not more than four times as many at once: far ahead nothing is known, but that it is far.
    if (now * std::exp2(doublings) > 2. * levels_[top_].bundleCount())
        return -1;
    const double factor = std::exp2(std::min(2., std::max(0.1, doublings)));
    return std::min(cut - 1, cutFor((size_t)(now * factor) + 1, wanted.threshold));
}

void BundleSearch::maxima(int cut, const Wanted& wanted, int radius,
                          std::vector<Candidate>& found) const
{
    const BundleLevel& level = levels_[top_];
    const CountedVotes votes = {level, merges_[top_ - 1].parent};
    const auto isMaximum = [&](const Candidate& candidate)
    {
        return (radius < 0 ? isParallelMaximum(votes, votes.frame, candidate)
                           : isRingMaximum(votes, votes.frame, candidate, radius)) &&
               (!wanted.accepts || wanted.accepts(candidate));
    };
    const int rows = level.coarse.firstPoint(SIDE_LEFT), perTask = 16;
    const int tasks = (rows + perTask - 1) / perTask;
    std::vector<std::vector<Candidate>> parts(tasks);
    parallel_for_(Range(0, tasks),
                  [&](const Range& range)
                  {
                      for (int task = range.start; task < range.end; ++task)
                      {
                          std::vector<Candidate>& part = parts[task];
                          const int begin = task * perTask;
                          collectAbove(cut, radius == 0,
                                       Range(begin, std::min(rows, begin + perTask)), level, part);
                          part.resize(std::partition(part.begin(), part.end(), isMaximum) -
                                      part.begin());
                      }
                  });
    found.clear();
    for (int task = 0; task < tasks; ++task)
        found.insert(found.end(), parts[task].begin(), parts[task].end());
}

} // namespace linespace
} // namespace cv
