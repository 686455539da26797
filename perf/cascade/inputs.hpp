// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The edge maps of the study with their gradients: photographs and synthetic scenes.

#ifndef LINESPACE_CASCADE_INPUTS_HPP
#define LINESPACE_CASCADE_INPUTS_HPP

#include <string>
#include <vector>

#include "opencv2/core.hpp"

namespace cascade {

//! An image that is not read before it is needed.
struct Source
{
    std::string group; //!< "samples", "chessboard", "sudoku", "york" or "synthetic"
    std::string name;
    std::string path; //!< of the photograph; empty for a scene
    int scene = -1;   //!< number of the synthetic scene
};

struct Input
{
    Source source;
    cv::Mat1b edges;
    cv::Mat1s dx, dy; //!< Sobel gradients of the image the edges are of

    int threshold; //!< votes that a line must exceed: a tenth of the image's shorter side
};

/** Photographs among OpenCV's sample images, and, if a folder of evaluation images is given, those
of its sub-folders chessboard, sudoku and york. Throws support::MissingImage if one is missing. */
std::vector<Source> photographs(const std::string& samples, const std::string& evaluation);

/** Synthetic scenes of step edges and of bars, 1 to 16 lines, without and with noise, clutter (up to
5 % of the pixels) and gaps; of several sizes, odd ones among them. */
std::vector<Source> syntheticScenes(int count);

/** Reads or draws the image and finds its edges: Canny 50/150, for scenes, whose contrast is lower,
40/80.
@param longest an image with a longer side (pixels) is reduced to it; the exact method is O(n^3). */
Input readInput(const Source& source, int longest);

//! The same as a square of `side` pixels: a photograph is scaled, a scene drawn at that size.
Input readSquare(const Source& source, int side);

} // namespace cascade

#endif // LINESPACE_CASCADE_INPUTS_HPP
