// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "selection.hpp"

#include "ascent.hpp"
#include "refine.hpp"

#include <cmath>
#include <limits>
#include <unordered_set>

namespace cv {
namespace linespace {

namespace {

const size_t BATCH = 32; // candidates that climb at a time, in parallel

bool waitsBehind(const Waiting& a, const Waiting& b)
{
    const Candidate first = {a.key(), a.candidate.s, a.candidate.e},
                    second = {b.key(), b.candidate.s, b.candidate.e};
    return isStronger(second, first);
}

//! Gives the largest key first without sorting those that are never asked for.
class Queue
{
public:
    explicit Queue(std::vector<Waiting>& candidates) : heap_(candidates)
    {
        std::make_heap(heap_.begin(), heap_.end(), waitsBehind);
    }
    bool empty() const { return heap_.empty(); }
    const Waiting& first() const { return heap_.front(); }
    Waiting pop()
    {
        std::pop_heap(heap_.begin(), heap_.end(), waitsBehind);
        const Waiting first = heap_.back();
        heap_.pop_back();
        return first;
    }
    void push(const Waiting& candidate)
    {
        heap_.push_back(candidate);
        std::push_heap(heap_.begin(), heap_.end(), waitsBehind);
    }

private:
    std::vector<Waiting>& heap_;
};

class LineSelection
{
public:
    LineSelection(const EdgeMap& edges, const Plan& plan, const SelectionRule& rule,
                  std::vector<Waiting>& candidates)
        : edges_(edges), plan_(plan), frame_(plan.frame()), rule_(rule), queue_(candidates),
          all_(edges, frame_), ascent_(all_, frame_, rule.ascentRadius),
          taken_(plan.imageSize(), rule.distance)
    {
        if (rule.explain)
            left_ = makePtr<ChordCounter>(edges, frame_);
    }

    std::vector<Selected> run()
    {
        while (!queue_.empty() && chosen_.size() < rule_.most)
        {
            if (!queue_.first().hasClimbed && rule_.ascentRadius > 0)
                climbNext();
            else
                considerNext();
        }
        std::sort(chosen_.begin(), chosen_.end(),
                  [](const Selected& a, const Selected& b)
                  { return isStronger(a.candidate, b.candidate); });
        return chosen_;
    }

private:
    void climbNext()
    {
        const bool all = rule_.most == std::numeric_limits<size_t>::max();
        std::vector<Candidate> batch;
        while (!queue_.empty() && !queue_.first().hasClimbed && (all || batch.size() < BATCH))
        {
            const Waiting next = queue_.pop();
            if (isNearTaken(lineOf(frame_, next.candidate.chord())) || hasFallen(next))
                continue;
            batch.push_back(next.candidate);
        }
        ascent_.climb(batch);
        for (size_t i = 0; i < batch.size(); ++i)
        {
            Line line = lineOf(frame_, batch[i].chord());
            if (summits_.insert(frame_.chordIndex(batch[i].s, batch[i].e)).second &&
                rule_.requirement.isMet(edges_, plan_, batch[i]) && rule_.angles.represent(line))
            {
                const Waiting waiting = {batch[i], batch[i].votes, 0, true};
                queue_.push(waiting);
            }
        }
    }

    /** Whether pixels of a candidate were explained since it was queued. It then waits again with the
    votes that are left, if these can do. */
    bool hasFallen(Waiting waiting)
    {
        if (!rule_.explain)
            return false;
        const int left = left_->votes(waiting.candidate.chord());
        if (left == waiting.left)
            return false;
        // Votes only fall, so one that still has what it waited with is the strongest of all.
        waiting.left = left;
        const Candidate now = {waiting.key(), waiting.candidate.s, waiting.candidate.e};
        if (waiting.hasClimbed ? rule_.requirement.isMet(left_->edges(), plan_, now)
                               : rule_.requirement.canBeMet(plan_, now, 1))
            queue_.push(waiting);
        return true;
    }

    void considerNext()
    {
        const Waiting next = queue_.pop();
        const Candidate& candidate = next.candidate;
        if (hasFallen(next))
            return;
        if (take(candidate) && rule_.explain)
        {
            const std::vector<Point> explained =
                explainedPixels(left_->edges(), directionBit(frame_, candidate.chord()),
                                chosen_.back().fitted.line);
            for (size_t i = 0; i < explained.size(); ++i)
                left_->remove(explained[i]);
        }
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

    bool isNearTaken(const Line& line) const
    {
        Ends ends;
        return !clipLine(std::cos(line.theta), std::sin(line.theta), line.rho, plan_.imageSize(),
                         ends) ||
               taken_.hasNear(line, ends);
    }

    const EdgeMap& edges_;
    const Plan& plan_;
    const Cell frame_;
    const SelectionRule& rule_;
    Queue queue_;
    const ChordCounter all_;
    Ascent ascent_;
    Ptr<ChordCounter> left_;             // without what the lines taken explain
    std::unordered_set<size_t> summits_; // indices of the chords that candidates climbed to
    LineIndex taken_;
    std::vector<Selected> chosen_;
};

} // namespace

std::vector<Selected> selectLines(const EdgeMap& edges, const Plan& plan, const SelectionRule& rule,
                                  std::vector<Waiting>& candidates)
{
    return LineSelection(edges, plan, rule, candidates).run();
}

} // namespace linespace
} // namespace cv
