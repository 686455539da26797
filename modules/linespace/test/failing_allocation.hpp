// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Makes a memory allocation of the library fail on purpose, and tells how large they are.

#ifndef OPENCV_LINESPACE_TEST_FAILING_ALLOCATION_HPP
#define OPENCV_LINESPACE_TEST_FAILING_ALLOCATION_HPP

#include <cstddef>

namespace opencv_test {

//! False with another C library than glibc, and with a sanitizer, which must keep its allocator.
bool canFailAllocations();
//! After so many more successful ones of 512 bytes or more, one allocation fails; negative: none.
void failAllocationAfter(int count);

//! Bytes of the largest allocation since the last call of this function.
size_t largestAllocation();

} // namespace opencv_test

#endif // OPENCV_LINESPACE_TEST_FAILING_ALLOCATION_HPP
