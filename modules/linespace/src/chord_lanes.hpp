// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Neighbouring chords that are counted together (chord_lanes.simd.hpp): who prepares them is
// ChordCounter.

#ifndef OPENCV_LINESPACE_CHORD_LANES_HPP
#define OPENCV_LINESPACE_CHORD_LANES_HPP

#include "precomp.hpp"

namespace cv {
namespace linespace {

/** Rasters of the same major axis, from their first common column on. Falling ones are kept as
rising ones, the remainder r as modulus - 1 - r: it passes the modulus where r falls below 0. */
struct ChordLanes
{
    enum
    {
        COUNT = 32,
        REACH = 2 //!< no lane's pixel is farther from the guide's, see LaneMap
    };
    short rest[COUNT];      //!< the remainder, 0 to modulus - 1
    short step[COUNT];      //!< 0 to modulus
    short modulus[COUNT];   //!< 1 to 2^15 - 1
    uchar position[COUNT];  //!< of the first pixel in the window
    uchar direction[COUNT]; //!< 1, or 255 where the chord falls
    uchar bit[COUNT];       //!< of the pixels that vote, where there are bits; 0: none
};

/** What the lanes run over: rows of pixels across the chords, one for each column of the rasters.
The window of a column is 16 pixels and starts `below` before the guide, one of the chords, which is
at (start + i increment) >> 32 in the i-th column. Windows are readable beyond the map. */
struct LaneMap
{
    const uchar* votes; //!< of the first column; 0 or 1, or weights
    const uchar* bits;  //!< null: all pixels vote
    bool weighted;
    ptrdiff_t stride;
    int columns;
    int64 start, increment;
    int below;

    enum
    {
        WINDOW = 16,
        //! Columns from one move of the window to the next: the lanes go as far as RUN - 1 pixels
        //! the guide's way meanwhile, and BACK the other way, as chords of MIN_COLUMNS whose ends
        //! are apart by at most REACH differ in slope by a quarter at most.
        RUN = 8,
        BACK = 3,
        MIN_COLUMNS = 16
    };
    static int belowFor(bool guideFalls) { return ChordLanes::REACH + (guideFalls ? +RUN : +BACK); }
};

//! Whether the machine's instruction set is worth it.
bool hasChordLanes();

//! Adds each lane's votes to votes[lane]; only if hasChordLanes().
void countChordLanes(const ChordLanes& lanes, const LaneMap& map, int* votes);

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_CHORD_LANES_HPP
