// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// glibc lets a program replace malloc for itself and its libraries, and so for the containers and
// the tables of the library and for cv::Mat.

#include "failing_allocation.hpp"

#include <atomic>
#include <cstddef>
#include <cstdlib>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define LINESPACE_TEST_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define LINESPACE_TEST_SANITIZED
#endif
#endif

#if defined(__GLIBC__) && !defined(LINESPACE_TEST_SANITIZED)
#define LINESPACE_TEST_REPLACES_MALLOC
#endif

namespace {

std::atomic<int> allocationsLeft(-1);
std::atomic<std::size_t> largest(0);

} // namespace

#ifdef LINESPACE_TEST_REPLACES_MALLOC
extern "C" {

void* __libc_malloc(std::size_t size);

__attribute__((visibility("default"))) void* malloc(std::size_t size)
{
    const std::size_t large = 512; // messages and small objects are not what is tested
    for (std::size_t before = largest.load();
         size > before && !largest.compare_exchange_weak(before, size);)
        ;
    const bool fails =
        size >= large && allocationsLeft.load() >= 0 && allocationsLeft.fetch_sub(1) == 0;
    return fails ? NULL : __libc_malloc(size);
}
}
#endif

namespace opencv_test {

bool canFailAllocations()
{
#ifdef LINESPACE_TEST_REPLACES_MALLOC
    return true;
#else
    return false;
#endif
}

void failAllocationAfter(int count)
{
    allocationsLeft = count;
}

size_t largestAllocation()
{
    return largest.exchange(0);
}

} // namespace opencv_test
