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

//! Adds the line to those taken unless it duplicates one of them or misses the image.
bool takeUnlessNear(LineIndex& taken, const Line& line, Size image)
{
    Ends ends;
    if (!clipLine(std::cos(line.theta), std::sin(line.theta), line.rho, image, ends) || taken.hasNear(line, ends))
        return false;
    taken.insert(line);
    return true;
}

} // namespace

std::vector<Candidate> selectPeaks(const Plan& plan, std::vector<Candidate>& candidates, double distance, size_t most)
{
    std::vector<Candidate> chosen;
    CandidateQueue queue(candidates);
    LineIndex taken(plan.imageSize(), distance);
    while (!queue.empty() && chosen.size() < most)
    {
        const Candidate candidate = queue.pop();
        if (takeUnlessNear(taken, lineOf(plan.frame(), candidate.chord()), plan.imageSize()))
            chosen.push_back(candidate);
    }
    return chosen;
}

std::vector<Candidate> selectExplaining(const EdgeMap& edges, const Plan& plan, const Requirement& requirement,
                                        std::vector<Candidate>& candidates, double distance, size_t most)
{
    std::vector<Candidate> chosen;
    CandidateQueue queue(candidates);
    LineIndex taken(plan.imageSize(), distance);
    EdgeMap left = edges;
    left.votes = edges.votes.clone();
    while (!queue.empty() && chosen.size() < most)
    {
        Candidate candidate = queue.pop();
        // Votes only fall, so a candidate that still has what it was queued with is the strongest of all.
        const int votes = chordVotes(left, plan.frame(), candidate.chord());
        if (votes < candidate.votes)
        {
            candidate.votes = votes;
            if (requirement.isMet(plan, candidate, 1))
                queue.push(candidate);
            continue;
        }
        const Line line = lineOf(plan.frame(), candidate.chord());
        if (!takeUnlessNear(taken, line, plan.imageSize()))
            continue;
        removeSupport(left, refineLine(left, line));
        candidate.votes = chordVotes(edges, plan.frame(), candidate.chord());
        chosen.push_back(candidate);
    }
    std::sort(chosen.begin(), chosen.end(), isStronger);
    return chosen;
}

} // namespace linespace
} // namespace cv
