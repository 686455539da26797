// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The candidates of a cascade without the tables of its last levels (doc/algorithm.md, section
// 4, point 6). A bundle is the SIDE x SIDE chords between two runs of SIDE border points. The most
// votes that any of its chords can have follows from the bundles of the two children, as votes do,
// for a sixteenth of the work; what cannot reach a candidate's votes is never counted. The
// candidates are those that the table would give.

#ifndef OPENCV_LINESPACE_BUNDLES_HPP
#define OPENCV_LINESPACE_BUNDLES_HPP

#include "peaks.hpp"

namespace cv {
namespace linespace {

enum
{
    BUNDLE_SIDE = 4, //!< border points at either end
    BUNDLE_CHORDS = BUNDLE_SIDE * BUNDLE_SIDE,
    BUNDLE_LEVELS = 3 //!< levels at the top that have no tables, at most
};

/** The bundles of all cells of one level, in the order of a table (VoteTable) of cells of a
BUNDLE_SIDE-th of the size, whose border points are runs of the level's. */
struct BundleLevel
{
    enum
    {
        NOT_NEEDED = USHRT_MAX
    };
    //! Bundles of the shared side that the chords of one cross, first to last.
    struct Crossed
    {
        int first, last;
    };
    Cell coarse;
    size_t cells; //!< 1 << cellBits
    int cellBits;
    ushort* bounds;   //!< no chord of the bundle has more votes
    ushort* required; //!< with fewer votes none is needed; NOT_NEEDED: none at all
    int* slots;       //!< of those that are needed, where their votes stand
    Buffer crossed;   //!< Crossed, by slots, of bundles whose ends lie on different children
    /** BUNDLE_CHORDS ushorts for each slot, by s and e; exact, or not more than the exact votes if
    these are fewer than required. */
    Buffer votes;

    size_t bundleCount() const { return coarse.chordCount() << cellBits; }
    Crossed& crossedOf(int slot) const { return ((Crossed*)crossed.data())[slot]; }
    ushort* votesIn(int slot) const { return (ushort*)votes.data() + (size_t)slot * BUNDLE_CHORDS; }
    //! The votes of a bundle that is needed.
    ushort* votesOf(size_t bundle) const { return votesIn(slots[bundle]); }
};

class BundleSearch
{
public:
    BundleSearch() : top_(0), sampleStep_(1), usual_(-1), pause_(0), rest_(0) {}

    /** The level from whose table bundles take over; -1 if they cannot: frames of a few levels,
    cells whose sides are no multiples of BUNDLE_SIDE, votes of more than 16 bits. */
    static int baseLevel(const Plan& plan, bool weighted);
    //! Bytes that a search from that level allocates at most, but for the candidates and what
    //! `room` has anyway, which is a table of at least a byte per chord.
    static double memory(const Plan& plan, int base);

    //! Whether to search an image of that size; not if that was in vain for the images before.
    bool isWorthATry(Size size);

    /** Bounds of all bundles from the base level, whose table is given, to the last one.
    @param room where they are kept until find() has returned. */
    void bound(const Plan& plan, int base, const VoteTable& table, Buffer& room);

    /** The candidates that findParallelMaxima, or with a radius >= 0 findCandidates with
    SUPPRESS_RING, finds in the table of the last level, in no particular order.
    @param table that of bound().
    @return false if most chords would have to be counted, for which whole tables are faster. */
    bool find(const Plan& plan, const Wanted& wanted, int radius, const VoteTable& table,
              std::vector<Candidate>& found);

    void clear();

private:
    size_t survivors(int cut) const;
    int cutFor(size_t count, int least) const;
    static int usualCut(const std::vector<Candidate>& found, const Wanted& wanted, int cut);
    int lowerCut(const std::vector<Candidate>& found, const Wanted& wanted, int cut) const;
    static double roomBytes(const Plan& plan, int base);
    void setLeast(const Plan& plan, const Wanted& wanted, int radius);
    void requireAbove(int cut);
    bool count(const VoteTable& table);
    void maxima(int cut, const Wanted& wanted, int radius, std::vector<Candidate>& found) const;

    Cell cell_;                             //!< of the base level
    BundleLevel levels_[BUNDLE_LEVELS + 1]; //!< from the base level on
    int top_;                               //!< the last one
    Merge merges_[BUNDLE_LEVELS];           //!< to levels_[i + 1]
    std::vector<ushort>
        least_; //!< with fewer votes no chord of a bundle of the last level is accepted
    std::vector<int> histogram_; //!< of some of the last level's bounds
    size_t sampleStep_;          //!< one bundle of so many is among them, on average
    Size size_;                  //!< of the last image
    //! What cut the last image should have begun with, -1: none. The next one of a video hardly
    //! differs; what is found does not depend on it.
    int usual_;
    int pause_,
        rest_; //!< images that are not searched after one that was in vain; of these, to come
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_BUNDLES_HPP
