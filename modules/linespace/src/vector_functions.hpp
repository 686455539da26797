// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Operators of OpenCV's vectors where a version has functions in their place: 4.9 and 4.10 on ARM.
// Where OpenCV has the operator, which is no template, the compiler prefers it to these.

#ifndef OPENCV_LINESPACE_VECTOR_OPERATORS_HPP
#define OPENCV_LINESPACE_VECTOR_OPERATORS_HPP

#include <opencv2/core/hal/intrin.hpp>

namespace cv {
namespace linespace {

// For the types that have the function.
#define LINESPACE_VECTOR_OPERATOR(op, function)                                                    \
    template<class Vector>                                                                         \
    inline auto operator op(const Vector& a, const Vector& b)->decltype(function(a, b))            \
    {                                                                                              \
        return function(a, b);                                                                     \
    }

#define LINESPACE_VECTOR_ASSIGNMENT(op, function)                                                  \
    template<class Vector>                                                                         \
    inline auto operator op(Vector& a, const Vector& b)->decltype(a = function(a, b))              \
    {                                                                                              \
        return a = function(a, b);                                                                 \
    }

LINESPACE_VECTOR_OPERATOR(+, v_add)
LINESPACE_VECTOR_OPERATOR(-, v_sub)
LINESPACE_VECTOR_OPERATOR(*, v_mul)
LINESPACE_VECTOR_OPERATOR(/, v_div)
LINESPACE_VECTOR_OPERATOR(&, v_and)
LINESPACE_VECTOR_OPERATOR(|, v_or)
LINESPACE_VECTOR_OPERATOR(^, v_xor)
LINESPACE_VECTOR_OPERATOR(==, v_eq)
LINESPACE_VECTOR_OPERATOR(!=, v_ne)
LINESPACE_VECTOR_OPERATOR(<, v_lt)
LINESPACE_VECTOR_OPERATOR(>, v_gt)
LINESPACE_VECTOR_OPERATOR(<=, v_le)
LINESPACE_VECTOR_OPERATOR(>=, v_ge)
LINESPACE_VECTOR_ASSIGNMENT(+=, v_add)
LINESPACE_VECTOR_ASSIGNMENT(-=, v_sub)
LINESPACE_VECTOR_ASSIGNMENT(*=, v_mul)
LINESPACE_VECTOR_ASSIGNMENT(&=, v_and)
LINESPACE_VECTOR_ASSIGNMENT(|=, v_or)

#undef LINESPACE_VECTOR_OPERATOR
#undef LINESPACE_VECTOR_ASSIGNMENT

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_VECTOR_OPERATORS_HPP
