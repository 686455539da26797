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

/** The line of a chord by its ends in doubled coordinates, x along its major axis: it begins at
(x, y) and goes on by (dx, dy), dx > 0. Its pixel in column c is the floor of
(y dx + (2 c + 1 - x) dy) / (2 dx). As all these numerators have the same parity, half of the
numerator, rounded down, over dx has the same floor. y is relative to an even one that is the same
for all lanes, so that products fit 32 bits. */
struct LaneLine
{
    int x, y, dx, dy;
    //! The numerator over dx.
    int64 at(int column) const { return ((int64)y * dx + (int64)(2 * column + 1 - x) * dy) >> 1; }
};

//! Lines that are counted together, all rising or level, or all falling (dy < 0).
struct ChordLanes
{
    enum
    {
        COUNT = 32,
        //! What the ends may be apart from those of the guide, in pixels. The chord itself is then
        //! no farther from it in any column, see LaneMap.
        REACH = 4,
        //! The least and most of dx: for REACH, and because of the fractions.
        LEAST_DX = 64,
        MOST_DX = 16384
    };
    int count;
    int x[COUNT], y[COUNT], dx[COUNT], dy[COUNT]; //!< dy != dx
    uchar bit[COUNT]; //!< of the pixels that vote, where the map has bits

    ChordLanes() : count(0) {}
    void add(const LaneLine& line, uchar ownBit)
    {
        x[count] = line.x;
        y[count] = line.y;
        dx[count] = line.dx;
        dy[count] = line.dy;
        bit[count++] = ownBit;
    }
    LaneLine line(int lane) const
    {
        const LaneLine result = {x[lane], y[lane], dx[lane], dy[lane]};
        return result;
    }
};

/** What the lanes run over: rows of pixels across the chords, one for each of their columns, with
zeros where a line that is drawn on beyond its ends leaves the map; so the lanes of chords that
begin or end up to 2 REACH - 1 columns later than others need nothing special.

All pixels of a column are in a window of 16, which follows a guide, one of the chords or their
like: at the first of RUN columns the lanes are within REACH of it, and go on by up to RUN - 1
pixels until the window is moved (upwards, if that of a falling group moves down by a pixel in each
column). */
struct LaneMap
{
    const uchar* votes; //!< of column 0; 0 or 1, or weights
    const uchar* bits;  //!< null: all pixels vote
    bool weighted;
    ptrdiff_t stride;
    int firstColumn, columns;
    LaneLine guide;
    bool falling;

    enum
    {
        WINDOW = 16,
        RUN = 8
    };
};

//! Whether the machine's instruction set is worth it.
bool hasChordLanes();

//! The votes of each lane, of all ChordLanes::COUNT if there are that many; only if
//! hasChordLanes().
void countChordLanes(const ChordLanes& lanes, const LaneMap& map, int* votes);

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_CHORD_LANES_HPP
