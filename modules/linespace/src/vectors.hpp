// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// This header includes OpenCV's vectors, of 128 bits or of the instruction set's width, and says
// whether they are used. Sources call functions (v_add) in place of operators, which OpenCV forbids
// in its own modules from 4.11 on.

#ifndef OPENCV_LINESPACE_VECTORS_HPP
#define OPENCV_LINESPACE_VECTORS_HPP

#include <opencv2/core/hal/intrin.hpp>
#include <opencv2/core/version.hpp>
#if CV_VERSION_MAJOR < 4 || (CV_VERSION_MAJOR == 4 && CV_VERSION_MINOR < 11)
#include "vector_functions.hpp"
#endif

// Where vectors have no fixed size (RISC-V), or to test what runs there, plain loops.
#if defined LINESPACE_PLAIN_LOOPS || !CV_SIMD128
#define LINESPACE_SIMD 0
#define LINESPACE_SIMD128 0
#define LINESPACE_SIMD128_64F 0
#else
#define LINESPACE_SIMD CV_SIMD
#define LINESPACE_SIMD128 1
#define LINESPACE_SIMD128_64F CV_SIMD128_64F
#endif

#endif // OPENCV_LINESPACE_VECTORS_HPP
