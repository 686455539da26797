// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#ifndef OPENCV_LINESPACE_PRECOMP_HPP
#define OPENCV_LINESPACE_PRECOMP_HPP

#include "opencv2/linespace.hpp"

#include <opencv2/core/utility.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#endif // OPENCV_LINESPACE_PRECOMP_HPP
