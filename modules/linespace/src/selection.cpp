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
    LineSelection(const Plan& plan, const SelectionRule& rule, EdgePlanes& planes)
        : plan_(plan), frame_(plan.frame()), rule_(rule), left_(planes), counter_(planes),
          taken_(plan.imageSize(), rule.distance)
    {
    }

    std::vector<Selected> run(Queue& queue)
    {
        if (rule_.explain)
            takeExplaining(queue);
        else
            takeInOrder(queue);
        std::sort(chosen_.begin(), chosen_.end(),
                  [](const Selected& a, const Selected& b)
                  { return isStronger(a.candidate, b.candidate); });
        return chosen_;
    }

private:
    //! A candidate whose turn comes soon.
    struct Prospect
    {
        Candidate candidate;
        Line line; //!< of the chord
        Ends ends;
        bool isRefined;
        FittedLine fitted;
        Prospect() : candidate(), line(), ends(), isRefined(false), fitted() {}
    };

    bool isFull() const { return chosen_.size() >= rule_.most; }

    void takeExplaining(Queue& queue)
    {
        while (!queue.empty() && !isFull())
        {
            Waiting next = queue.pop();
            Prospect prospect;
            // Most wait near a line taken, where they stay: no need to count what is left of them.
            if (!isProspect(next.candidate, prospect))
                continue;
            // Votes only fall, so one that still has what it waited with is the strongest of all.
            if (hasFallen(next))
            {
                const Candidate now = {next.left, next.candidate.s, next.candidate.e};
                if (rule_.requirement.isMet(left_, plan_, now))
                    queue.push(next);
            }
            else if (take(prospect))
                explainBy(chosen_.back());
        }
    }

    /** Refinement is most of the work, so some lines are refined at once, ahead of their turn.
    Whether they are taken is decided one after the other. */
    void takeInOrder(Queue& queue)
    {
        const size_t threads = std::max(1, getNumThreads()), most = threads > 1 ? 8 * threads : 1;
        std::vector<Prospect> ahead;
        std::vector<size_t> toRefine;
        while (!queue.empty() && !isFull())
        {
            ahead.clear();
            toRefine.clear();
            while (!queue.empty() && ahead.size() < most &&
                   toRefine.size() < rule_.most - chosen_.size())
            {
                Prospect prospect;
                if (!isProspect(queue.pop().candidate, prospect))
                    continue;
                // A neighbour of one that is refined will hardly be taken.
                if (!isNearOne(prospect, ahead, toRefine))
                    toRefine.push_back(ahead.size());
                ahead.push_back(prospect);
            }
            parallel_for_(Range(0, (int)toRefine.size()),
                          [&](const Range& range)
                          {
                              for (int i = range.start; i < range.end; ++i)
                                  refine(ahead[toRefine[i]]);
                          });
            for (size_t i = 0; i < ahead.size() && !isFull(); ++i)
                if (!taken_.hasNear(ahead[i].line, ahead[i].ends))
                    take(ahead[i]);
        }
    }

    bool isNearOne(const Prospect& prospect, const std::vector<Prospect>& ahead,
                   const std::vector<size_t>& which) const
    {
        for (size_t i = 0; i < which.size(); ++i)
        {
            const Line& other = ahead[which[i]].line;
            const Point2d normal(std::cos(other.theta), std::sin(other.theta));
            if (std::abs(normal.dot(prospect.ends.first) - other.rho) <= rule_.distance &&
                std::abs(normal.dot(prospect.ends.second) - other.rho) <= rule_.distance)
                return true;
        }
        return false;
    }

    //! Recounts what is left of a candidate's votes; whether these are fewer than it waited with.
    bool hasFallen(Waiting& waiting) const
    {
        const int before = waiting.left;
        waiting.left = counter_.votes(waiting.candidate.chord());
        return waiting.left < before;
    }

    //! Whether the chord's own line passes the image and is not near one taken before, which spares
    //! the refinement of most.
    bool isProspect(const Candidate& candidate, Prospect& prospect) const
    {
        prospect.candidate = candidate;
        prospect.line = lineOf(frame_, candidate.chord());
        prospect.isRefined = false;
        return !isNearTaken(prospect.line, prospect.ends);
    }

    void refine(Prospect& prospect) const
    {
        prospect.fitted = rule_.refine(prospect.candidate.chord());
        prospect.isRefined = true;
    }

    //! Takes the candidate's line, refined, unless it is near one taken before or misses the image.
    bool take(Prospect& prospect)
    {
        if (!prospect.isRefined)
            refine(prospect);
        Ends ends;
        if (isNearTaken(prospect.fitted.line, ends))
            return false;
        taken_.insert(prospect.fitted.line);
        const Selected selected = {prospect.candidate, prospect.fitted};
        chosen_.push_back(selected);
        return true;
    }

    void explainBy(const Selected& selected)
    {
        const std::vector<Point> explained =
            explainedPixels(left_, plan_.imageSize(),
                            directionBin(frame_, selected.candidate.chord()), selected.fitted.line);
        for (size_t i = 0; i < explained.size(); ++i)
            left_.remove(explained[i]);
    }

    bool isNearTaken(const Line& line, Ends& ends) const
    {
        return !clipLine(std::cos(line.theta), std::sin(line.theta), line.rho, plan_.imageSize(),
                         ends) ||
               taken_.hasNear(line, ends);
    }

    const Plan& plan_;
    const Cell frame_;
    const SelectionRule& rule_;
    EdgePlanes& left_;           // with rule_.explain, without what the lines taken explain
    const ChordCounter counter_; // of the same
    LineIndex taken_;
    std::vector<Selected> chosen_;
};

} // namespace

std::vector<Selected> selectLines(const Plan& plan, const SelectionRule& rule,
                                  const std::vector<Candidate>& candidates, EdgePlanes& planes)
{
    Queue queue(candidates);
    return LineSelection(plan, rule, planes).run(queue);
}

} // namespace linespace
} // namespace cv
