// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Functions of OpenCV's vectors from its operators, for versions before 4.11: of these, only ARM's
// from 4.9 on has all functions with its vectors, and no operators. Where a function is in the
// namespace of OpenCV's vectors, the compiler prefers it to these, as it is no template or one for
// fewer types.

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
LINESPACE_VECTOR_FUNCTION(v_xor, ^)
LINESPACE_VECTOR_FUNCTION(v_eq, ==)
LINESPACE_VECTOR_FUNCTION(v_ne, !=)
LINESPACE_VECTOR_FUNCTION(v_gt, >)
LINESPACE_VECTOR_FUNCTION(v_le, <=)

#undef LINESPACE_VECTOR_FUNCTION

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_VECTOR_FUNCTIONS_HPP
