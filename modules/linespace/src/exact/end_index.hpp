// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// This index tells whether a chord of an image has both ends near those of another one.

#ifndef OPENCV_LINESPACE_END_INDEX_HPP
#define OPENCV_LINESPACE_END_INDEX_HPP

#include "../plan.hpp"

namespace cv {
namespace linespace {

/** Chords by their ends, in integers. A hash of the border points keeps the search short; the answer
is that of a comparison with all chords. */
class EndIndex
{
public:
    //! @param distance pixels, within which both ends are near, 0 or more.
    EndIndex(const Cell& frame, double distance);
    void insert(Chord chord);
    bool hasNear(Chord chord) const;

private:
    struct Entry
    {
        Point own,
            other; //!< doubled coordinates of the end that the entry is found by, and the other
        int next;  //!< entry of the same bin, -1: none
    };
    int binOf(int point) const { return point / width_; }

    const Cell frame_;
    int width_, bins_;       //!< border points of a bin
    int64 reach_;            //!< the square of the distance, in doubled coordinates
    std::vector<int> heads_; //!< the last entry of each bin, -1: none
    std::vector<Entry> entries_;
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_END_INDEX_HPP
