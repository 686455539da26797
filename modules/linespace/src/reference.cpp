// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The definition as code: every stage in the plainest form, in the order of doc/algorithm.md. It is
// the oracle of the other back ends and is never optimised.

#include "stages.hpp"

namespace cv {
namespace linespace {

namespace {

void setVotes(VoteTable& table, size_t chord, size_t cell, int votes)
{
    const size_t i = chord * table.cells + cell;
    if (table.depth == 1)
        table.ptr<uchar>()[i] = (uchar)votes;
    else if (table.depth == 2)
        table.ptr<ushort>()[i] = (ushort)votes;
    else
        table.ptr<int>()[i] = votes;
}

//! Calls visit(chord) for every canonical chord of a cell, in the order of their indices.
template<class Visit>
void forEachChord(const Cell& cell, Visit visit)
{
    for (int s = 0; s < cell.firstPoint(SIDE_LEFT); ++s)
        for (int e = cell.firstPartner(cell.sideOf(s)); e < cell.borderCount(); ++e)
        {
            const Chord chord = {s, e};
            visit(chord);
        }
}

class ReferenceExecutor : public Executor
{
public:
    int backend() const CV_OVERRIDE { return BACKEND_REFERENCE; }

    // Section 3.2: the first cells.
    void firstCells(const EdgeMap& edges, const Plan& plan, VoteTable& table) CV_OVERRIDE
    {
        const Level& level = plan.level(0);
        const Cell cell = level.cell;
        std::vector<int> rowBits, columnBits;
        plan.cellOrder(0, rowBits, columnBits);
        for (int row = 0; row < level.grid.height; ++row)
            for (int column = 0; column < level.grid.width; ++column)
                forEachChord(cell,
                             [&](Chord chord)
                             {
                                 const ushort bit = directionBit(cell, chord);
                                 int sum = 0;
                                 Raster(cell, chord)
                                     .forEachPixel(
                                         [&](int x, int y)
                                         {
                                             x += column * cell.width;
                                             y += row * cell.height;
                                             if (x < edges.votes.cols && y < edges.votes.rows &&
                                                 (!edges.isOriented() ||
                                                  (edges.directions.at<ushort>(y, x) & bit)))
                                                 sum += edges.votes.at<uchar>(y, x);
                                         });
                                 setVotes(table, cell.chordIndex(chord.s, chord.e),
                                          rowBits[row] + columnBits[column], sum);
                             });
    }

    // Section 3.3: one merge.
    void mergeCells(const Plan& plan, int level, const VoteTable& child,
                    VoteTable& parent) CV_OVERRIDE
    {
        const Merge merge = plan.merge(level);
        const Cell& cell = merge.child;
        forEachChord(merge.parent,
                     [&](Chord chord)
                     {
                         const size_t parentChord = merge.parent.chordIndex(chord.s, chord.e);
                         const int childS = merge.childOf(chord.s), childE = merge.childOf(chord.e);
                         const int s = merge.childPoint(chord.s), e = merge.childPoint(chord.e);
                         for (size_t c = 0; c < parent.cells; ++c)
                         {
                             const size_t cellS = childS * parent.cells + c,
                                          cellE = childE * parent.cells + c;
                             if (childS == childE)
                                 setVotes(parent, parentChord, c,
                                          child.at(cell.chordIndex(s, e), cellS));
                             else
                             {
                                 const int m = merge.crossing(chord.s, chord.e);
                                 const int shareS = merge.sharedPoint(childS, m),
                                           shareE = merge.sharedPoint(childE, m);
                                 CV_DbgAssert(cell.isChord(s, shareS) && cell.isChord(e, shareE));
                                 setVotes(parent, parentChord, c,
                                          child.at(cell.chordIndexOf(s, shareS), cellS) +
                                              child.at(cell.chordIndexOf(e, shareE), cellE));
                             }
                         }
                     });
    }

    // Section 2.3: every chord of the image by its raster.
    void exactVotes(const EdgeMap& edges, const Plan& plan, VoteTable& table) CV_OVERRIDE
    {
        const Cell frame = plan.frame();
        forEachChord(frame,
                     [&](Chord chord) {
                         setVotes(table, frame.chordIndex(chord.s, chord.e), 0,
                                  chordVotes(edges, frame, chord));
                     });
    }

    // Section 4.2: the candidates' exact votes.
    void rescore(const EdgeMap& edges, const Plan& plan, const std::vector<Chord>& chords,
                 std::vector<int>& votes) CV_OVERRIDE
    {
        votes.resize(chords.size());
        for (size_t i = 0; i < chords.size(); ++i)
            votes[i] = chordVotes(edges, plan.frame(), chords[i]);
    }
};

} // namespace

Ptr<Executor> createReferenceExecutor()
{
    return makePtr<ReferenceExecutor>();
}

} // namespace linespace
} // namespace cv
