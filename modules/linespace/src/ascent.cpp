// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "ascent.hpp"

#include <unordered_map>

namespace cv {
namespace linespace {

namespace {

//! Exact votes of chords of the frame, each counted once.
class ExactVotes
{
public:
    ExactVotes(Executor& executor, const EdgeMap& edges, const Plan& plan)
        : executor_(executor), edges_(edges), plan_(plan)
    {
    }

    void ask(Chord chord)
    {
        if (votes_.insert(std::make_pair(keyOf(chord), 0)).second)
            asked_.push_back(chord);
    }
    //! Counts what was asked for.
    void count()
    {
        executor_.rescore(edges_, plan_, asked_, counted_);
        for (size_t i = 0; i < asked_.size(); ++i)
            votes_[keyOf(asked_[i])] = counted_[i];
        asked_.clear();
    }
    Candidate of(Chord chord) const
    {
        const Candidate result = {votes_.find(keyOf(chord))->second, chord.s, chord.e};
        return result;
    }

private:
    size_t keyOf(Chord chord) const { return plan_.frame().chordIndex(chord.s, chord.e); }

    Executor& executor_;
    const EdgeMap& edges_;
    const Plan& plan_;
    std::unordered_map<size_t, int> votes_;
    std::vector<Chord> asked_;
    std::vector<int> counted_;
};

//! Calls visit(chord) for the neighbours of a chord on the ring.
template<class Visit>
void forEachNeighbour(const Cell& frame, Chord chord, Visit visit)
{
    const int points = frame.borderCount();
    for (int i = -1; i <= 1; ++i)
        for (int j = -1; j <= 1; ++j)
        {
            const int p = (chord.s + i + points) % points, q = (chord.e + j + points) % points;
            const Chord neighbour = {std::min(p, q), std::max(p, q)};
            if ((i != 0 || j != 0) && frame.isChord(p, q))
                visit(neighbour);
        }
}

} // namespace

void climbToExactMaxima(Executor& executor, const EdgeMap& edges, const Plan& plan, int steps,
                        size_t climbers, std::vector<Candidate>& candidates)
{
    climbers = std::min(climbers, candidates.size());
    std::nth_element(candidates.begin(), candidates.begin() + climbers, candidates.end(),
                     isStronger);
    ExactVotes exact(executor, edges, plan);
    for (size_t i = 0; i < candidates.size(); ++i)
        exact.ask(candidates[i].chord());
    exact.count();
    for (size_t i = 0; i < candidates.size(); ++i)
        candidates[i] = exact.of(candidates[i].chord());

    std::vector<size_t> moving(climbers);
    for (size_t i = 0; i < moving.size(); ++i)
        moving[i] = i;
    for (int step = 0; step < steps && !moving.empty(); ++step)
    {
        for (size_t i = 0; i < moving.size(); ++i)
            forEachNeighbour(plan.frame(), candidates[moving[i]].chord(),
                             [&](Chord chord) { exact.ask(chord); });
        exact.count();
        std::vector<size_t> moved;
        for (size_t i = 0; i < moving.size(); ++i)
        {
            Candidate& candidate = candidates[moving[i]];
            Candidate best = candidate;
            forEachNeighbour(plan.frame(), candidate.chord(),
                             [&](Chord chord)
                             {
                                 const Candidate neighbour = exact.of(chord);
                                 if (isStronger(neighbour, best))
                                     best = neighbour;
                             });
            if (isStronger(best, candidate))
            {
                candidate = best;
                moved.push_back(moving[i]);
            }
        }
        moving.swap(moved);
    }
    std::sort(candidates.begin(), candidates.end(), isStronger);
    candidates.erase(std::unique(candidates.begin(), candidates.end(),
                                 [](const Candidate& a, const Candidate& b)
                                 { return a.s == b.s && a.e == b.e; }),
                     candidates.end());
}

} // namespace linespace
} // namespace cv
