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

class Ascent
{
public:
    Ascent(int radius, VoteSquares& squares) : radius_(radius), squares_(squares) {}

    std::vector<Candidate> run(const std::vector<Candidate>& candidates)
    {
        std::vector<Candidate> climbing = groupedBySquares(candidates);
        std::vector<Candidate> maxima, next;
        while (!climbing.empty())
        {
            for (size_t i = 0; i < climbing.size(); ++i)
                squares_.want(climbing[i].chord(), radius_);
            squares_.countWanted();
            takeSteps(climbing, next);
            size_t left = 0;
            for (size_t i = 0; i < climbing.size(); ++i)
                if (isSameChord(next[i], climbing[i]))
                    maxima.push_back(next[i]);
                else if (squares_.mark(next[i].chord()))
                    climbing[left++] = next[i];
            climbing.resize(left);
        }
        return maxima;
    }

private:
    //! In the order of runs of s: those that share squares are near one another, which makes
    //! everything faster and changes nothing.
    static std::vector<Candidate> groupedBySquares(const std::vector<Candidate>& candidates)
    {
        const int run = VoteSquares::SQUARE;
        int last = 0;
        for (size_t i = 0; i < candidates.size(); ++i)
            last = std::max(last, candidates[i].s / run);
        std::vector<size_t> starts(last + 2, 0);
        for (size_t i = 0; i < candidates.size(); ++i)
            ++starts[candidates[i].s / run + 1];
        for (int k = 0; k < last; ++k)
            starts[k + 1] += starts[k];
        std::vector<Candidate> result(candidates.size());
        for (size_t i = 0; i < candidates.size(); ++i)
            result[starts[candidates[i].s / run]++] = candidates[i];
        return result;
    }

    void takeSteps(const std::vector<Candidate>& from, std::vector<Candidate>& to) const
    {
        to.resize(from.size());
        const auto takeRange = [&](const Range& range)
        {
            for (int i = range.start; i < range.end; ++i)
                to[i] = squares_.strongestAround(from[i].chord(), radius_);
        };
        const Range all(0, (int)from.size());
        if (all.end < 256) // not worth waking up other threads
            takeRange(all);
        else
            parallel_for_(all, takeRange, 8 * std::max(1, getNumThreads()));
    }

    const int radius_;
    VoteSquares& squares_; //!< those marked have been visited
};

} // namespace

void climbToMaxima(const Cell& frame, int radius, VoteSquares& squares,
                   std::vector<Candidate>& candidates)
{
    radius = mostRadius(frame, radius);
    candidates = Ascent(radius, squares).run(candidates);
    std::sort(candidates.begin(), candidates.end(), isStronger);
}

double ascentMemory(const Cell& frame, bool isPlain, double candidates)
{
    const double chords = (double)frame.chordCount();
    candidates = std::min(candidates, chords / 2); // maxima: every other chord at most
    // A neighbourhood meets 4 squares at most, but for corners, and shares them with others.
    const double squares = candidates > 0 ? 4 * candidates : chords;
    return VoteSquares::memory(frame, isPlain) + VoteSquares::squareMemory(frame, squares) +
           3 * candidates * sizeof(Candidate);
}

} // namespace linespace
} // namespace cv
