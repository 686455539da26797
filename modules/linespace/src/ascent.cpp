// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Where a chord leads to does not depend on who passes by, so a candidate that comes to where one
// has been is forgotten, and all can take their steps at the same time: first the votes that the
// step of any of them needs are counted, in parallel, then each takes it.

#include "ascent.hpp"

namespace cv {
namespace linespace {

namespace {

bool isSameChord(const Candidate& a, const Candidate& b)
{
    return a.s == b.s && a.e == b.e;
}

class Ascent
{
public:
    Ascent(const ChordCounter& counter, const Cell& frame, int radius, VoteStrips& strips)
        : counter_(counter), frame_(frame), radius_(radius), strips_(strips),
          isVisited_(frame.chordCount())
    {
    }

    std::vector<Candidate> run(std::vector<Candidate> climbing)
    {
        std::vector<Candidate> maxima, next;
        for (size_t i = 0; i < climbing.size(); ++i)
            visit(climbing[i]);
        while (!climbing.empty())
        {
            for (size_t i = 0; i < climbing.size(); ++i)
                if (isInStrips(climbing[i]))
                    strips_.want(climbing[i].chord(), radius_);
            strips_.countWanted(counter_);
            takeSteps(climbing, next);
            size_t left = 0;
            for (size_t i = 0; i < climbing.size(); ++i)
                if (isSameChord(next[i], climbing[i]))
                    maxima.push_back(next[i]);
                else if (visit(next[i]))
                    climbing[left++] = next[i];
            climbing.resize(left);
        }
        return maxima;
    }

private:
    //! Whether nobody has been there before.
    bool visit(const Candidate& candidate)
    {
        std::vector<bool>::reference isVisited =
            isVisited_[frame_.chordIndex(candidate.s, candidate.e)];
        const bool isNew = !isVisited;
        isVisited = true;
        return isNew;
    }

    bool isInStrips(const Candidate& candidate) const
    {
        return strips_.hasNeighbourhood(candidate.chord(), radius_);
    }

    void takeSteps(const std::vector<Candidate>& from, std::vector<Candidate>& to) const
    {
        to.resize(from.size());
        const auto takeRange = [&](const Range& range)
        {
            for (int i = range.start; i < range.end; ++i)
                to[i] = isInStrips(from[i]) ? strongestInStrips(from[i].chord())
                                            : strongestCounted(from[i].chord());
        };
        const Range all(0, (int)from.size());
        if (all.end < 32) // not worth waking up other threads
            takeRange(all);
        else
            parallel_for_(all, takeRange, 8 * std::max(1, getNumThreads()));
    }

    //! The strongest chord of a neighbourhood, the middle included.
    Candidate strongestInStrips(Chord middle) const
    {
        Candidate best = {-1, 0, 0};
        strips_.forEachAround(middle, radius_,
                              [&](int votes, int s, int e)
                              {
                                  // In the order of s and e: of equal votes the first one.
                                  if (votes <= best.votes)
                                      return;
                                  best.votes = votes;
                                  best.s = s;
                                  best.e = e;
                              });
        return best;
    }

    Candidate strongestCounted(Chord middle) const
    {
        const int points = frame_.borderCount();
        Chord chords[ChordCounter::MOST_NEAR] = {};
        int votes[ChordCounter::MOST_NEAR], count = 0;
        for (int i = -radius_; i <= radius_; ++i)
            for (int j = -radius_; j <= radius_; ++j)
            {
                const int p = (middle.s + i + points) % points,
                          q = (middle.e + j + points) % points;
                const Chord chord = {std::min(p, q), std::max(p, q)};
                if (frame_.isChord(p, q))
                    chords[count++] = chord;
            }
        counter_.countNear(middle, chords, count, votes);
        Candidate best = {-1, 0, 0};
        for (int i = 0; i < count; ++i)
        {
            const Candidate neighbour = {votes[i], chords[i].s, chords[i].e};
            if (isStronger(neighbour, best))
                best = neighbour;
        }
        return best;
    }

    const ChordCounter& counter_;
    const Cell frame_;
    const int radius_;
    VoteStrips& strips_;
    std::vector<bool> isVisited_; //!< by the chords' indices
};

} // namespace

void climbToMaxima(const ChordCounter& counter, const Cell& frame, int radius, VoteStrips& strips,
                   std::vector<Candidate>& candidates)
{
    // On a ring of fewer points a neighbourhood would meet itself.
    radius = std::min(radius, (frame.borderCount() - 1) / 2);
    candidates = Ascent(counter, frame, radius, strips).run(candidates);
    std::sort(candidates.begin(), candidates.end(), isStronger);
}

double ascentMemory(const Cell& frame, double candidates)
{
    candidates = std::min(candidates, frame.chordCount() / 2.); // maxima: every other chord at most
    // A neighbourhood meets 9 to 18 strips, most of which its candidate shares with others.
    const double strips = candidates > 0 ? 18 * candidates : (double)frame.chordCount();
    return frame.chordCount() / 8. + VoteStrips::memory(frame) +
           VoteStrips::stripMemory(frame, strips) + 3 * candidates * sizeof(Candidate);
}

} // namespace linespace
} // namespace cv
