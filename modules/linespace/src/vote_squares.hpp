// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Exact votes of chords, counted when they are asked for, each once, by squares of neighbours.

#ifndef OPENCV_LINESPACE_VOTE_SQUARES_HPP
#define OPENCV_LINESPACE_VOTE_SQUARES_HPP

#include "chord_counter.hpp"
#include "edge_pieces.hpp"
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

    VoteSquares() : planes_(0) {}

    //! A cell with a border point for each run of a frame's; its chords are the squares, on devices
    //! as well.
    static Cell runsOf(const Cell& frame)
    {
        return Cell((frame.width + SQUARE - 1) / SQUARE, (frame.height + SQUARE - 1) / SQUARE);
    }

    //! Forgets all votes; those asked for from now on are of these planes, which must outlive it.
    void reset(const EdgePlanes& planes);
    void clear();
    //! Bytes kept, besides those of the squares in use.
    static double memory(const Cell& frame, bool hasPieces);
    //! Bytes of so many squares, or of all there are.
    static double squareMemory(const Cell& frame, double squares);

    //! Marks a chord; whether it was not marked before.
    bool mark(Chord chord);

    //! Marks a chord and asks for the votes of all (s + i, e + j) of the ring, |i|, |j| <= radius;
    //! s < e. Fast if chords near each other follow one another.
    void want(Chord chord, int radius);
    //! Counts what is wanted, in parallel.
    void countWanted();

    /** The strongest chord of a neighbourhood that was counted, the chord itself included, in the
    total order; may be called from several threads at once. */
    Candidate strongestAround(Chord chord, int radius) const;

private:
    struct Square
    {
        int s, e;                       //!< of its first chord
        uint64 marked, wanted, counted; //!< bit SQUARE i + j for chord (s + i, e + j)
        int votes[SQUARE * SQUARE];
    };
    //! A chord's square and its place there.
    struct Place
    {
        size_t square;
        int row, column;
    };

    //! A chord by the positions of its ends on their sides.
    struct Position
    {
        int sideS, sideE, u, w;
    };

    Place placeOf(Chord chord) const;
    //! The index of the square of two runs, counted from the first ones of their sides.
    size_t squareOf(int sideS, int sideE, int runS, int runE) const
    {
        return firstSquares_[sideS][sideE] + (size_t)runS * rowLengths_[sideS] + runE;
    }
    Square& squareAt(size_t index, int s, int e);
    Square& addSquare(size_t index, int s, int e);
    void wantOf(Square& square, uint64 chords);
    Position positionOf(Chord chord) const;
    bool isInside(const Position& position, int radius) const;
    template<class Visit>
    void forEachPart(const Position& position, int radius, Visit visit) const;
    //! The votes of a square of the same sides as a chord.
    const int* votesOf(const Position& position, int runS, int runE) const
    {
        return squares_[slots_[squareOf(position.sideS, position.sideE, runS, runE)]].votes;
    }
    Candidate strongestAcrossCorners(Chord chord, int radius) const;
    template<class Visit>
    void forEachOnRing(Chord chord, int radius, Visit visit) const;

    //! The chords between top and bottom, or right and left, by families: those with equal u - v,
    //! where u is the position of s along its side, and v that of e, counted the other way.
    struct Pair
    {
        bool mayHavePieces, hasPieces;
        EdgePieces pieces;
        int length, columns;        //!< of the sides, and from one to the other
        size_t words;               //!< of a family
        std::vector<uint64> strips; //!< a bit for each PARALLEL chords of a family, from u = 0 on
    };

    void resetPair(int side);
    int pairOf(const Square& square) const;
    int familyOf(const Pair& pair, const Square& square) const;
    void wantStrips(Pair& pair, Square& square);
    void countStrips(Pair& pair);
    void takeStrips(Pair& pair, int family, std::vector<int>& starts) const;
    template<class Visit>
    void forEachPartOfStrip(const Pair& pair, int family, int start, Visit visit);
    void takeVotes(const Pair& pair, int family, int start, const int* votes);
    void countAlone();
    void fill(Square& square, int together) const;

    const EdgePlanes* planes_;
    Pair pairs_[2];
    Cell frame_, runs_;                         //!< runs_: a cell with a border point for each run
    size_t firstSquares_[4][4], rowLengths_[4]; //!< index of the first one of two sides; of a row
    std::vector<int> slots_; //!< of each square, by chords of runs_; -1: not in use
    std::vector<Square> squares_;
    std::vector<int> wanted_; //!< slots
    std::vector<int> alone_;  //!< those of them that are counted without pieces
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_VOTE_SQUARES_HPP
