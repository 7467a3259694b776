// Whether this program's arithmetic is what the kernel's and the key's proofs count on.
#pragma once

#include <cstdint>
#include <string>

#include "reference/kernel/ray.h"
#include "reference/stages/scene.h"

namespace reference::kernel {

/// What is wrong with the arithmetic of this program on this machine, as a sentence, with the way out; empty if
/// nothing is. Takes about a millisecond.
std::string arithmetic_trouble();

/// A ray that decides narrowly about a sphere, a triangle and a cylinder. In whole numbers times 2^-k, so that every
/// compiler makes the same of it.
struct NarrowCase {
    Ray<double> ray;
    Sphere<double> sphere;
    Triangle<double> triangle;
    Cylinder<double> cylinder;
};
NarrowCase narrow_case(std::uint64_t seed);

/// The decisions on the narrow cases from 0 on, as one number.
std::uint64_t hash_of_decisions(std::uint64_t cases);

/// FNV-1a (Fowler, Noll and Vo) of what was hashed before and of one decision more.
constexpr std::uint64_t hashed(std::uint64_t before, int decision) {
    return (before ^ static_cast<std::uint64_t>(decision)) * 0x100000001b3U;
}
inline constexpr std::uint64_t no_decision = 0xcbf29ce484222325U;

inline constexpr std::uint64_t self_test_cases = 200;
/// Their hash; a test finds it in rationals.
inline constexpr std::uint64_t self_test_hash = 0x67a3c4b7b40b4c9fU;

}  // namespace reference::kernel
