// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "ascent.hpp"

#include <unordered_map>

namespace cv {
namespace linespace {

namespace {

//! The other entries of a neighbourhood on the ring, nearest first; of equally near ones by rows.
std::vector<Point> neighboursByDistance(int radius)
{
    std::vector<Point> offsets;
    for (int i = -radius; i <= radius; ++i)
        for (int j = -radius; j <= radius; ++j)
            if (i != 0 || j != 0)
                offsets.push_back(Point(i, j));
    std::stable_sort(offsets.begin(), offsets.end(),
                     [](const Point& a, const Point& b) { return a.dot(a) < b.dot(b); });
    return offsets;
}

/** Where candidates come to. What one of them found out spares the others counting: a chord's next
one does not depend on who passes by. */
class Ascent
{
public:
    Ascent(const ChordCounter& counter, const Cell& frame, const std::vector<Point>& neighbours)
        : counter_(counter), frame_(frame), neighbours_(neighbours)
    {
    }

    Candidate maximumFrom(const Candidate& start)
    {
        std::vector<size_t> passed;
        Candidate at = start;
        for (;;)
        {
            Known& known = known_[indexOf(at)];
            known.votes = at.votes;
            if (known.hasMaximum)
            {
                at = known.maximum;
                break;
            }
            passed.push_back(indexOf(at));
            const Candidate next = firstStronger(at);
            if (next.s == at.s && next.e == at.e)
                break;
            at = next;
        }
        for (size_t i = 0; i < passed.size(); ++i)
        {
            Known& known = known_[passed[i]];
            known.hasMaximum = true;
            known.maximum = at;
        }
        return at;
    }

private:
    struct Known
    {
        int votes; //!< -1: not counted yet
        bool hasMaximum;
        Candidate maximum;
        Known() : votes(-1), hasMaximum(false) {}
    };

    size_t indexOf(const Candidate& candidate) const
    {
        return frame_.chordIndex(candidate.s, candidate.e);
    }

    Candidate firstStronger(const Candidate& candidate)
    {
        const int points = frame_.borderCount();
        for (size_t i = 0; i < neighbours_.size(); ++i)
        {
            const int p = (candidate.s + neighbours_[i].x + points) % points,
                      q = (candidate.e + neighbours_[i].y + points) % points;
            if (!frame_.isChord(p, q))
                continue;
            Candidate neighbour = {0, std::min(p, q), std::max(p, q)};
            Known& known = known_[indexOf(neighbour)];
            if (known.votes < 0)
                known.votes = counter_.votes(neighbour.chord());
            neighbour.votes = known.votes;
            if (isStronger(neighbour, candidate))
                return neighbour;
        }
        return candidate;
    }

    const ChordCounter& counter_;
    const Cell frame_;
    const std::vector<Point>& neighbours_;
    std::unordered_map<size_t, Known> known_; //!< by the chords' indices
};

} // namespace

void climbToMaxima(const ChordCounter& counter, const Cell& frame, int radius,
                   std::vector<Candidate>& candidates)
{
    // On a ring of fewer points a neighbourhood would meet itself.
    const std::vector<Point> neighbours =
        neighboursByDistance(std::min(radius, (frame.borderCount() - 1) / 2));
    // The strongest first: others come to where these have been. Neighbours in the table stay
    // together, so that one task's knowledge serves its own.
    std::sort(candidates.begin(), candidates.end(),
              [](const Candidate& a, const Candidate& b)
              { return a.s != b.s ? a.s < b.s : a.e < b.e; });
    parallel_for_(
        Range(0, (int)candidates.size()),
        [&](const Range& range)
        {
            Ascent ascent(counter, frame, neighbours);
            for (int i = range.start; i < range.end; ++i)
                candidates[i] = ascent.maximumFrom(candidates[i]);
        },
        getNumThreads());
    std::sort(candidates.begin(), candidates.end(), isStronger);
    candidates.erase(std::unique(candidates.begin(), candidates.end(),
                                 [](const Candidate& a, const Candidate& b)
                                 { return a.s == b.s && a.e == b.e; }),
                     candidates.end());
}

} // namespace linespace
} // namespace cv
