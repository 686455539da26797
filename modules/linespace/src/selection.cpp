// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "selection.hpp"

#include "refine.hpp"

#include <cmath>

namespace cv {
namespace linespace {

namespace {

//! A candidate, and how many of its votes no line taken explains.
struct Waiting
{
    Candidate candidate;
    int left;
};

bool waitsBehind(const Waiting& a, const Waiting& b)
{
    const Candidate first = {a.left, a.candidate.s, a.candidate.e},
                    second = {b.left, b.candidate.s, b.candidate.e};
    return isStronger(second, first);
}

//! Gives the strongest first without sorting those that are never asked for.
class Queue
{
public:
    explicit Queue(const std::vector<Candidate>& candidates) : heap_(candidates.size())
    {
        for (size_t i = 0; i < heap_.size(); ++i)
        {
            heap_[i].candidate = candidates[i];
            heap_[i].left = candidates[i].votes;
        }
        std::make_heap(heap_.begin(), heap_.end(), waitsBehind);
    }
    bool empty() const { return heap_.empty(); }
    Waiting pop()
    {
        std::pop_heap(heap_.begin(), heap_.end(), waitsBehind);
        const Waiting first = heap_.back();
        heap_.pop_back();
        return first;
    }
    void push(const Waiting& waiting)
    {
        heap_.push_back(waiting);
        std::push_heap(heap_.begin(), heap_.end(), waitsBehind);
    }

private:
    std::vector<Waiting> heap_;
};

class LineSelection
{
public:
    LineSelection(const EdgeMap& edges, const Plan& plan, const SelectionRule& rule,
                  ChordCounter& counter)
        : plan_(plan), frame_(plan.frame()), rule_(rule), left_(edges), counter_(counter),
          taken_(plan.imageSize(), rule.distance)
    {
        if (!rule.explain)
            return;
        left_.votes = edges.votes.clone();
        left_.directions = edges.directions.clone();
    }

    std::vector<Selected> run(Queue& queue)
    {
        while (!queue.empty() && chosen_.size() < rule_.most)
        {
            Waiting next = queue.pop();
            // Votes only fall, so one that still has what it waited with is the strongest of all.
            if (hasFallen(next))
            {
                const Candidate now = {next.left, next.candidate.s, next.candidate.e};
                if (rule_.requirement.isMet(left_, plan_, now))
                    queue.push(next);
            }
            else if (take(next.candidate) && rule_.explain)
                explainBy(chosen_.back());
        }
        std::sort(chosen_.begin(), chosen_.end(),
                  [](const Selected& a, const Selected& b)
                  { return isStronger(a.candidate, b.candidate); });
        return chosen_;
    }

private:
    //! Recounts what is left of a candidate's votes; whether these are fewer than it waited with.
    bool hasFallen(Waiting& waiting) const
    {
        if (!rule_.explain)
            return false;
        const int before = waiting.left;
        waiting.left = counter_.votes(waiting.candidate.chord());
        return waiting.left < before;
    }

    //! Takes the candidate's line, refined, unless it is near one taken before or misses the image.
    bool take(const Candidate& candidate)
    {
        if (isNearTaken(lineOf(frame_, candidate.chord()))) // spares the refinement of most
            return false;
        const Selected selected = {candidate, rule_.refine(candidate.chord())};
        if (isNearTaken(selected.fitted.line))
            return false;
        taken_.insert(selected.fitted.line);
        chosen_.push_back(selected);
        return true;
    }

    void explainBy(const Selected& selected)
    {
        const std::vector<Point> explained = explainedPixels(
            left_, directionBit(frame_, selected.candidate.chord()), selected.fitted.line);
        for (size_t i = 0; i < explained.size(); ++i)
        {
            const Point pixel = explained[i];
            counter_.remove(pixel);
            left_.votes.ptr<uchar>(pixel.y)[pixel.x] = 0;
            if (left_.isOriented())
                left_.directions.ptr<ushort>(pixel.y)[pixel.x] = 0;
        }
    }

    bool isNearTaken(const Line& line) const
    {
        Ends ends;
        return !clipLine(std::cos(line.theta), std::sin(line.theta), line.rho, plan_.imageSize(),
                         ends) ||
               taken_.hasNear(line, ends);
    }

    const Plan& plan_;
    const Cell frame_;
    const SelectionRule& rule_;
    EdgeMap left_;          // with rule_.explain, without what the lines taken explain
    ChordCounter& counter_; // of the same
    LineIndex taken_;
    std::vector<Selected> chosen_;
};

} // namespace

std::vector<Selected> selectLines(const EdgeMap& edges, const Plan& plan, const SelectionRule& rule,
                                  const std::vector<Candidate>& candidates, ChordCounter& counter)
{
    Queue queue(candidates);
    return LineSelection(edges, plan, rule, counter).run(queue);
}

} // namespace linespace
} // namespace cv
