// Numbers, points and near misses from one seed.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "reference/vector.h"

namespace distributions {

using P = reference::Vec3<double>;

/// splitmix64 (Steele, Lea and Flood, 2014): any seed is a good one.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t bits() {
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
        return z ^ (z >> 31U);
    }
    /// From lo to hi, both included.
    int whole(int lo, int hi) { return lo + static_cast<int>(bits() % static_cast<std::uint64_t>(hi - lo + 1)); }
    /// In [-1, 1).
    double number() { return static_cast<double>(static_cast<std::int64_t>(bits()) >> 10) * 0x1p-53; }
    double between(double lo, double hi) { return lo + (hi - lo) * (number() + 1) / 2; }
    P point(double size) { return {size * number(), size * number(), size * number()}; }
    P whole_point(int size) { return {whole(-size, size), whole(-size, size), whole(-size, size)}; }
    P direction() {
        for (;;) {
            const P p = point(1);
            const double square = dot(p, p);
            if (square > 0.01 && square <= 1) return reference::scaled(p, 1 / std::sqrt(square));
        }
    }
    /// x, or a double a few steps away from it.
    double nudged(double x, int steps = 2) {
        const int n = whole(-steps, steps);
        for (int i = 0; i < std::abs(n); ++i) x = std::nextafter(x, n < 0 ? -HUGE_VAL : HUGE_VAL);
        return x;
    }
    P nudged(const P& p) { return {nudged(p.x), nudged(p.y), nudged(p.z)}; }

  private:
    std::uint64_t state_;
};

inline double as_float(double x) {
    return static_cast<double>(static_cast<float>(x));
}
inline P as_float(const P& p) {
    return {as_float(p.x), as_float(p.y), as_float(p.z)};
}

/// Where squares, cubes or fourth powers of the lengths leave the range of doubles, wholly or in part.
inline double to_the_ends(std::uint64_t seed) {
    static constexpr std::array<int, 8> exponents{-1000, -537, -530, -360, -268, 255, 340, 500};
    return std::exp2(exponents[static_cast<std::size_t>(Random(seed).whole(0, 7))]);
}

}  // namespace distributions
