// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// METHOD_STRIPS on the host (doc/algorithm.md, section 3b): from an edge map to chords of the image
// with exact votes.

#ifndef OPENCV_LINESPACE_STRIP_CANDIDATES_HPP
#define OPENCV_LINESPACE_STRIP_CANDIDATES_HPP

#include "../line_geometry.hpp"
#include "../requirement.hpp"
#include "../stage_times.hpp"
#include "strip_search.hpp"

namespace cv {
namespace linespace {

//! This describes the chords that are asked for.
struct StripWanted
{
    const Requirement& requirement; //!< that they meet
    const AngleInterval& angles;    //!< that their lines are in
    size_t lines;                   //!< so many that are no duplicates, 0: all
    double distance;                //!< pixels, between both ends of duplicates
};

//! Finds the candidates of METHOD_STRIPS; keeps its memory from call to call.
class StripCandidates
{
public:
    /** @param isReference by plain loops, with the same result.
    @param planes of the map, whose frame is the image.
    @return maxima of the exact votes in their ring neighbourhood (Climber), in the total order. */
    std::vector<Candidate> find(const EdgePlanes& planes, const Plan& plan,
                                const StripWanted& wanted, bool isReference, StageTimes& times);
    void clear();
    //! Bytes that find() allocates for an image, but for lists.
    static double memory(Size image, bool isWeighted)
    {
        return isWeighted ? StripSearch<ushort>::memory(image) : StripSearch<uchar>::memory(image);
    }

private:
    StripSearch<uchar> plain_;
    StripSearch<ushort> weighted_;
    std::vector<StripChord> chords_;
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_STRIP_CANDIDATES_HPP
