// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// What reads single edge pixels on an OpenCL device, after the votes: candidates that climb to
// maxima of the exact votes, what ascent.hpp does on the host, and the pixels as bits, for the
// refinement there. Only for files that are compiled with HAVE_OPENCL.

#ifndef OPENCV_LINESPACE_OCL_ASCENT_HPP
#define OPENCV_LINESPACE_OCL_ASCENT_HPP

#include "edge_bits.hpp"
#include "ocl_launch.hpp"

namespace cv {
namespace linespace {

//! Keeps its buffers between calls.
class DeviceAscent
{
public:
    DeviceAscent() : isWeighted_(false), isPacked_(false) {}

    //! What it is asked for from now on is of these pixels.
    void reset(const DevicePixels& pixels, bool isWeighted, const Cell& frame);

    /** Gives candidates their exact votes.
    @param radius of the neighbourhoods in which they first climb to maxima of these, up to
    MAX_ASCENT_RADIUS, several maybe to the same; 0: they stay where they are.
    @param candidates as ocl_maxima writes them.
    @param room how many there may be. */
    void count(int radius, const UMat& candidates, int room);

    bool hasPixels() const { return !pixels_.image.empty(); }
    const DevicePixels& pixels() const { return pixels_; }

    //! Reads the pixels, of a map that is not oriented.
    void readBits(EdgeBits& bits);

private:
    String bitOptions() const;
    void pack();

    DevicePixels pixels_;
    bool isWeighted_;
    Cell frame_;
    bool isPacked_;
    UMat bits_;                     //!< EdgeBits, for each bin
    UMat wanted_, counted_, votes_; //!< of squares of chords
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_OCL_ASCENT_HPP
