// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "caches.hpp"

#include <fstream>

namespace benchmark {

namespace {

std::string firstWord(const std::string& path)
{
    std::string word;
    std::ifstream(path) >> word;
    return word;
}

//! "512K" or "32M" as bytes; 0 for anything else.
std::size_t bytesOf(const std::string& size)
{
    if (size.empty() || size.find_first_not_of("0123456789") + 1 != size.size())
        return 0;
    const std::size_t number = std::stoul(size);
    return size.back() == 'K' ? number << 10 : size.back() == 'M' ? number << 20 : 0;
}

bool isOneCore(const std::string& list)
{
    return list.find_first_of(",-") == std::string::npos;
}

} // namespace

std::vector<Cache> caches()
{
    std::vector<Cache> result;
    for (int index = 0; index < 8; ++index)
    {
        const std::string folder =
            "/sys/devices/system/cpu/cpu0/cache/index" + std::to_string(index) + "/";
        const std::size_t bytes = bytesOf(firstWord(folder + "size"));
        if (bytes > 0 && firstWord(folder + "type") != "Instruction")
            result.push_back({"L" + firstWord(folder + "level"), bytes,
                              !isOneCore(firstWord(folder + "shared_cpu_list"))});
    }
    if (result.empty())
        result = {{"L1", 32 << 10, false}, {"L2", 512 << 10, false}, {"L3", 32 << 20, true}};
    return result;
}

} // namespace benchmark
