// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "peaks.hpp"

namespace cv {
namespace linespace {

namespace {

//! The table as a function on the ring of border points: any two of them, in either order.
template<class Votes>
struct RingTable
{
    const Votes* votes;
    Cell frame;
    int borderCount;

    int wrap(int p) const
    {
        return p < 0 ? p + borderCount : p >= borderCount ? p - borderCount : p;
    }

    //! The entry of two border points; pairs on one side have no votes.
    Candidate at(int p, int q) const
    {
        Candidate result = {0, std::min(p, q), std::max(p, q)};
        if (frame.isChord(p, q))
            result.votes = (int)votes[frame.chordIndex(result.s, result.e)];
        return result;
    }

    bool isRingMaximum(const Candidate& candidate, int radius) const
    {
        for (int i = -radius; i <= radius; ++i)
            for (int j = -radius; j <= radius; ++j)
                if (isStronger(at(wrap(candidate.s + i), wrap(candidate.e + j)), candidate))
                    return false;
        return true;
    }

    bool isParallelMaximum(const Candidate& candidate) const
    {
        return !isStronger(at(wrap(candidate.s + 1), wrap(candidate.e - 1)), candidate) &&
               !isStronger(at(wrap(candidate.s - 1), wrap(candidate.e + 1)), candidate);
    }

    /** The ends [first, last) of row s for which the neighbourhood lies in whole rows of the table
    and touches neither the mirror line nor an end of a row, so that neighbours stand at fixed
    distances. */
    Range innerEnds(int s, int radius) const
    {
        const int side = frame.sideOf(s);
        if (s - radius < frame.firstPoint(side) || s + radius >= frame.firstPartner(side))
            return Range(0, 0);
        return Range(frame.firstPartner(side) + radius, borderCount - radius);
    }

