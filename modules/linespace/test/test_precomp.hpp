// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Included first by every accuracy test.

#ifndef OPENCV_LINESPACE_TEST_PRECOMP_HPP
#define OPENCV_LINESPACE_TEST_PRECOMP_HPP

#include "opencv2/ts.hpp"
#include "opencv2/imgcodecs.hpp"
#include "opencv2/imgproc.hpp"
#include "opencv2/linespace.hpp"

#endif // OPENCV_LINESPACE_TEST_PRECOMP_HPP
