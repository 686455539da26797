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

bool isMaximum(const cv::Mat1i& votes, const Candidate& candidate, int radius)
{
    for (int i = -radius; i <= radius; ++i)
        for (int j = -radius; j <= radius; ++j)
            if (isStronger(candidateAt(votes, candidate.s + i, candidate.e + j), candidate))
                return false;
    return true;
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

std::vector<cv::Vec3f> strongestLines(const cv::Mat1i& votes, const cv::Mat1i& exact,
                                      cv::Size image, const PipelineParameters& parameters)
{
    const int least = cvFloor(parameters.candidateRatio * parameters.threshold);
    std::vector<Candidate> candidates;
    for (int s = 0; s < votes.rows; ++s)
        for (int e = s + 1; e < votes.cols; ++e)
            if (votes(s, e) > least && isMaximum(votes, {votes(s, e), s, e}, parameters.radius))
                candidates.push_back({votes(s, e), s, e});
    std::sort(candidates.begin(), candidates.end(), isStronger);
    candidates.resize(std::min(candidates.size(), parameters.pool));
    for (Candidate& candidate : candidates)
        candidate.votes = exact(candidate.s, candidate.e);
    std::sort(candidates.begin(), candidates.end(), isStronger);

    std::vector<cv::Vec3f> lines;
    for (const Candidate& candidate : candidates)
    {
        if (candidate.votes <= parameters.threshold || lines.size() == parameters.maxLines)
            break;
        const ChordLine chord = lineOf(candidate, image);
        if (leastError(chord.ends, lines, lines.size()) > parameters.distance)
            lines.push_back(chord.line);
    }
    return lines;
}

} // namespace cascade
