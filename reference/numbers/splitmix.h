// splitmix64 (Steele, Lea and Flood, "Fast Splittable Pseudorandom Number Generators", 2014): every seed is good, and
// the numbers are the same on every machine, unlike those of the standard library's distributions.
#pragma once

#include <cstdint>

namespace reference {

/// The next 64 random bits after `state`, which moves on.
inline std::uint64_t next_random_bits(std::uint64_t& state) {
    state += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
}

}  // namespace reference
