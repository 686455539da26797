// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "limits.hpp"

#include "common/stopwatch.hpp"
#include "instruction_set.hpp"

#include "opencv2/core.hpp"
#include "opencv2/core/utility.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

// Vectors of the compiler (GCC and Clang), of 16, 32 or 64 bytes, in a function for each instruction
// set of x86; elsewhere those of 16 bytes are what the baseline has.
#if defined(__x86_64__)
#define LINESPACE_FOR_SET(set) __attribute__((target(set)))
#endif
#define LINESPACE_INLINE inline __attribute__((always_inline))

namespace benchmark {

namespace {

template<int bytes>
struct Lanes
{
    typedef std::uint8_t Type __attribute__((vector_size(bytes), aligned(bytes), may_alias));
};

//! One pass over the arrays; `size` is a multiple of 512.
template<int bytes>
LINESPACE_INLINE void move(Motion motion, std::uint8_t* to, const std::uint8_t* a,
                           const std::uint8_t* b, std::size_t size)
{
    typedef typename Lanes<bytes>::Type Vector;
    const Vector *first = (const Vector*)a, *second = (const Vector*)b;
    Vector* result = (Vector*)to;
    const std::size_t count = size / bytes;
    if (motion == Motion::READ)
    {
        Vector sums[8] = {};
        for (std::size_t i = 0; i < count; i += 8)
            for (int j = 0; j < 8; ++j)
                sums[j] += first[i + j];
        for (int j = 1; j < 8; ++j)
            sums[0] += sums[j];
        result[0] = sums[0];
    }
    else if (motion == Motion::COPY)
        for (std::size_t i = 0; i < count; i += 8)
        {
            for (int j = 0; j < 8; ++j)
                result[i + j] = first[i + j];
            asm volatile("" ::: "memory"); // or the compiler calls memcpy, which bypasses caches
        }
    else
        for (std::size_t i = 0; i < count; i += 8)
            for (int j = 0; j < 8; ++j)
                result[i + j] = first[i + j] + second[i + j];
}

//! `rounds` times twelve adds in registers, six of which do not wait for each other.
template<int bytes>
LINESPACE_INLINE void add(std::int64_t rounds, std::uint8_t* to)
{
    typedef typename Lanes<bytes>::Type Vector;
    const std::uint8_t seed = *to;
    Vector a0 = Vector{} + seed, a1 = a0, a2 = a0, a3 = a0, a4 = a0, a5 = a0;
    Vector b0 = a0, b1 = a0, b2 = a0, b3 = a0, b4 = a0, b5 = a0;
    for (std::int64_t i = 0; i < rounds; ++i)
    {
        a0 += b0, a1 += b1, a2 += b2, a3 += b3, a4 += b4, a5 += b5;
        b0 += a1, b1 += a2, b2 += a3, b3 += a4, b4 += a5, b5 += a0;
    }
    *(Vector*)to = a0 + a1 + a2 + a3 + a4 + a5 + b0 + b1 + b2 + b3 + b4 + b5;
}

const int addsPerRound = 12;

struct Kernels
{
    void (*move)(Motion, std::uint8_t*, const std::uint8_t*, const std::uint8_t*, std::size_t);
    void (*add)(std::int64_t, std::uint8_t*);
    int bytes; //!< of a vector
};

void move16(Motion motion, std::uint8_t* to, const std::uint8_t* a, const std::uint8_t* b,
            std::size_t size)
{
    move<16>(motion, to, a, b, size);
}

void add16(std::int64_t rounds, std::uint8_t* to)
{
    add<16>(rounds, to);
}

#ifdef LINESPACE_FOR_SET
LINESPACE_FOR_SET("avx2")
void move32(Motion motion, std::uint8_t* to, const std::uint8_t* a, const std::uint8_t* b,
            std::size_t size)
{
    move<32>(motion, to, a, b, size);
}

LINESPACE_FOR_SET("avx2") void add32(std::int64_t rounds, std::uint8_t* to)
{
    add<32>(rounds, to);
}

LINESPACE_FOR_SET("avx512f,avx512bw,avx512vl")
void move64(Motion motion, std::uint8_t* to, const std::uint8_t* a, const std::uint8_t* b,
            std::size_t size)
{
    move<64>(motion, to, a, b, size);
}

LINESPACE_FOR_SET("avx512f,avx512bw,avx512vl") void add64(std::int64_t rounds, std::uint8_t* to)
{
    add<64>(rounds, to);
}
#endif

Kernels kernels()
{
#ifdef LINESPACE_FOR_SET
    const std::string set = instructionSet();
    if (set == "AVX512_SKX")
        return {move64, add64, 64};
    if (set == "AVX2")
        return {move32, add32, 32};
#endif
    return {move16, add16, 16};
}

//! Milliseconds that all threads take for their part of `work`, the shortest of several attempts.
double shortest(int threads, const std::function<void(int)>& work)
{
    cv::setNumThreads(threads);
    const int attempts = 5;
    double best = 1e300;
    for (int i = 0; i <= attempts; ++i) // the first one warms
        best = std::min(best, measure::millisecondsOf(
                                  [&]
                                  {
                                      cv::parallel_for_(
                                          cv::Range(0, threads),
                                          [&](const cv::Range& range)
                                          {
                                              for (int t = range.start; t < range.end; ++t)
                                                  work(t);
                                          },
                                          threads);
                                  }));
    return best;
}

//! How often something is to be repeated that took so long, to take as long as wanted.
std::int64_t repeats(double milliseconds, double wanted)
{
    return std::max<std::int64_t>(1, (std::int64_t)(wanted / std::max(milliseconds, 1e-6)));
}

} // namespace

double bytesPerSecond(Motion motion, std::size_t bytes, int threads, double milliseconds)
{
    const int arrays = motion == Motion::READ ? 1 : motion == Motion::COPY ? 2 : 3;
    const std::size_t size = std::max<std::size_t>(bytes / threads / arrays / 512 * 512, 512);
    // Each thread has its arrays; 64 bytes more are where a vector of sums is written.
    std::vector<cv::Mat1b> memory;
    for (int t = 0; t < threads; ++t)
        memory.push_back(cv::Mat1b(1, (int)(arrays * size + 128), (uchar)1));
    const Kernels kernel = kernels();
    std::int64_t passes = 1;
    const auto work = [&](int t)
    {
        std::uint8_t* const start = cv::alignPtr(memory[t].data, 64);
        for (std::int64_t i = 0; i < passes; ++i)
            kernel.move(motion, start + (arrays - 1) * size + (arrays == 1 ? size : 0), start,
                        start + (arrays == 3 ? size : 0), size);
    };
    // Enough passes that starting threads does not matter.
    while (true)
    {
        const double time = shortest(threads, work);
        if (time >= milliseconds)
            return (double)arrays * (double)size * threads * (double)passes / (time / 1000);
        passes = std::max(passes + 1, (std::int64_t)(1.2 * (double)passes * milliseconds /
                                                     std::max(time, milliseconds / 100)));
    }
}

double addsPerSecond(int threads, double milliseconds)
{
    const Kernels kernel = kernels();
    std::int64_t rounds = 1 << 16;
    const auto work = [&](int)
    {
        alignas(64) std::uint8_t lanes[64] = {1};
        kernel.add(rounds, lanes);
        volatile std::uint8_t kept = lanes[0];
        (void)kept;
    };
    rounds *= repeats(shortest(threads, work), milliseconds);
    const double time = shortest(threads, work);
    return (double)addsPerRound * kernel.bytes * threads * (double)rounds / (time / 1000);
}

} // namespace benchmark
