// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Prints what OpenCV's universal intrinsics are in this build, outside of dispatched code, and fails
// if the library would use plain loops in their place. Compiled with the library's definitions.

#include "vectors.hpp"

#include <cstdio>

#ifndef CV_NEON
#define CV_NEON 0
#endif
#ifndef CV_SSE2
#define CV_SSE2 0
#endif

int main()
{
    std::printf("vectors of %d bits, CV_SIMD %d, CV_SIMD128 %d, CV_NEON %d, CV_SSE2 %d; "
                "LINESPACE_SIMD128 %d, LINESPACE_SIMD128_64F %d\n",
#if CV_SIMD
                CV_SIMD_WIDTH * 8,
#else
                0,
#endif
                CV_SIMD, CV_SIMD128, CV_NEON, CV_SSE2, LINESPACE_SIMD128, LINESPACE_SIMD128_64F);
    return LINESPACE_SIMD128 ? 0 : 1;
}
