// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// From the cascade's maxima to chords with the most exact votes (doc/algorithm.md, section 4.2).

#ifndef OPENCV_LINESPACE_ASCENT_HPP
#define OPENCV_LINESPACE_ASCENT_HPP

#include "chord_counter.hpp"
#include "peaks.hpp"

#include <unordered_map>

namespace cv {
namespace linespace {

/** Moves candidates to maxima of the exact votes: to the strongest, in the total order, of the
(2 radius + 1)^2 ring neighbourhood, and so on until there is none that is stronger. Votes are
counted once for each chord that is looked at, however many pass by. */
class Ascent
{
public:
    Ascent(const ChordCounter& counter, const Cell& frame, int radius);

    //! The candidates' votes are exact, before and after.
    void climb(std::vector<Candidate>& candidates);

private:
    template<class Visit>
    void forEachNeighbour(Chord chord, Visit visit) const;
    //! Counts the chords that were asked for.
    void countAsked();

    const ChordCounter& counter_;
    Cell frame_;
    int radius_;
    std::unordered_map<size_t, int> votes_; //!< by the chords' indices
    std::vector<Chord> asked_;
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_ASCENT_HPP
