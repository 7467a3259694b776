// An interval that contains the true value for any roundings of T. Run over Interval<float>, the stages bound the
// results of every float32 program that uses the same formulas. Run over Interval<double>, they bound the results of
// numbers of which only some digits are known.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <compare>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace reference {

/// [lo, hi] with lo <= hi, infinite if nothing is known; never NaN. T is float or double.
template <std::floating_point T>
class Interval {
  public:
    /// Zero.
    Interval() = default;
    /// Exactly x; the whole line when x is NaN.
    explicit Interval(T x) : Interval(x, x) {}
    /// The integer x, widened if T cannot represent it.
    explicit Interval(int x) : Interval(static_cast<T>(x)) {
        if (static_cast<double>(lo_) != static_cast<double>(x)) *this = widened(lo_, hi_);
    }
    /// Everything from lo to hi; the whole line if either is NaN or lo > hi.
    Interval(T lo, T hi) : lo_(lo <= hi ? lo : -infinity), hi_(lo <= hi ? hi : infinity) {}

    /// [lo, hi] moved outward by one step of T, which covers one rounding to nearest of each bound.
    /// By a step, not by a rounding mode: g++ 12 moves arithmetic across fesetround.
    static Interval widened(T lo, T hi) { return Interval(-above(-lo), above(hi)); }
    static Interval whole() { return Interval(-infinity, infinity); }

    T lo() const { return lo_; }
    T hi() const { return hi_; }
    bool contains(T x) const { return lo_ <= x && x <= hi_; }
    bool is_zero() const { return lo_ == 0 && hi_ == 0; }
    bool is_bounded() const { return std::isfinite(lo_) && std::isfinite(hi_); }

    Interval operator-() const { return Interval(-hi_, -lo_); }
    Interval& operator+=(const Interval& y) { return *this = *this + y; }
    Interval& operator-=(const Interval& y) { return *this = *this - y; }
    Interval& operator*=(const Interval& y) { return *this = *this * y; }
    Interval& operator/=(const Interval& y) { return *this = *this / y; }

    // A sum with zero and a product with zero are exact in every arithmetic, so they are not widened.
    friend Interval operator+(const Interval& x, const Interval& y) {
        if (x.is_zero()) return y;
        return y.is_zero() ? x : widened(x.lo_ + y.lo_, x.hi_ + y.hi_);
    }
    friend Interval operator-(const Interval& x, const Interval& y) { return x + -y; }
    friend Interval operator*(const Interval& x, const Interval& y) {
        if (x.is_zero() || y.is_zero()) return Interval();
        return hull_of(x.lo_ * y.lo_, x.lo_ * y.hi_, x.hi_ * y.lo_, x.hi_ * y.hi_);
    }
    /// The whole line if y may be zero.
    friend Interval operator/(const Interval& x, const Interval& y) {
        if (y.lo_ <= 0 && y.hi_ >= 0) return whole();
        if (x.is_zero()) return x;
        return hull_of(x.lo_ / y.lo_, x.lo_ / y.hi_, x.hi_ / y.lo_, x.hi_ / y.hi_);
    }

    /// The root of the part of x that is not negative; the whole line when all of x is negative.
    friend Interval sqrt(const Interval& x) {
        if (x.hi_ < 0) return whole();
        if (x.is_zero()) return x;
        const Interval root = widened(std::sqrt(std::max(x.lo_, T{0})), std::sqrt(x.hi_));
        return Interval(std::max(root.lo_, T{0}), root.hi_);
    }

    /// The smallest interval that contains both.
    friend Interval hull(const Interval& x, const Interval& y) {
        return Interval(std::min(x.lo_, y.lo_), std::max(x.hi_, y.hi_));
    }

    /// Unordered if the interval contains zero and other numbers.
    friend std::partial_ordering sign_of(const Interval& x) {
        if (x.lo_ > 0) return std::partial_ordering::greater;
        if (x.hi_ < 0) return std::partial_ordering::less;
        return x.is_zero() ? std::partial_ordering::equivalent : std::partial_ordering::unordered;
    }

  private:
    static constexpr T infinity = std::numeric_limits<T>::infinity();

    /// std::nextafter(x, infinity), inlined, because calls of it would take most of an interval's time. The bits of
    /// floats, read as integers, are ordered by their sizes.
    static T above(T x) {
        using Word = std::conditional_t<std::is_same_v<T, float>, std::uint32_t, std::uint64_t>;
        static_assert(sizeof(Word) == sizeof(T));
        if (!(x < infinity)) return x;  // infinity, NaN
        if (x == 0) return std::numeric_limits<T>::denorm_min();
        const auto bits = std::bit_cast<Word>(x);
        return std::bit_cast<T>(static_cast<Word>(x > 0 ? bits + 1 : bits - 1));
    }

    /// The hull of four bounds, widened. A NaN among them, from 0 * infinity, makes it the whole line.
    static Interval hull_of(T p, T q, T r, T s) {
        if (std::isnan(p) || std::isnan(q) || std::isnan(r) || std::isnan(s)) return whole();
        return widened(std::min({p, q, r, s}), std::max({p, q, r, s}));
    }

    T lo_ = 0;
    T hi_ = 0;
};

}  // namespace reference
