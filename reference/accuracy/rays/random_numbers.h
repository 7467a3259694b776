// Numbers, points and near misses from one seed.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include "reference/numbers/splitmix.h"
#include "reference/numbers/vector.h"

namespace reference::accuracy {

using P = reference::Vec3<double>;

/// The kind of numbers in a case.
enum class Inputs {
    mixed,   ///< floats or all of a double's bits, as drawn
    floats,  ///< floats only, so that methods in float and in double get exactly the same problem
};

class Random {
  public:
    explicit Random(std::uint64_t seed, Inputs inputs = Inputs::mixed) : state_(seed), inputs_(inputs) {}

    Inputs inputs() const { return inputs_; }

    std::uint64_t bits() { return next_random_bits(state_); }
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
    /// Half of all mixed cases have float inputs, the others use all of a double's bits.
    bool draws_floats() { return inputs_ == Inputs::floats || whole(0, 1) != 0; }
    /// x, or a number of the inputs' precision a few steps away from it.
    double nudged(double x, int steps = 2) {
        const int n = whole(-steps, steps);
        return inputs_ == Inputs::mixed ? moved(x, n) : static_cast<double>(moved(static_cast<float>(x), n));
    }
    P nudged(const P& p) { return {nudged(p.x), nudged(p.y), nudged(p.z)}; }

  private:
    template <class T>
    static T moved(T x, int steps) {
        const T end = std::copysign(std::numeric_limits<T>::infinity(), static_cast<T>(steps));
        for (int i = 0; i < std::abs(steps); ++i) x = std::nextafter(x, end);
        return x;
    }

    std::uint64_t state_;
    Inputs inputs_;
};

/// From -O2 on, g++ 12 drops the rounding where it vectorises several such lines; the asm prevents that.
inline double as_float(double x) {
    auto rounded = static_cast<float>(x);
    asm volatile("" : "+m"(rounded));
    return static_cast<double>(rounded);
}
inline P as_float(const P& p) {
    return {as_float(p.x), as_float(p.y), as_float(p.z)};
}

/// A size at which squares, cubes or fourth powers of the lengths leave the range of doubles, entirely or in part.
inline double to_the_ends(std::uint64_t seed) {
    static constexpr std::array<int, 8> exponents{-1000, -537, -530, -360, -268, 255, 340, 500};
    return std::exp2(exponents[static_cast<std::size_t>(Random(seed).whole(0, 7))]);
}

}  // namespace reference::accuracy
