// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "ring_maxima.hpp"

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

    //! 0 for two points on one side.
    int operator()(int p, int q) const
    {
        return frame.isChord(p, q) ? (int)votes[frame.chordIndexOf(p, q)] : 0;
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

/** The local maxima of a table, for any neighbourhood: isInner(entry, length of a row) where
that of the radius lies within whole rows, isMaximum(candidate) elsewhere. */
template<class Votes, class IsInner, class IsMaximum>
class Maxima
{
public:
    Maxima(const RingTable<Votes>& table, int rows, int radius, IsInner isInner,
           IsMaximum isMaximum)
        : table_(table), rows_(rows), radius_(radius), isInner_(isInner), isMaximum_(isMaximum)
    {
    }

    /** A table has hundreds of thousands of maxima above a usual threshold, most of which come to
    nothing: only those above a cut are looked for, which a sample of the rows tells. What is
    returned does not depend on it: with fewer than the wanted number, it was too high. */
    std::vector<Candidate> strongest(const Wanted& wanted) const
    {
        for (int cut = sampledCut(wanted);; cut = wanted.threshold + (cut - wanted.threshold) / 2)
        {
            std::vector<Candidate> found =
                collectByRows(rows_, ROWS_PER_TASK,
                              [&](int begin, int end, std::vector<Candidate>& part)
                              { collect(begin, end, cut, wanted, part); });
            if (found.size() < wanted.most && cut > wanted.threshold)
                continue;
            keepStrongest(found, wanted.most);
            return found;
        }
    }

private:
    enum
    {
        SAMPLE = 32 //!< one row of so many
    };

    int sampledCut(const Wanted& wanted) const
    {
        if (wanted.most >= table_.frame.chordCount() / SAMPLE)
            return wanted.threshold;
        std::vector<Candidate> sample;
        for (int s = SAMPLE / 2; s < rows_; s += SAMPLE)
            collect(s, s + 1, wanted.threshold, wanted, sample);
        // Half as many again, as the maxima of strong lines stand together in a few rows.
        const size_t share = (wanted.most + wanted.most / 2) / SAMPLE;
        if (share >= sample.size())
            return wanted.threshold;
        std::nth_element(sample.begin(), sample.begin() + share, sample.end(), isStronger);
        return sample[share].votes - 1;
    }

    void collect(int begin, int end, int cut, const Wanted& wanted,
                 std::vector<Candidate>& found) const
    {
        int row = -1, rowLength = 0;
        Range inner;
        forEachAbove(table_, begin, end, cut,
                     [&](int s, int e, const Votes* entry)
                     {
                         if (s != row)
                         {
                             row = s;
                             rowLength = table_.frame.rowLength(table_.frame.sideOf(s));
                             inner = table_.innerEnds(s, radius_);
                         }
                         const Candidate candidate = {(int)*entry, s, e};
                         if ((e >= inner.start && e < inner.end ? isInner_(entry, rowLength)
                                                                : isMaximum_(candidate)) &&
                             (!wanted.accepts || wanted.accepts(candidate)))
                             found.push_back(candidate);
                     });
    }

    const RingTable<Votes> table_;
    const int rows_, radius_;
    const IsInner isInner_;
    const IsMaximum isMaximum_;
};

template<class Votes, class IsInner, class IsMaximum>
std::vector<Candidate> strongestMaxima(const RingTable<Votes>& table, int radius,
                                       const Wanted& wanted, IsInner isInner, IsMaximum isMaximum)
{
    return Maxima<Votes, IsInner, IsMaximum>(table, table.frame.firstPoint(SIDE_LEFT), radius,
                                             isInner, isMaximum)
        .strongest(wanted);
}

template<class Votes>
std::vector<Candidate> ringMaxima(const RingTable<Votes>& table, const Wanted& wanted, int radius)
{
    return strongestMaxima(
        table, radius, wanted,
        [=](const Votes* entry, ptrdiff_t rowLength)
        { return RingTable<Votes>::isInnerMaximum(entry, rowLength, radius); },
        [=](const Candidate& candidate)
        { return isRingMaximum(table, table.frame, candidate, radius); });
}

template<class Votes>
std::vector<Candidate> parallelMaximaOf(const VoteTable& votes, const Cell& frame,
                                        const Wanted& wanted)
{
    const RingTable<Votes> table = {votes.ptr<Votes>(), frame, frame.borderCount()};
    return strongestMaxima(
        table, 1, wanted,
        [](const Votes* entry, ptrdiff_t rowLength)
        { return entry[1 - rowLength] < *entry && entry[rowLength - 1] <= *entry; },
        [=](const Candidate& candidate)
        { return isParallelMaximum(table, table.frame, candidate); });
}

template<class Votes>
std::vector<Candidate> blockMaxima(const RingTable<Votes>& table, int rows, int threshold,
                                   int radius)
{
    const int block = blockSide(radius);
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
std::vector<Candidate> allAbove(const RingTable<Votes>& table, int rows, int threshold)
{
    return collectByRows(rows, ROWS_PER_TASK,
                         [&](int begin, int end, std::vector<Candidate>& found)
                         {
                             forEachAbove(table, begin, end, threshold,
                                          [&](int s, int e, const Votes* entry)
                                          {
                                              const Candidate candidate = {(int)*entry, s, e};
                                              found.push_back(candidate);
                                          });
                         });
}

//! What is wanted of candidates that were found among all.
void keepWanted(const Wanted& wanted, std::vector<Candidate>& candidates)
{
    if (wanted.accepts)
        candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                        [&](const Candidate& candidate)
                                        { return !wanted.accepts(candidate); }),
                         candidates.end());
    keepStrongest(candidates, wanted.most);
}

