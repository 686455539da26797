// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// cv::HoughLines of the installed OpenCV: what the drop-in is held against.

#ifndef LINESPACE_CONFORMANCE_OPENCV_LINES_HPP
#define LINESPACE_CONFORMANCE_OPENCV_LINES_HPP

#include "lines.hpp"

namespace conformance {

//! Whether the installed version has use_edgeval (since 4.11).
bool opencvHasEdgeValues();

//! The lines with more votes than the threshold, strongest first, freed of the version's bias of
//! rho.
Lines opencvLines(const cv::Mat1b& edges, const Arguments& arguments, int threshold);

/** The same lines with the votes that they really have, where those are fewer. cv::HoughLines adds
up its angles in float, and so counts at an angle that differs from the one it reports by up to 1e-4
rad: a pixel here and there that is not within rho / 2 of the reported line. */
Lines withRealVotes(const Lines& lines, const cv::Mat1b& edges, const Arguments& arguments);

} // namespace conformance

#endif // LINESPACE_CONFORMANCE_OPENCV_LINES_HPP
