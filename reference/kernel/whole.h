// Whole numbers for the exact level of the kernel, as scalars of the stages.
#pragma once

#include <gmpxx.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <compare>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace reference::kernel {

/// A whole number in some representation. `Number` is GMP's, of any size, or Boost's of fixed size.
template <class Number>
class Whole {
  public:
    Whole() = default;
    explicit Whole(int x) : value_(x) {}
    /// mantissa * 2^shift, shift >= 0.
    Whole(std::int64_t mantissa, unsigned shift) : value_(static_cast<long>(mantissa)) { value_ <<= shift; }
    /// x is a whole number.
    explicit Whole(double x) : value_(x) {}
    const Number& value() const { return value_; }
    /// A double within one unit in the last place; infinite beyond the doubles.
    double as_double() const {
        if constexpr (std::is_same_v<Number, mpz_class>) {
            return mpz_sizeinbase(value_.get_mpz_t(), 2) > 1023 ? sgn(value_) * HUGE_VAL : value_.get_d();
        } else {
            return value_.template convert_to<double>();
        }
    }

    Whole operator-() const { return Whole(Number(-value_)); }
    friend Whole operator+(const Whole& x, const Whole& y) { return Whole(Number(x.value_ + y.value_)); }
    friend Whole operator-(const Whole& x, const Whole& y) { return Whole(Number(x.value_ - y.value_)); }
    friend Whole operator*(const Whole& x, const Whole& y) { return Whole(Number(x.value_ * y.value_)); }
    Whole& operator+=(const Whole& y) {
        value_ += y.value_;
        return *this;
    }
    Whole& operator-=(const Whole& y) {
        value_ -= y.value_;
        return *this;
    }
    friend std::partial_ordering sign_of(const Whole& x) {
        if (x.value_ < 0) return std::partial_ordering::less;
        return x.value_ > 0 ? std::partial_ordering::greater : std::partial_ordering::equivalent;
    }

  private:
    explicit Whole(Number x) : value_(std::move(x)) {}
    Number value_ = 0;
};

using Integer = Whole<mpz_class>;

/// Without the heap: five times as fast, for numbers that are known to fit.
inline constexpr int wide_bits = 512;
using WideInteger = Whole<boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<wide_bits, wide_bits, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked, void>,
    boost::multiprecision::et_off>>;

}  // namespace reference::kernel
