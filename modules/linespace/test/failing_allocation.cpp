// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The global operator new is replaced for the whole test program, and with it for the library's
// containers. Alone in its file: a compiler that sees both ends takes malloc and delete for a
// mismatch.

#include "failing_allocation.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define LINESPACE_TEST_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define LINESPACE_TEST_SANITIZED
#endif
#endif

namespace {

std::atomic<int> allocationsLeft(-1);

} // namespace

#ifndef LINESPACE_TEST_SANITIZED
void* operator new(std::size_t size)
{
    const std::size_t large = 512; // messages and small objects are not what is tested
    const bool fails =
        size >= large && allocationsLeft.load() >= 0 && allocationsLeft.fetch_sub(1) == 0;
    void* const memory = fails ? NULL : std::malloc(size ? size : 1);
    if (!memory)
        throw std::bad_alloc();
    return memory;
}

void operator delete(void* memory) noexcept
{
    std::free(memory);
}
#endif

namespace opencv_test {

bool canFailAllocations()
{
#ifdef LINESPACE_TEST_SANITIZED
    return false;
#else
    return true;
#endif
}

void failAllocationAfter(int count)
{
    allocationsLeft = count;
}

} // namespace opencv_test
