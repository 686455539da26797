// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#ifndef OPENCV_LINESPACE_PIXEL_BITS_HPP
#define OPENCV_LINESPACE_PIXEL_BITS_HPP

#include "../precomp.hpp"
#include "../vectors.hpp"

namespace cv {
namespace linespace {

//! 16 pixels as bits: set where a pixel has one of `bits`.
inline int readPixelBits(const uchar* pixels, uchar bits)
{
#if LINESPACE_SIMD128
    return v_signmask(v_ne(v_and(v_load(pixels), v_setall_u8(bits)), v_setzero_u8()));
#else
    int mask = 0;
    for (int b = 0; b < 16; ++b)
        mask |= ((pixels[b] & bits) != 0) << b;
    return mask;
#endif
}

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_PIXEL_BITS_HPP
