// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Rows and columns of bytes exchanged in vectors.

#ifndef OPENCV_LINESPACE_TRANSPOSITION_HPP
#define OPENCV_LINESPACE_TRANSPOSITION_HPP

#include "vectors.hpp"

#if LINESPACE_SIMD128

namespace cv {
namespace linespace {

/** A matrix of 16 rows and Columns (8 or 16) columns, row after row, becomes its columns, one after
the other. Zipping the matrix's halves moves the highest bit of a byte's place to its lowest; four
times, and the bits of the row are below those of the column. */
template<int Columns>
inline void transposeBytes(v_uint8x16 (&matrix)[Columns])
{
    v_uint8x16 zipped[Columns];
    for (int round = 0; round < 2; ++round)
    {
        for (int i = 0; i < Columns / 2; ++i)
            v_zip(matrix[i], matrix[i + Columns / 2], zipped[2 * i], zipped[2 * i + 1]);
        for (int i = 0; i < Columns / 2; ++i)
            v_zip(zipped[i], zipped[i + Columns / 2], matrix[2 * i], matrix[2 * i + 1]);
    }
}

} // namespace linespace
} // namespace cv

#endif

#endif // OPENCV_LINESPACE_TRANSPOSITION_HPP
