// A float program's number whose roundings are drawn: each result is off by anything up to half a unit in float's last
// place. What formulas do at their worst is seen sooner than with the processor's roundings, of which a scene has only
// one set for each order of operations.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <ostream>

#include "reference/numbers/splitmix.h"

namespace correct {

class Drawn {
  public:
    Drawn() = default;
    Drawn(int x) : Drawn(static_cast<double>(x)) {}  // NOLINT: GLM converts its constants
    /// Exactly x.
    Drawn(double x) : value_(x), is_exact_(true) {}  // NOLINT

    /// Begins a program. If it is `fast`, its roots and quotients are those of -ffast-math.
    static void begin(bool fast) { fast_ = fast; }
    static bool draw_bit() { return (next_bits() & 1U) != 0; }

    friend Drawn operator+(const Drawn& x, const Drawn& y) { return result(x.value_ + y.value_, x, y); }
    friend Drawn operator-(const Drawn& x, const Drawn& y) { return result(x.value_ - y.value_, x, y); }
    friend Drawn operator*(const Drawn& x, const Drawn& y) {
        if (x.is_power_of_two() || y.is_power_of_two()) return unrounded(x.value_ * y.value_, x, y);
        return result(x.value_ * y.value_, x, y);
    }
    friend Drawn operator/(const Drawn& x, const Drawn& y) {
        if (y.is_power_of_two()) return unrounded(x.value_ / y.value_, x, y);
        return fast_ ? x * result(1 / y.value_, y, y) : result(x.value_ / y.value_, x, y);
    }
    Drawn operator+() const { return *this; }
    Drawn operator-() const { return unrounded(-value_, *this, *this); }
    Drawn& operator+=(const Drawn& y) { return *this = *this + y; }
    Drawn& operator-=(const Drawn& y) { return *this = *this - y; }
    Drawn& operator*=(const Drawn& y) { return *this = *this * y; }
    Drawn& operator/=(const Drawn& y) { return *this = *this / y; }
    friend auto operator<=>(const Drawn& x, const Drawn& y) { return x.value_ <=> y.value_; }
    friend bool operator==(const Drawn& x, const Drawn& y) { return x.value_ == y.value_; }

    friend Drawn sqrt(const Drawn& x) { return result(std::sqrt(x.value_), x, x); }
    friend Drawn abs(const Drawn& x) { return x.value_ < 0 ? -x : x; }
    friend Drawn pow(const Drawn& x, const Drawn& n) { return result(std::pow(x.value_, n.value_), x, n); }
    /// What glm::normalize calls. Under -ffast-math it is rsqrtss, which is off by up to 1.5 2^-12, and a step of
    /// Newton's, which leaves 3/2 of the square of that.
    friend Drawn inversesqrt(const Drawn& x) {
        if (!fast_) return Drawn(1) / sqrt(x);
        const double estimate = 1.5 * 0x1p-12 * draw();
        return result((1 - 1.5 * estimate * estimate) / std::sqrt(x.value_), x, x);
    }
    friend std::ostream& operator<<(std::ostream& out, const Drawn& x) { return out << x.value_; }

  private:
    static std::uint64_t next_bits() { return reference::next_random_bits(state_); }
    /// In [-1, 1).
    static double draw() { return static_cast<double>(static_cast<std::int64_t>(next_bits()) >> 10) * 0x1p-53; }

    static Drawn unrounded(double value, const Drawn& x, const Drawn& y) {
        Drawn result(value);
        result.is_exact_ = x.is_exact_ && y.is_exact_;
        return result;
    }
    static Drawn result(double value, const Drawn& x, const Drawn& y) {
        const bool is_float = static_cast<double>(static_cast<float>(value)) == value;
        if (is_float && x.is_exact_ && y.is_exact_) return Drawn(value);
        if (value == 0 || !std::isfinite(value)) return unrounded(value, x, y);
        const double half_unit = std::ldexp(1.0, std::ilogb(value) - std::numeric_limits<float>::digits);
        Drawn drawn(value + half_unit * draw());
        drawn.is_exact_ = false;
        return drawn;
    }
    bool is_power_of_two() const {
        int exponent = 0;
        return is_exact_ && std::abs(std::frexp(value_, &exponent)) == 0.5;
    }

    static inline std::uint64_t state_ = 1;
    static inline bool fast_ = false;

    double value_ = 0;
    bool is_exact_ = true;
};

}  // namespace correct

// GLM's functions take it for a floating-point number.
template <>
struct std::numeric_limits<correct::Drawn> : std::numeric_limits<float> {};
