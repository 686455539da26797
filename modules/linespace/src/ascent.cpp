// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "ascent.hpp"

namespace cv {
namespace linespace {

Ascent::Ascent(const ChordCounter& counter, const Cell& frame, int radius)
    : counter_(counter), frame_(frame),
      // On a ring of fewer points a neighbourhood would meet itself.
      radius_(std::min(radius, (frame.borderCount() - 1) / 2))
{
}

template<class Visit>
void Ascent::forEachNeighbour(Chord chord, Visit visit) const
{
    const int points = frame_.borderCount();
    for (int i = -radius_; i <= radius_; ++i)
        for (int j = -radius_; j <= radius_; ++j)
        {
            const int p = (chord.s + i + points) % points, q = (chord.e + j + points) % points;
            const Chord neighbour = {std::min(p, q), std::max(p, q)};
            if (frame_.isChord(p, q))
                visit(neighbour);
        }
}

void Ascent::countAsked()
{
    std::vector<int> counted(asked_.size());
    parallel_for_(Range(0, (int)asked_.size()),
                  [&](const Range& range)
                  {
                      for (int i = range.start; i < range.end; ++i)
                          counted[i] = counter_.votes(asked_[i]);
                  });
    for (size_t i = 0; i < asked_.size(); ++i)
        votes_[frame_.chordIndex(asked_[i].s, asked_[i].e)] = counted[i];
    asked_.clear();
}

void Ascent::climb(std::vector<Candidate>& candidates)
{
    for (size_t i = 0; i < candidates.size(); ++i)
        votes_[frame_.chordIndex(candidates[i].s, candidates[i].e)] = candidates[i].votes;
    std::vector<size_t> moving(candidates.size());
    for (size_t i = 0; i < moving.size(); ++i)
        moving[i] = i;
    while (!moving.empty()) // ends: every move is to a stronger one
    {
        for (size_t i = 0; i < moving.size(); ++i)
            forEachNeighbour(candidates[moving[i]].chord(),
                             [&](Chord chord)
                             {
                                 const size_t index = frame_.chordIndex(chord.s, chord.e);
                                 if (votes_.insert(std::make_pair(index, -1)).second)
                                     asked_.push_back(chord);
                             });
        countAsked();
        std::vector<size_t> moved;
        for (size_t i = 0; i < moving.size(); ++i)
        {
            Candidate& candidate = candidates[moving[i]];
            Candidate best = candidate;
            forEachNeighbour(candidate.chord(),
                             [&](Chord chord)
                             {
                                 const Candidate neighbour = {
                                     votes_.find(frame_.chordIndex(chord.s, chord.e))->second,
                                     chord.s, chord.e};
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
}

} // namespace linespace
} // namespace cv