    //! isRingMaximum for innerEnds: `centre` points to the candidate's entry.
    static bool isInnerMaximum(const Votes* centre, ptrdiff_t rowLength, int radius)
    {
        // The nearest rows first: most chords lose against a direct neighbour. Neighbours that come
        // before the candidate in the order (s, e) win ties.
        const Votes value = *centre;
        for (int i = 0; i <= radius; ++i)
        {
            const Votes *earlier = centre - i * rowLength, *later = centre + i * rowLength;
            if (i > 0 && earlier[0] >= value)
                return false;
            for (int j = 1; j <= radius; ++j)
                if (earlier[-j] >= value || later[j] > value ||
                    (i > 0 ? earlier[j] >= value || later[-j] > value : false))
                    return false;
            if (later[0] > value)
                return false;
        }
        return true;
    }
};

/** Calls visit(s, e, pointer to the entry) for all chords of rows [begin, end) with more than
`threshold` votes. Most stretches of a table have none: they are passed over by their maximum. */
template<class Votes, class Visit>
void forEachAbove(const RingTable<Votes>& table, int begin, int end, int threshold, Visit visit)
{
    enum
    {
        STRETCH = 64
    };
    for (int s = begin; s < end; ++s)
    {
        const int side = table.frame.sideOf(s), length = table.frame.rowLength(side);
        const int firstEnd = table.frame.firstPartner(side);
        const Votes* row = table.votes + table.frame.rowStart(s);
        for (int i = 0; i < length; i += STRETCH)
        {
            const int stop = std::min<int>(length, i + STRETCH);
            Votes most = 0;
            for (int k = i; k < stop; ++k)
                most = std::max(most, row[k]);
            if ((int64)most <= threshold)
                continue;
            for (int k = i; k < stop; ++k)
                if ((int64)row[k] > threshold)
                    visit(s, firstEnd + k, row + k);
        }
    }
}

const int ROWS_PER_TASK = 32;

/** Collects candidates of blocks of rows in parallel and joins them in the order of the rows.
collect(begin, end, candidates) appends those of rows [begin, end). */
template<class Collect>
std::vector<Candidate> collectByRows(int rows, int rowsPerTask, Collect collect)
{
    const int tasks = (rows + rowsPerTask - 1) / rowsPerTask;
    std::vector<std::vector<Candidate>> parts(tasks);
    parallel_for_(Range(0, tasks),
                  [&](const Range& range)
                  {
                      for (int task = range.start; task < range.end; ++task)
                          collect(task * rowsPerTask, std::min(rows, (task + 1) * rowsPerTask),
                                  parts[task]);
                  });
    std::vector<Candidate> all;
    for (size_t i = 0; i < parts.size(); ++i)
        all.insert(all.end(), parts[i].begin(), parts[i].end());
    return all;
}

/** The chords above the threshold for which isInner(entry, length of a row) holds, where the
neighbourhood of the radius lies within whole rows, and isMaximum(candidate) elsewhere. */
template<class Votes, class IsInner, class IsMaximum>
std::vector<Candidate> maxima(const RingTable<Votes>& table, int rows, int threshold, int radius,
                              IsInner isInner, IsMaximum isMaximum)
{
    return collectByRows(
        rows, ROWS_PER_TASK,
        [&](int begin, int end, std::vector<Candidate>& found)
        {
            int row = -1, rowLength = 0;
            Range inner;
            forEachAbove(table, begin, end, threshold,
                         [&](int s, int e, const Votes* entry)
                         {
                             if (s != row)
                             {
                                 row = s;
                                 rowLength = table.frame.rowLength(table.frame.sideOf(s));
                                 inner = table.innerEnds(s, radius);
                             }
                             const Candidate candidate = {(int)*entry, s, e};
                             if (e >= inner.start && e < inner.end ? isInner(entry, rowLength)
                                                                   : isMaximum(candidate))
                                 found.push_back(candidate);
                         });
        });
}

template<class Votes>
std::vector<Candidate> ringMaxima(const RingTable<Votes>& table, int rows, int threshold,
                                  int radius)
{
    return maxima(
        table, rows, threshold, radius,
        [=](const Votes* entry, ptrdiff_t rowLength)
        { return RingTable<Votes>::isInnerMaximum(entry, rowLength, radius); },
        [=](const Candidate& candidate) { return table.isRingMaximum(candidate, radius); });
}

template<class Votes>
std::vector<Candidate> parallelMaximaOf(const VoteTable& votes, const Cell& frame, int threshold)
{
    const RingTable<Votes> table = {votes.ptr<Votes>(), frame, frame.borderCount()};
    return maxima(
        table, frame.firstPoint(SIDE_LEFT), threshold, 1,
        [](const Votes* entry, ptrdiff_t rowLength)
        { return entry[1 - rowLength] < *entry && entry[rowLength - 1] <= *entry; },
        [=](const Candidate& candidate) { return table.isParallelMaximum(candidate); });
}

template<class Votes>
std::vector<Candidate> blockMaxima(const RingTable<Votes>& table, int rows, int threshold,
                                   int radius)
{
    int block = 1;
    while (block < 2 * radius + 1)
        block *= 2;
    return collectByRows(rows, block,
                         [&](int begin, int end, std::vector<Candidate>& found)
                         {
                             std::vector<Candidate> best(table.borderCount / block + 1);
                             for (size_t i = 0; i < best.size(); ++i)
                                 best[i].votes = threshold; // nobody yet
                             forEachAbove(table, begin, end, threshold,
                                          [&](int s, int e, const Votes* entry)
                                          {
                                              const Candidate candidate = {(int)*entry, s, e};
                                              Candidate& strongest = best[e / block];
                                              if (strongest.votes == threshold ||
                                                  isStronger(candidate, strongest))
                                                  strongest = candidate;
                                          });
                             for (size_t i = 0; i < best.size(); ++i)
                                 if (best[i].votes > threshold)
                                     found.push_back(best[i]);
                         });
}

template<class Votes>
std::vector<Candidate> greedyMaxima(const RingTable<Votes>& table, int rows, int threshold,
                                    int radius)
{
    std::vector<Candidate> all =
        collectByRows(rows, ROWS_PER_TASK,
                      [&](int begin, int end, std::vector<Candidate>& found)
                      {
                          forEachAbove(table, begin, end, threshold,
                                       [&](int s, int e, const Votes* entry)
                                       {
                                           const Candidate candidate = {(int)*entry, s, e};
                                           found.push_back(candidate);
                                       });
                      });
    std::sort(all.begin(), all.end(), isStronger);
    std::vector<bool> deleted(table.frame.chordCount());
    std::vector<Candidate> kept;
    for (size_t k = 0; k < all.size(); ++k)
    {
        const Candidate& candidate = all[k];
        if (deleted[table.frame.chordIndex(candidate.s, candidate.e)])
            continue;
        kept.push_back(candidate);
        for (int i = -radius; i <= radius; ++i)
            for (int j = -radius; j <= radius; ++j)
            {
                const Candidate neighbour =
                    table.at(table.wrap(candidate.s + i), table.wrap(candidate.e + j));
                if (table.frame.isChord(neighbour.s, neighbour.e))
                    deleted[table.frame.chordIndex(neighbour.s, neighbour.e)] = true;
            }
    }
    return kept;
}

template<class Votes>
std::vector<Candidate> findCandidatesOf(const VoteTable& votes, const Cell& frame, int threshold,
                                        int suppression, int radius)
{
    const RingTable<Votes> table = {votes.ptr<Votes>(), frame, frame.borderCount()};
    const int rows = frame.firstPoint(SIDE_LEFT);
    // On a ring of fewer points a neighbourhood would meet itself.
    radius = std::min(radius, (frame.borderCount() - 1) / 2);
    if (suppression == SUPPRESS_BLOCKS)
        return blockMaxima(table, rows, threshold, radius);
    if (suppression == SUPPRESS_GREEDY)
        return greedyMaxima(table, rows, threshold, radius);
    return ringMaxima(table, rows, threshold, radius);
}

} // namespace

std::vector<Candidate> findCandidates(const VoteTable& table, const Cell& frame, int threshold,
                                      int suppression, int radius)
{
    CV_DbgAssert(table.cells == 1 && table.chords == frame.chordCount() && threshold >= 0);
    if (table.depth == 1)
        return findCandidatesOf<uchar>(table, frame, threshold, suppression, radius);
    if (table.depth == 2)
        return findCandidatesOf<ushort>(table, frame, threshold, suppression, radius);
    return findCandidatesOf<int>(table, frame, threshold, suppression, radius);
}

std::vector<Candidate> findParallelMaxima(const VoteTable& table, const Cell& frame, int threshold)
{
    CV_DbgAssert(table.cells == 1 && table.chords == frame.chordCount() && threshold >= 0);
    if (table.depth == 1)
        return parallelMaximaOf<uchar>(table, frame, threshold);
    if (table.depth == 2)
        return parallelMaximaOf<ushort>(table, frame, threshold);
    return parallelMaximaOf<int>(table, frame, threshold);
}

void keepStrongest(std::vector<Candidate>& candidates, size_t count)
{
    if (count >= candidates.size())
        return;
    std::nth_element(candidates.begin(), candidates.begin() + count, candidates.end(), isStronger);
    candidates.resize(count);
}

} // namespace linespace
} // namespace cv
