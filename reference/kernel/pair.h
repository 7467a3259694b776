// Two doubles in one vector register, which every x86-64 and aarch64 processor has, and vectors of three of them. A
// formula computed for two things at once takes half the instructions; each number is rounded as it is by itself.
#pragma once

#include <bit>
#include <cstdint>

#include "reference/kernel/ray.h"

namespace reference::kernel {

using Pair [[gnu::vector_size(16)]] = double;
using PairBits [[gnu::vector_size(16)]] = std::uint64_t;

KERNEL_INLINE Pair swapped(Pair pair) {
    return Pair{pair[1], pair[0]};
}
KERNEL_INLINE Pair absolute(Pair pair) {
    constexpr PairBits all_but_sign{~(std::uint64_t{1} << 63U), ~(std::uint64_t{1} << 63U)};
    return std::bit_cast<Pair>(std::bit_cast<PairBits>(pair) & all_but_sign);
}
/// The sign bit of the second number, twice.
KERNEL_INLINE PairBits sign_of_second(Pair pair) {
    constexpr PairBits sign{std::uint64_t{1} << 63U, std::uint64_t{1} << 63U};
    return std::bit_cast<PairBits>(Pair{pair[1], pair[1]}) & sign;
}
/// Both numbers negated if that sign is set.
KERNEL_INLINE Pair turned(Pair pair, PairBits sign) {
    return std::bit_cast<Pair>(std::bit_cast<PairBits>(pair) ^ sign);
}

/// The lesser of each two numbers. Unlike std::min of doubles it never becomes a branch.
KERNEL_INLINE Pair lesser(Pair p, Pair q) {
    return p < q ? p : q;
}

/// Two vectors.
struct PairVec3 {
    Pair x;
    Pair y;
    Pair z;

    PairVec3() = default;
    template <class T>
    KERNEL_INLINE PairVec3(const Vec3<T>& p, const Vec3<T>& q)
        : x{static_cast<double>(p.x), static_cast<double>(q.x)},
          y{static_cast<double>(p.y), static_cast<double>(q.y)},
          z{static_cast<double>(p.z), static_cast<double>(q.z)} {}

    KERNEL_INLINE friend PairVec3 operator-(const PairVec3& p, const PairVec3& q) {
        PairVec3 difference;
        difference.x = p.x - q.x;
        difference.y = p.y - q.y;
        difference.z = p.z - q.z;
        return difference;
    }
    KERNEL_INLINE friend PairVec3 cross(const PairVec3& p, const PairVec3& q) {
        PairVec3 product;
        product.x = p.y * q.z - p.z * q.y;
        product.y = p.z * q.x - p.x * q.z;
        product.z = p.x * q.y - p.y * q.x;
        return product;
    }
    KERNEL_INLINE friend Pair dot(const PairVec3& p, const PairVec3& q) { return p.x * q.x + p.y * q.y + p.z * q.z; }
    KERNEL_INLINE friend PairVec3 swapped(const PairVec3& p) {
        PairVec3 result;
        result.x = swapped(p.x);
        result.y = swapped(p.y);
        result.z = swapped(p.z);
        return result;
    }
    /// |x| + |y| + |z|.
    KERNEL_INLINE friend Pair norm(const PairVec3& p) { return absolute(p.x) + absolute(p.y) + absolute(p.z); }
};

}  // namespace reference::kernel
