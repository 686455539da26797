// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "gl_pixels.hpp"

#ifdef LINESPACE_OPENGL

#include "edge_bits.hpp"
#include "orientation.hpp"

namespace cv {
namespace linespace {

std::string GlPixels::options(int block) const
{
    return define("MAP_BLOCK", block) + define("DIRECTIONS_BLOCK", block + 1) +
           (directions ? orientedOptions() : std::string());
}

void GlPixels::giveTo(GlLaunch& launch, int block) const
{
    launch.blockAt(block, *image);
    if (directions)
        launch.blockAt(block + 1, *directions);
}

std::vector<int> GlPixels::numbers(const std::vector<int>& own) const
{
    std::vector<int> all = {frame.width,
                            frame.height,
                            size.width,
                            size.height,
                            EdgeBits::wordsOf(frame.height),
                            EdgeBits::wordsOf(frame.width)};
    all.insert(all.end(), own.begin(), own.end());
    return all;
}

std::string orientedOptions()
{
    std::string cosines;
    for (int bin = 0; bin < DIRECTION_BINS; ++bin)
        cosines += format(bin > 0 ? ", %d" : "%d", endCosine(bin));
    static_assert(DIRECTION_BINS == 16, "as in chords.glsl");
    return define("ORIENTED") + "#define END_COSINES " + cosines + "\n";
}

} // namespace linespace
} // namespace cv

#endif // LINESPACE_OPENGL
