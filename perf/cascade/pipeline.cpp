// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "pipeline.hpp"

#include "line_error.hpp"
#include "naive_cascade.hpp"

#include <algorithm>
#include <cmath>

namespace cascade {

namespace {

struct Candidate
{
    int votes, s, e; //!< s < e
};

//! The total order of section 4.3.
bool isStronger(const Candidate& a, const Candidate& b)
{
    return a.votes != b.votes ? a.votes > b.votes : a.s != b.s ? a.s < b.s : a.e < b.e;
}

Candidate candidateAt(const cv::Mat1i& votes, int p, int q)
{
    p = (p + votes.rows) % votes.rows;
    q = (q + votes.rows) % votes.rows;
    return {votes(p, q), std::min(p, q), std::max(p, q)};
}

bool isSame(const Candidate& a, const Candidate& b)
{
    return a.s == b.s && a.e == b.e;
}

bool isMaximum(const cv::Mat1i& votes, const Candidate& candidate, int radius)
{
    for (int i = -radius; i <= radius; ++i)
        for (int j = -radius; j <= radius; ++j)
            if (isStronger(candidateAt(votes, candidate.s + i, candidate.e + j), candidate))
                return false;
    return true;
}

bool isParallelMaximum(const cv::Mat1i& votes, const Candidate& candidate)
{
    return !isStronger(candidateAt(votes, candidate.s + 1, candidate.e - 1), candidate) &&
           !isStronger(candidateAt(votes, candidate.s - 1, candidate.e + 1), candidate);
}

bool isCandidate(const cv::Mat1i& votes, const Candidate& chord,
                 const PipelineParameters& parameters)
{
    switch (parameters.candidates)
    {
    case Candidates::RING_MAXIMA: return isMaximum(votes, chord, parameters.radius);
    case Candidates::PARALLEL_MAXIMA: return isParallelMaximum(votes, chord);
    default: return true;
    }
}

//! Exact votes, and how many chords were asked for.
class ExactVotes
{
public:
    explicit ExactVotes(const cv::Mat1i& votes) : votes_(votes), asked_(votes.total()) {}

    Candidate at(int p, int q)
    {
        const Candidate chord = candidateAt(votes_, p, q);
        const std::size_t key = (std::size_t)chord.s * votes_.cols + chord.e;
        counted_ += !asked_[key];
        asked_[key] = true;
        return chord;
    }
    std::size_t counted() const { return counted_; }

private:
    const cv::Mat1i& votes_;
    std::vector<bool> asked_;
    std::size_t counted_ = 0;
};

//! The strongest chord of the ring neighbourhood, which is the chord itself if it is a maximum.
Candidate strongestAround(ExactVotes& exact, const Candidate& chord, int radius)
{
    Candidate best = chord;
    for (int i = -radius; i <= radius; ++i)
        for (int j = -radius; j <= radius; ++j)
        {
            const Candidate neighbour = exact.at(chord.s + i, chord.e + j);
            if (isStronger(neighbour, best))
                best = neighbour;
        }
    return best;
}

Candidate climbed(ExactVotes& exact, Candidate chord, const PipelineParameters& parameters)
{
    chord = exact.at(chord.s, chord.e);
    if (parameters.ascent == Ascent::NONE)
        return chord;
    const bool isLimited = parameters.ascent == Ascent::TWO_STEPS;
    for (int step = 0; !isLimited || step < 2; ++step)
    {
        const Candidate best = strongestAround(exact, chord, isLimited ? 1 : parameters.radius);
        if (isSame(best, chord))
            break;
        chord = best;
    }
    return chord;
}

//! A chord's ends and line in OpenCV's coordinates, pixel centres at integers.
struct ChordLine
{
    cv::Vec4f ends;
    cv::Vec3f line;
};

ChordLine lineOf(const Candidate& candidate, cv::Size image)
{
    const cv::Point s = borderPoint(image, candidate.s), e = borderPoint(image, candidate.e);
    const double x = s.x / 2. - 0.5, y = s.y / 2. - 0.5;
    double theta = std::atan2((double)(e.x - s.x), (double)(s.y - e.y)); // of the normal
    if (theta < 0)
        theta += CV_PI;
    if (theta >= CV_PI)
        theta -= CV_PI;
    return {cv::Vec4f((float)x, (float)y, e.x / 2.f - 0.5f, e.y / 2.f - 0.5f),
            cv::Vec3f((float)(x * std::cos(theta) + y * std::sin(theta)), (float)theta,
                      (float)candidate.votes)};
}

} // namespace

PipelineResult strongestLines(const cv::Mat1i& votes, const cv::Mat1i& exact, cv::Size image,
                              const PipelineParameters& parameters)
{
    const int least = cvFloor(parameters.candidateRatio * parameters.threshold);
    std::vector<Candidate> candidates;
    for (int s = 0; s < votes.rows; ++s)
        for (int e = s + 1; e < votes.cols; ++e)
            if (votes(s, e) > least && isCandidate(votes, {votes(s, e), s, e}, parameters))
                candidates.push_back({votes(s, e), s, e});
    std::sort(candidates.begin(), candidates.end(), isStronger);
    candidates.resize(std::min(candidates.size(), parameters.pool));
    ExactVotes counts(exact);
    for (Candidate& candidate : candidates)
        candidate = climbed(counts, candidate, parameters);
    std::sort(candidates.begin(), candidates.end(), isStronger);
    candidates.erase(std::unique(candidates.begin(), candidates.end(), isSame), candidates.end());

    PipelineResult result;
    for (const Candidate& candidate : candidates)
    {
        if (candidate.votes <= parameters.threshold || result.lines.size() == parameters.maxLines)
            break;
        const ChordLine chord = lineOf(candidate, image);
        if (leastError(chord.ends, result.lines, result.lines.size()) > parameters.distance)
            result.lines.push_back(chord.line);
    }
    result.counted = counts.counted();
    return result;
}

} // namespace cascade