template<class Votes>
std::vector<Candidate> findCandidatesOf(const VoteTable& votes, const Cell& frame,
                                        const Wanted& wanted, int suppression, int radius)
{
    const RingTable<Votes> table = {votes.ptr<Votes>(), frame, frame.borderCount()};
    const int rows = frame.firstPoint(SIDE_LEFT);
    radius = mostRadius(frame, radius);
    if (suppression == SUPPRESS_RING)
        return ringMaxima(table, wanted, radius);
    if (suppression == SUPPRESS_GREEDY)
        return greedyCandidates(allAbove(table, rows, wanted.threshold), frame, wanted, radius);
    std::vector<Candidate> found = blockMaxima(table, rows, wanted.threshold, radius);
    keepWanted(wanted, found);
    return found;
}

} // namespace

int mostRadius(const Cell& frame, int radius)
{
    return std::min(radius, (frame.borderCount() - 1) / 2);
}

int blockSide(int radius)
{
    int side = 1;
    while (side < 2 * radius + 1)
        side *= 2;
    return side;
}

void keepStrongest(std::vector<Candidate>& candidates, size_t count)
{
    if (count >= candidates.size())
        return;
    std::nth_element(candidates.begin(), candidates.begin() + count, candidates.end(), isStronger);
    candidates.resize(count);
}

std::vector<Candidate> findCandidates(const VoteTable& table, const Cell& frame,
                                      const Wanted& wanted, int suppression, int radius)
{
    CV_DbgAssert(table.cells == 1 && table.chords == frame.chordCount() && wanted.threshold >= 0);
    if (table.depth == 1)
        return findCandidatesOf<uchar>(table, frame, wanted, suppression, radius);
    if (table.depth == 2)
        return findCandidatesOf<ushort>(table, frame, wanted, suppression, radius);
    return findCandidatesOf<int>(table, frame, wanted, suppression, radius);
}

std::vector<Candidate> greedyCandidates(std::vector<Candidate> above, const Cell& frame,
                                        const Wanted& wanted, int radius)
{
    radius = mostRadius(frame, radius);
    std::sort(above.begin(), above.end(), isStronger);
    std::vector<bool> deleted(frame.chordCount());
    std::vector<Candidate> kept;
    for (size_t k = 0; k < above.size(); ++k)
    {
        const Candidate& candidate = above[k];
        if (deleted[frame.chordIndex(candidate.s, candidate.e)])
            continue;
        kept.push_back(candidate);
        for (int i = -radius; i <= radius; ++i)
            for (int j = -radius; j <= radius; ++j)
            {
                const int points = frame.borderCount(), p = (candidate.s + i + points) % points,
                          q = (candidate.e + j + points) % points;
                if (frame.isChord(p, q))
                    deleted[frame.chordIndexOf(p, q)] = true;
            }
    }
    keepWanted(wanted, kept);
    return kept;
}

std::vector<Candidate> findParallelMaxima(const VoteTable& table, const Cell& frame,
                                          const Wanted& wanted)
{
    CV_DbgAssert(table.cells == 1 && table.chords == frame.chordCount() && wanted.threshold >= 0);
    if (table.depth == 1)
        return parallelMaximaOf<uchar>(table, frame, wanted);
    if (table.depth == 2)
        return parallelMaximaOf<ushort>(table, frame, wanted);
    return parallelMaximaOf<int>(table, frame, wanted);
}

} // namespace linespace
} // namespace cv
