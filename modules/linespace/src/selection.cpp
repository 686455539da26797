// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "selection.hpp"

#include "refine.hpp"

#include <cmath>

namespace cv {
namespace linespace {

namespace {

bool isWeaker(const Candidate& a, const Candidate& b)
{
    return isStronger(b, a);
}

//! Gives the strongest candidate first without sorting those that are never asked for.
class CandidateQueue
{
public:
    explicit CandidateQueue(std::vector<Candidate>& candidates) : heap_(candidates)
    {
        std::make_heap(heap_.begin(), heap_.end(), isWeaker);
    }
    bool empty() const { return heap_.empty(); }
    Candidate pop()
    {
        std::pop_heap(heap_.begin(), heap_.end(), isWeaker);
        const Candidate strongest = heap_.back();
        heap_.pop_back();
        return strongest;
    }
    void push(const Candidate& candidate)
    {
        heap_.push_back(candidate);
        std::push_heap(heap_.begin(), heap_.end(), isWeaker);
    }

private:
    std::vector<Candidate>& heap_;
};

//! Lines that were taken, and whether another one may be.
class TakenLines
{
public:
    TakenLines(Size image, const Refinement& refine, double distance)
        : image_(image), refine_(refine), taken_(image, distance)
    {
    }

    //! Takes the candidate's line, refined, unless it is near one taken before or misses the image.
    bool take(const Candidate& candidate, const Line& chordLine)
    {
        if (isNear(chordLine)) // spares the refinement of most
            return false;
        const Selected selected = {candidate, refine_(candidate.chord())};
        if (isNear(selected.fitted.line))
            return false;
        taken_.insert(selected.fitted.line);
        chosen_.push_back(selected);
        return true;
    }

    std::vector<Selected>& chosen() { return chosen_; }

private:
    bool isNear(const Line& line) const
    {
        Ends ends;
        return !clipLine(std::cos(line.theta), std::sin(line.theta), line.rho, image_, ends) ||
               taken_.hasNear(line, ends);
    }

    Size image_;
    const Refinement& refine_;
    LineIndex taken_;
    std::vector<Selected> chosen_;
};

} // namespace

std::vector<Selected> selectPeaks(const Plan& plan, std::vector<Candidate>& candidates,
                                  const Refinement& refine, double distance, size_t most)
{
    TakenLines selection(plan.imageSize(), refine, distance);
    CandidateQueue queue(candidates);
    while (!queue.empty() && selection.chosen().size() < most)
    {
        const Candidate candidate = queue.pop();
        selection.take(candidate, lineOf(plan.frame(), candidate.chord()));
    }
    return selection.chosen();
}

std::vector<Selected> selectExplaining(const EdgeMap& edges, const Plan& plan,
                                       const Requirement& requirement,
                                       std::vector<Candidate>& candidates, const Refinement& refine,
                                       double distance, size_t most)
{
    TakenLines selection(plan.imageSize(), refine, distance);
    CandidateQueue queue(candidates);
    EdgeMap left = edges;
    left.votes = edges.votes.clone();
    while (!queue.empty() && selection.chosen().size() < most)
    {
        Candidate candidate = queue.pop();
        // Votes only fall, so a candidate that still has what it was queued with is the strongest
        // of all.
        const int votes = chordVotes(left, plan.frame(), candidate.chord());
        if (votes < candidate.votes)
        {
            candidate.votes = votes;
            if (requirement.isMet(left, plan, candidate))
                queue.push(candidate);
            continue;
        }
        candidate.votes = chordVotes(edges, plan.frame(), candidate.chord());
        if (selection.take(candidate, lineOf(plan.frame(), candidate.chord())))
            removeSupport(left, directionBit(plan.frame(), candidate.chord()),
                          selection.chosen().back().fitted.line);
    }
    std::sort(selection.chosen().begin(), selection.chosen().end(),
              [](const Selected& a, const Selected& b)
              { return isStronger(a.candidate, b.candidate); });
    return selection.chosen();
}

} // namespace linespace
} // namespace cv
