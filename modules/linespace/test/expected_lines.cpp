// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "test_precomp.hpp"

#include "expected_lines.hpp"

#include "generators.hpp"

#include <map>

namespace opencv_test {

using brute::Candidate;

Lines detectLines(LineSpaceDetector& detector, const Mat& edges)
{
    Lines lines;
    detector.detect(edges, lines);
    return lines;
}

Mat1b smallScene(unsigned seed)
{
    std::vector<Vec2d> lines;
    return generators::linesInNoise(Size(46, 37), 4, 0.08, seed, lines);
}

void expectSameLines(const Lines& actual, const Lines& expected, const std::string& what)
{
    ASSERT_EQ(expected.size(), actual.size()) << what;
    for (size_t i = 0; i < expected.size(); ++i)
        ASSERT_EQ(expected[i], actual[i]) << what << ", line " << i; // tolerance 0
}

void expectChords(const Lines& lines, const std::vector<Candidate>& expected, const Size& frame,
                  const std::string& what)
{
    for (size_t i = 0; i < std::min(lines.size(), expected.size()); ++i)
    {
        int s = -1, e = -1;
        ASSERT_TRUE(brute::chordOf(frame, lines[i], s, e))
            << what << ", line " << i << " " << lines[i];
        ASSERT_EQ(expected[i].s, s) << what << ", line " << i << " of " << expected.size();
        ASSERT_EQ(expected[i].e, e) << what << ", line " << i << " of " << expected.size();
        ASSERT_EQ((float)expected[i].votes, lines[i][2]) << what << ", line " << i;
    }
    ASSERT_EQ(expected.size(), lines.size()) << what;
}

Selection::Selection(const Mat& edges, int method, int cellSize, bool weighted,
                     const Mat& directions)
{
    const brute::Cascade cascade = brute::cascadeOf(edges.size(), cellSize);
    climbs = method == METHOD_CASCADED;
    frame = method == METHOD_EXACT ? edges.size() : cascade.frame();
    exact = brute::exactTable(edges, frame, weighted, directions);
    table = method == METHOD_EXACT ? exact
                                   : brute::cascadeTable(edges, cascade, cascade.levelCount() - 1,
                                                         weighted, directions);
}

std::vector<Candidate> Selection::select(int mostRefused, double ratio, int thinning, int radius,
                                         size_t pool) const
{
    std::vector<Candidate> all = brute::chordsAbove(table, frame, ratio * mostRefused);
    const int ascent = climbs ? std::min(radius, 2) : 0;
    if (thinning == THIN_RING && ascent == radius && climbs)
        all = parallelMaxima(all);
    else if (thinning == THIN_RING)
        all = brute::ringMaxima(table, all, radius);
    else if (thinning == THIN_BLOCKS)
        all = brute::blockMaxima(all, radius);
    else if (thinning == THIN_GREEDY)
        all = brute::greedyMaxima(all, table.rows, radius);
    std::sort(all.begin(), all.end(), brute::isStronger);
    if (pool > 0 && all.size() > pool)
        all.resize(pool);
    std::map<std::pair<int, int>, Candidate> reached;
    for (size_t i = 0; i < all.size(); ++i)
    {
        const Candidate start = {all[i].s, all[i].e, exact(all[i].s, all[i].e)};
        const Candidate candidate = climb(start, ascent);
        if (candidate.votes > mostRefused)
            reached[std::make_pair(candidate.s, candidate.e)] = candidate;
    }
    std::vector<Candidate> kept;
    for (const auto& entry : reached)
        kept.push_back(entry.second);
    std::sort(kept.begin(), kept.end(), brute::isStronger);
    return kept;
}

std::vector<Candidate> Selection::parallelMaxima(const std::vector<Candidate>& all) const
{
    const int points = table.rows;
    std::vector<Candidate> kept;
    for (size_t i = 0; i < all.size(); ++i)
    {
        bool isMaximum = true;
        for (int side = -1; side <= 1; side += 2)
        {
            const int p = (all[i].s + side + points) % points,
                      q = (all[i].e - side + points) % points;
            const Candidate parallel = {std::min(p, q), std::max(p, q), table(p, q)};
            if (brute::isChord(frame, p, q) && brute::isStronger(parallel, all[i]))
                isMaximum = false;
        }
        if (isMaximum)
            kept.push_back(all[i]);
    }
    return kept;
}

Candidate Selection::climb(const Candidate& start, int radius) const
{
    const int points = exact.rows;
    Candidate best = start;
    for (int i = -radius; i <= radius; ++i)
        for (int j = -radius; j <= radius; ++j)
        {
            const int p = (start.s + i + points) % points, q = (start.e + j + points) % points;
            const Candidate neighbour = {std::min(p, q), std::max(p, q), exact(p, q)};
            if (brute::isChord(frame, p, q) && brute::isStronger(neighbour, best))
                best = neighbour;
        }
    return best.s == start.s && best.e == start.e ? start : climb(best, radius);
}

} // namespace opencv_test
