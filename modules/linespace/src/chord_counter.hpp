// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Exact votes of single chords, fast: the same numbers as chordVotes (stages.hpp).

#ifndef OPENCV_LINESPACE_CHORD_COUNTER_HPP
#define OPENCV_LINESPACE_CHORD_COUNTER_HPP

#include "stages.hpp"

namespace cv {
namespace linespace {

/** Counts chords of a frame on a copy of an edge map, of which pixels can be taken out. Chords are
walked in fixed point, along rows of the map or of its transpose, so that neighbouring pixels share
cache lines at any slope. */
class ChordCounter
{
public:
    ChordCounter(const EdgeMap& edges, const Cell& frame);

    //! Votes of a chord of the frame; may be called from several threads at once.
    int votes(Chord chord) const;

    //! Takes out an edge pixel.
    void remove(Point pixel);
    //! Without what was taken out.
    const EdgeMap& edges() const { return edges_; }

private:
    EdgeMap edges_; // its own copy
    Cell frame_;
    Mat votesTransposed_, directionsTransposed_;
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_CHORD_COUNTER_HPP
