// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// What this machine can do at most, measured: bytes moved from and to each cache and memory, and
// votes added in registers, with the instruction set that the library uses.

#ifndef LINESPACE_BENCHMARK_LIMITS_HPP
#define LINESPACE_BENCHMARK_LIMITS_HPP

#include <cstddef>

namespace benchmark {

enum class Motion
{
    READ, //!< one load
    COPY, //!< one load, one store
    ADD   //!< two loads, an add, one store: what a merge does
};

/** The highest rate of several attempts in bytes loaded and stored by the program per second (what
a cache line costs that must be fetched before it is written is not counted, neither here nor in the
work of the stages).
@param bytes that all arrays of all threads take together.
@param milliseconds that an attempt takes at least. */
double bytesPerSecond(Motion motion, std::size_t bytes, int threads, double milliseconds);

//! Votes of one byte added per second in registers; those of b bytes are 1/b of it.
double addsPerSecond(int threads, double milliseconds);

} // namespace benchmark

#endif // LINESPACE_BENCHMARK_LIMITS_HPP
