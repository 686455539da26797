// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// OpenCV before 4.11 has operators on vectors, but not all of the functions v_add, v_and and so on:
// this header defines the missing ones by the operators. Where OpenCV has a function, which is no
// template or one for fewer types, the compiler prefers it to these.

#ifndef OPENCV_LINESPACE_VECTOR_FUNCTIONS_HPP
#define OPENCV_LINESPACE_VECTOR_FUNCTIONS_HPP

#include <opencv2/core/hal/intrin.hpp>

namespace cv {
namespace linespace {

// For the types that have the operator.
#define LINESPACE_VECTOR_FUNCTION(function, op)                                                    \
    template<class Vector>                                                                         \
    inline auto function(const Vector& a, const Vector& b)->decltype(a op b)                       \
    {                                                                                              \
        return a op b;                                                                             \
    }

LINESPACE_VECTOR_FUNCTION(v_add, +)
LINESPACE_VECTOR_FUNCTION(v_sub, -)
LINESPACE_VECTOR_FUNCTION(v_mul, *)
LINESPACE_VECTOR_FUNCTION(v_div, /)
LINESPACE_VECTOR_FUNCTION(v_and, &)
LINESPACE_VECTOR_FUNCTION(v_or, |)
LINESPACE_VECTOR_FUNCTION(v_xor, ^)
LINESPACE_VECTOR_FUNCTION(v_eq, ==)
LINESPACE_VECTOR_FUNCTION(v_ne, !=)
LINESPACE_VECTOR_FUNCTION(v_gt, >)
LINESPACE_VECTOR_FUNCTION(v_le, <=)

#undef LINESPACE_VECTOR_FUNCTION

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_VECTOR_FUNCTIONS_HPP
