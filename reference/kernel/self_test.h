// Checks that this program's arithmetic is what the kernel's and the key's proofs assume.
#pragma once

#include <cstdint>
#include <string>

#include "reference/kernel/ray.h"
#include "reference/stages/scene.h"

namespace reference::kernel {

/// The error in this program's arithmetic on this machine, as a sentence with how to fix it; empty if there is none.
/// Takes about a millisecond.
std::string arithmetic_trouble();

/// A ray with narrow decisions about a sphere, a triangle and a cylinder. In whole numbers times 2^-k, so that every
/// compiler reads the same values.
struct NarrowCase {
    Ray<double> ray;
    Sphere<double> sphere;
    Triangle<double> triangle;
    Cylinder<double> cylinder;
};
NarrowCase narrow_case(std::uint64_t seed);

/// The decisions on the narrow cases from number 0 on, as one number.
std::uint64_t hash_of_decisions(std::uint64_t cases);

/// FNV-1a (Fowler, Noll and Vo) of the earlier hash and one more decision.
constexpr std::uint64_t hashed(std::uint64_t before, int decision) {
    return (before ^ static_cast<std::uint64_t>(decision)) * 0x100000001b3U;
}
inline constexpr std::uint64_t no_decision = 0xcbf29ce484222325U;

inline constexpr std::uint64_t self_test_cases = 200;
/// Their hash; a test computes it in rationals.
inline constexpr std::uint64_t self_test_hash = 0x67a3c4b7b40b4c9fU;

}  // namespace reference::kernel
