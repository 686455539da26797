// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Candidates in OpenGL, from a table that stays there: what peaks.hpp finds on the host.

#ifndef OPENCV_LINESPACE_GL_MAXIMA_HPP
#define OPENCV_LINESPACE_GL_MAXIMA_HPP

#include "gl_device.hpp"
#include "peaks.hpp"

#include <functional>

namespace cv {
namespace linespace {

//! Keeps its buffers between calls.
class GlMaxima
{
public:
    GlMaxima() : room_(1 << 12) {}

    /** As Executor::findMaxima; finds them in the order (s, e).
    @param table a word for each chord.
    @param count queues what is done with the candidates, buffer and room, before they are read; once
    more, with true, as long as some of them have negative votes.
    @return false if the table, the maxima or what is required are too large for the device's blocks,
    of which the table and three others are used. */
    bool find(GlDevice& device, const EdgeMap& edges, const Plan& plan, const GlBuffer& table,
              const Wanted& wanted, int suppression, int radius,
              const std::function<void(const GlBuffer&, int, bool)>& count,
              std::vector<Candidate>& found);
    void release();

private:
    static std::vector<int> requirementOf(const Wanted& wanted);

    GlBuffer state_; //!< numbers, histogram and counts of maxima.glsl
    GlBuffer masks_; //!< which chords of a tile are maxima
    GlBuffer requirement_;
    GlBuffer maxima_;
    int room_; //!< for so many, where all are asked for
};

//! Options of a shader that reads a table of so many bytes at any place, before other blocks.
std::string windowOptions(const GlLimits& limits, size_t bytes);

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_GL_MAXIMA_HPP
