// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// From a chord that may have many votes to a maximum of the exact votes (doc/algorithm.md, section
// 4.2).

#ifndef OPENCV_LINESPACE_CLIMB_HPP
#define OPENCV_LINESPACE_CLIMB_HPP

#include "../peaks.hpp"
#include "chord_band.hpp"

namespace cv {
namespace linespace {

//! Climbs on the votes of planes, which must outlive it; for one thread.
class Climber
{
public:
    enum
    {
        RADIUS = 2 //!< border points: of the neighbourhood whose strongest chord is a maximum
    };
    //! @param isReference counts each chord by its pixels, with the same result.
    explicit Climber(const EdgePlanes& planes, bool isReference = false);

    /** Goes to the strongest chord, in the total order, of the (2 RADIUS + 1)^2 ring neighbourhood,
    and so on until none is stronger.
    @param chord s < e.
    @return the maximum with exact votes. */
    Candidate climb(Chord chord);

private:
    enum
    {
        SPAN = ChordBand::REACH, //!< from the chord around which votes are remembered
        SIDE = 2 * SPAN + 1
    };
    void startAt(Chord chord);
    //! The chord whose ends are so many border points after those of the one in the middle.
    Candidate at(int i, int j);
    int count(Chord chord);

    const EdgePlanes& planes_;
    const bool isReference_;
    const Cell frame_;
    const int points_; //!< on the ring
    Chord middle_;
    int votes_[SIDE][SIDE]; //!< UNKNOWN, or those of at(i, j), of a pair on one side -1
    ChordBand bands_[2];    //!< of the bins that these chords have
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_CLIMB_HPP
