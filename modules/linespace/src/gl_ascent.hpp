// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// What reads single edge pixels in OpenGL, after the votes: candidates that climb to maxima of the
// exact votes, what ascent.hpp does on the host, and the pixels as bits, for the refinement there.

#ifndef OPENCV_LINESPACE_GL_ASCENT_HPP
#define OPENCV_LINESPACE_GL_ASCENT_HPP

#include "edge_bits.hpp"
#include "gl_pixels.hpp"

namespace cv {
namespace linespace {

//! Keeps its buffers between calls.
class GlAscent
{
public:
    GlAscent() : isWeighted_(false), isPacked_(false) {}

    //! What it is asked for from now on is of these pixels.
    void reset(const GlPixels& pixels, bool isWeighted);

    //! Queues what readBits() reads, if it has not been yet.
    void pack(GlDevice& device);

    /** Gives candidates their exact votes.
    @param radius of the neighbourhoods in which they first climb to maxima of these, up to
    MAX_ASCENT_RADIUS, several maybe to the same; 0: they stay where they are.
    @param candidates as GlMaxima writes them.
    @param room how many there may be.
    @param goesOn whether it was called for them before, and some have negative votes: these climb for
    more steps than a call takes.
    @return false if the exact votes of the frame, or a list of chords, are more than the device's
    blocks hold. */
    bool count(GlDevice& device, int radius, const GlBuffer& candidates, int room, bool goesOn);

    //! Reads the pixels, whatever their weights.
    void readBits(GlDevice& device, EdgeBits& bits);

    void release();

private:
    GlPixels pixels_;
    bool isWeighted_, isPacked_;
    GlBuffer bits_;                   //!< EdgeBits
    GlBuffer marks_, listed_, votes_; //!< of chords by their squares
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_GL_ASCENT_HPP
