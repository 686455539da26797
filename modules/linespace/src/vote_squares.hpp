// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Exact votes of chords, counted when they are asked for, each once, by squares of neighbours.

#ifndef OPENCV_LINESPACE_VOTE_SQUARES_HPP
#define OPENCV_LINESPACE_VOTE_SQUARES_HPP

#include "chord_counter.hpp"
#include "peaks.hpp"

namespace cv {
namespace linespace {

/** The border points of each side are cut into runs of SQUARE from its first one on; a square is
the chords between two runs of different sides. */
class VoteSquares
{
public:
    enum
    {
        SQUARE = ChordCounter::SQUARE
    };

    //! Forgets all votes.
    void reset(const Cell& frame);
    void clear();
    //! Bytes kept, besides those of the squares in use.
    static double memory(const Cell& frame);
    //! Bytes of so many squares, or of all there are.
    static double squareMemory(const Cell& frame, double squares);

    //! Marks a chord; whether it was not marked before.
    bool mark(Chord chord);

    //! Asks for the votes of all chords (s + i, e + j) of the ring, |i|, |j| <= radius; s < e.
    void want(Chord chord, int radius);
    //! Counts what is wanted, in parallel.
    void countWanted(const ChordCounter& counter);

    /** The strongest chord of a neighbourhood that was counted, the chord itself included, in the
    total order; may be called from several threads at once. */
    Candidate strongestAround(Chord chord, int radius) const;

private:
    struct Square
    {
        int s, e; //!< of its first chord
        uint64 marked, wanted, counted; //!< bit SQUARE i + j for chord (s + i, e + j)
        int votes[SQUARE * SQUARE];
    };
    //! A chord's square and its place there.
    struct Place
    {
        size_t square;
        int row, column;
    };

    //! A neighbourhood by positions on its sides; some may be beyond these.
    struct Around
    {
        int sideS, sideE, firstU, lastU, firstV, lastV;
    };

    Place placeOf(Chord chord) const;
    Square& squareAt(size_t index, int s, int e);
    void wantOf(Square& square, uint64 chords);
    Around around(Chord chord, int radius) const;
    bool isInside(const Around& around) const;
    template<class Visit>
    void forEachOnRing(Chord chord, int radius, Visit visit) const;

    Cell frame_, runs_;      //!< runs_: a cell with a border point for each run
    std::vector<int> slots_; //!< of each square, by chords of runs_; -1: not in use
    std::vector<Square> squares_;
    std::vector<int> wanted_; //!< slots
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_VOTE_SQUARES_HPP
