// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Exact votes of parallel chords of a family, many at a time (doc/algorithm.md, section 5).

#ifndef OPENCV_LINESPACE_PARALLEL_BAND_HPP
#define OPENCV_LINESPACE_PARALLEL_BAND_HPP

#include "../edge_planes.hpp"
#include "../strips/strip_plan.hpp"

namespace cv {
namespace linespace {

enum
{
    PARALLEL_REACH = 3,                 //!< parallel chords on either side of one
    PARALLELS = 2 * PARALLEL_REACH + 1, //!< that are counted together
    PARALLEL_PIXELS = 16 //!< of a column that are read, half of them before the chord's
};

/** Columns of pixels around the chord (y, t) of a family: bit b of words[i] is pixel q - 8 + b of
column first + i, where q is the chord's own pixel there. rests[i], in 0 .. modulus - 1, is the
remainder of its exact position, of which q is the quotient, so that for (y, t + d) the remainder is
larger by d (2 (first + i) + 1). Behind the last column are SPARE zeros. */
struct ParallelColumns
{
    enum
    {
        SPARE = 256
    };
    const ushort *words, *rests;
    int first, count, modulus;
};

/** Adds the votes of the chords (y + i - PARALLEL_REACH, t + d) to votes[i]; |d| <= 4. */
void countParallels(const ParallelColumns& columns, int d, int* votes);
//! The same by a plain loop.
void countParallelsOneByOne(const ParallelColumns& columns, int d, int* votes);

//! From a chord of a family to one nearby with more votes; for one thread.
class ParallelClimber
{
public:
    //! @param isReference counts by plain loops, with the same result.
    explicit ParallelClimber(const EdgePlanes& planes, bool isReference = false)
        : planes_(planes), isReference_(isReference), y_(0), t_(0)
    {
    }

    //! Whether the family is narrow enough for 16 bits.
    static bool canClimb(const StripFamily& family) { return family.strips <= 256; }

    /** Goes to the strongest of the chords (y + i, t + d), |i|, |i + d|, |d| <= 2, and so on until
    none is stronger. Pixels count that vote for the bin of the chord from which the band was read.
    @param y,t of the chord, and of the one that it comes to.
    @return its votes. */
    int climb(const StripFamily& family, int& y, int& t);

private:
    enum
    {
        MOST_TURN = 4 //!< of |d|
    };
    void read(const StripFamily& family, int y, int t);
    int votes(int i, int d);

    const EdgePlanes& planes_;
    const bool isReference_;
    int y_, t_, first_, count_, modulus_;
    std::vector<ushort> words_, rests_;
    bool isCounted_[2 * MOST_TURN + 1];
    int votes_[2 * MOST_TURN + 1][PARALLELS];
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_PARALLEL_BAND_HPP
