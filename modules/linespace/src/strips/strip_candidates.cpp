// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "strip_candidates.hpp"

#include "../angle_ends.hpp"
#include "../exact/climb.hpp"
#include "../exact/end_index.hpp"
#include "../exact/parallel_band.hpp"
#include "strip_kernels_generic.hpp"

#include <cmath>
#include <functional>
#include <limits>

namespace cv {
namespace linespace {

namespace {

const size_t ALL = std::numeric_limits<size_t>::max();

//! The strips must give at least this share of the votes that are required.
const double STRIP_SHARE = 0.75;

//! Chords that climb at the same time, whatever the number of threads.
const size_t ROUND = 32;

//! Where so many lines were found, chords are left out that hardly have enough votes: an edge of one
//! pixel has a third more votes on one chord than on the next, but where it is the only line, few
//! others are in its place.
const size_t MANY = 8;

//! The exact votes that a chord hardly exceeds which the strips give so many.
int mostExact(int votes)
{
    return votes + votes / 10 + 2;
}

//! The same for a chord of the image that is near one of a family with so many exact votes: the two
//! are sampled differently.
int mostNearby(int votes, bool isStrict)
{
    return votes + votes / (isStrict ? 16 : 3) + 2;
}

//! The smallest bundles, by T, whose chords may have a line in the interval, and some around them.
Range slopesIn(const AngleInterval& angles, const StripFamily& family)
{
    const int reach = family.strips * STRIP / LEAF_BUNDLE, margin = 1;
    if (angles.isFull())
        return Range(-reach, reach);
    int first = reach, last = -reach;
    for (int T = -reach; T < reach; ++T)
    {
        const double from = std::atan2((T - margin) * LEAF_BUNDLE, (double)family.width()),
                     to = std::atan2((T + 1 + margin) * LEAF_BUNDLE, (double)family.width());
        // The normal is a quarter of a turn from the chord, whose angle is counted from the other axis
        // the other way round where that is the major one.
        const double least = family.xMajor ? from + CV_PI / 2 : -to,
                     most = family.xMajor ? to + CV_PI / 2 : -from;
        // The first angle from `least` on, by half turns, that is not below the interval.
        const double turns = std::ceil((angles.min - most) / CV_PI);
        if (least + turns * CV_PI <= angles.max)
        {
            first = std::min(first, T);
            last = std::max(last, T);
        }
    }
    return first <= last ? Range(first, last + 1) : Range(0, 0);
}

StripRequest requestFor(const Plan& plan, const StripWanted& wanted)
{
    const Size image = plan.imageSize();
    StripRequest request;
    const int threshold = wanted.requirement.threshold;
    request.threshold = cvFloor(STRIP_SHARE * threshold);
    const size_t subBundles =
        std::max<size_t>(1024, 13 * (size_t)(image.width + image.height) / 10);
    request.bundles = wanted.lines == 0 ? ALL : 512 + 4 * wanted.lines;
    request.subBundles =
        wanted.lines == 0 ? ALL : subBundles * std::max<size_t>(100, wanted.lines) / 100;
    request.square = wanted.lines == 0 ? 2 : 4;
    // A bundle may hold chords of any bin, so the bin that requires the fewest votes counts.
    std::vector<int> least;
    const std::vector<std::vector<int>> byBin = wanted.requirement.leastVotes(STRIP_SHARE);
    for (size_t bin = 0; bin < byBin.size(); ++bin)
    {
        if (bin == 0)
            least = byBin[0];
        for (size_t i = 0; i < least.size(); ++i)
            least[i] = std::min(least[i], byBin[bin][i]);
    }
    for (int k = 0; k < 2; ++k)
    {
        request.leastVotes[k] = least;
        request.slopes[k] = slopesIn(wanted.angles, StripFamily(image, k == 0));
    }
    return request;
}

//! A chord of a family, and the maximum that it comes to.
struct Attempt
{
    StripChord chord;
    Chord from; //!< the same in the image
    bool isFound;
    Candidate maximum;
};

//! The votes of the wanted lines that were found: how many another one needs to be among them.
class Best
{
public:
    Best(int threshold, size_t lines) : threshold_(threshold), lines_(lines) {}
    bool isFull() const { return lines_ > 0 && votes_.size() >= lines_; }
    int needed() const { return isFull() ? std::max(votes_[0], threshold_ + 1) : threshold_ + 1; }
    void add(int votes)
    {
        if (lines_ == 0)
            return;
        votes_.push_back(votes);
        std::push_heap(votes_.begin(), votes_.end(), std::greater<int>());
        if (votes_.size() <= lines_)
            return;
        std::pop_heap(votes_.begin(), votes_.end(), std::greater<int>());
        votes_.pop_back();
    }

private:
    const int threshold_;
    const size_t lines_;
    std::vector<int> votes_; // a heap, the fewest first
};

//! The chords in their total order, which is made as far as it is asked for.
class Queue
{
public:
    //! @param chords by votes.
    explicit Queue(std::vector<StripChord>& chords) : chords_(chords), next_(0), ordered_(0) {}
    bool empty() const { return next_ == chords_.size(); }
    const StripChord& front()
    {
        if (next_ == ordered_)
        {
            while (ordered_ < chords_.size() && chords_[ordered_].votes == chords_[next_].votes)
                ++ordered_;
            std::sort(chords_.begin() + next_, chords_.begin() + ordered_, precedes);
        }
        return chords_[next_];
    }
    void pop() { ++next_; }

private:
    std::vector<StripChord>& chords_;
    size_t next_, ordered_;
};

void climb(const EdgePlanes& planes, const StripFamily families[2], int needed, bool isStrict,
           bool isReference, std::vector<Attempt>& round)
{
    parallel_for_(
        Range(0, (int)round.size()),
        [&](const Range& range)
        {
            ParallelClimber parallels(planes, isReference);
            Climber climber(planes, isReference);
            for (int i = range.start; i < range.end; ++i)
            {
                Attempt& attempt = round[i];
                StripChord& chord = attempt.chord;
                const StripFamily& family = families[chord.family];
                attempt.isFound = false;
                if (ParallelClimber::canClimb(family) && !planes.isWeighted())
                {
                    const int votes = parallels.climb(family, chord.y, chord.t);
                    if (mostNearby(votes, isStrict) < needed ||
                        !family.imageChord(chord.y, chord.t, attempt.from))
                        continue;
                }
                attempt.isFound = true;
                attempt.maximum = climber.climb(attempt.from);
            }
        },
        2 * std::max(1, getNumThreads()));
}

std::vector<Candidate> climbToMaxima(const EdgePlanes& planes, const Plan& plan,
                                     const StripWanted& wanted, const StripFamily families[2],
                                     bool isReference, std::vector<StripChord>& chords)
{
    const Cell& frame = plan.frame();
    const size_t cap = wanted.lines == 0 ? ALL : 512 + 8 * wanted.lines;
    // What is near a maximum would be a duplicate of its line; what is near where another chord started
    // may come to one of its own, if all are wanted.
    EndIndex started(frame, wanted.lines > 0 ? wanted.distance : std::min(wanted.distance, 1.)),
        taken(frame, wanted.distance);
    Best best(wanted.requirement.threshold, wanted.lines);
    Queue queue(chords);
    std::vector<Candidate> found;
    std::vector<Attempt> round;
    size_t count = 0;
    do
    {
        const int needed = best.needed();
        const bool isStrict = wanted.lines > 0 && found.size() >= std::min(MANY, wanted.lines);
        round.clear();
        for (; round.size() < ROUND && !queue.empty() && count + round.size() < cap; queue.pop())
        {
            Attempt attempt;
            attempt.chord = queue.front();
            if (isStrict && mostExact(attempt.chord.votes) < needed)
                break;
            if (!families[attempt.chord.family].imageChord(attempt.chord.y, attempt.chord.t,
                                                           attempt.from) ||
                started.hasNear(attempt.from) || taken.hasNear(attempt.from))
                continue;
            const Candidate seed = {attempt.chord.votes, attempt.from.s, attempt.from.e};
            if (!wanted.requirement.canBeMet(plan, seed, STRIP_SHARE))
                continue;
            started.insert(attempt.from);
            round.push_back(attempt);
        }
        count += round.size();
        climb(planes, families, needed, isStrict, isReference, round);
        for (size_t i = 0; i < round.size(); ++i)
        {
            const Candidate& maximum = round[i].maximum;
            if (!round[i].isFound || !wanted.requirement.isMet(planes, plan, maximum) ||
                !isInInterval(frame, wanted.angles, maximum.chord()))
                continue;
            started.insert(maximum.chord());
            found.push_back(maximum);
            if (taken.hasNear(maximum.chord()))
                continue;
            taken.insert(maximum.chord());
            best.add(maximum.votes);
        }
    } while (!round.empty());
    std::sort(found.begin(), found.end(), isStronger);
    found.erase(std::unique(found.begin(), found.end(), isSameChord), found.end());
    return found;
}

template<class Votes>
void findChords(StripSearch<Votes>& search, const EdgePlanes& planes, const Plan& plan,
                const StripRequest& request, bool isReference, std::vector<StripChord>& chords)
{
    search.find(planes, plan.imageSize(), request,
                isReference ? generic::stripKernels<Votes>() : stripKernels<Votes>(),
                isReference ? generic::bundleKernels() : bundleKernels(), chords);
}

} // namespace

std::vector<Candidate> StripCandidates::find(const EdgePlanes& planes, const Plan& plan,
                                             const StripWanted& wanted, bool isReference,
                                             StageTimes& times)
{
    const StripRequest request = requestFor(plan, wanted);
    if (planes.isWeighted())
    {
        plain_.clear();
        findChords(weighted_, planes, plan, request, isReference, chords_);
    }
    else
    {
        weighted_.clear();
        findChords(plain_, planes, plan, request, isReference, chords_);
    }
    times.end("strips");
    const StripFamily families[2] = {StripFamily(plan.imageSize(), true),
                                     StripFamily(plan.imageSize(), false)};
    const std::vector<Candidate> found =
        climbToMaxima(planes, plan, wanted, families, isReference, chords_);
    times.end("exact");
    return found;
}

void StripCandidates::clear()
{
    plain_.clear();
    weighted_.clear();
    std::vector<StripChord>().swap(chords_);
}

} // namespace linespace
} // namespace cv
