// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The data caches of this machine.

#ifndef LINESPACE_BENCHMARK_CACHES_HPP
#define LINESPACE_BENCHMARK_CACHES_HPP

#include <cstddef>
#include <string>
#include <vector>

namespace benchmark {

struct Cache
{
    std::string name; //!< "L1", "L2", "L3"
    std::size_t bytes;
    bool isShared; //!< by the cores, not one for each
};

//! As the system tells, smallest first; the usual sizes where it does not.
std::vector<Cache> caches();

} // namespace benchmark

#endif // LINESPACE_BENCHMARK_CACHES_HPP
