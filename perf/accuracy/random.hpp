// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Random numbers that are the same on every platform: the standard fixes std::mt19937_64 to the bit
// but leaves its distributions open, so that the conversions are here.

#ifndef LINESPACE_ACCURACY_RANDOM_HPP
#define LINESPACE_ACCURACY_RANDOM_HPP

#include <cmath>
#include <cstdint>
#include <random>

namespace scenes {

class Random
{
public:
    //! Sequences of different seeds, and of different streams of one seed, are independent.
    explicit Random(std::uint64_t seed, std::uint64_t stream = 0)
        : engine(mixed(mixed(seed) + stream))
    {
    }

    //! In [0, 1), 53 bits.
    double uniform() { return (double)(engine() >> 11) * (1.0 / 9007199254740992.0); }
    //! In [low, high).
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    //! In 0 .. count - 1; count is far below 2^53, so that the bias does not matter.
    int below(int count) { return (int)(uniform() * count); }
    int sign() { return (engine() >> 63) ? 1 : -1; }

    //! Mean 0, deviation 1 (Box and Muller); two numbers of the engine each.
    double normal()
    {
        const double radius = std::sqrt(-2 * std::log(1 - uniform()));
        return radius * std::cos(6.283185307179586 * uniform());
    }

private:
    //! The finaliser of SplitMix64: neighbouring seeds give unrelated states.
    static std::uint64_t mixed(std::uint64_t value)
    {
        value += 0x9e3779b97f4a7c15u;
        value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9u;
        value = (value ^ (value >> 27)) * 0x94d049bb133111ebu;
        return value ^ (value >> 31);
    }

    std::mt19937_64 engine;
};

} // namespace scenes

#endif // LINESPACE_ACCURACY_RANDOM_HPP
