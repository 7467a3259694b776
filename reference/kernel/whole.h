// Whole numbers of any size, where those of fixed.h do not suffice: numbers whose sizes differ by hundreds of bits.
#pragma once

#include <gmpxx.h>

#include <cmath>
#include <compare>
#include <cstdint>
#include <utility>

namespace reference::kernel {

/// As Fixed, without an end.
class Integer {
  public:
    Integer() = default;
    /// mantissa * 2^shift, shift >= 0.
    Integer(std::int64_t mantissa, int shift) : value_(static_cast<long>(mantissa)) {
        value_ <<= static_cast<mp_bitcnt_t>(shift);
    }
    /// x is a whole number.
    explicit Integer(double x) : value_(x) {}
    const mpz_class& value() const { return value_; }
    /// A double within one unit in the last place; infinite beyond the doubles.
    double as_double() const {
        return mpz_sizeinbase(value_.get_mpz_t(), 2) > 1023 ? sgn(value_) * HUGE_VAL : value_.get_d();
    }

    friend Integer operator+(const Integer& x, const Integer& y) { return Integer(mpz_class(x.value_ + y.value_)); }
    friend Integer operator-(const Integer& x, const Integer& y) { return Integer(mpz_class(x.value_ - y.value_)); }
    friend Integer operator*(const Integer& x, const Integer& y) { return Integer(mpz_class(x.value_ * y.value_)); }
    friend std::partial_ordering sign_of(const Integer& x) { return sgn(x.value_) <=> 0; }

  private:
    explicit Integer(mpz_class x) : value_(std::move(x)) {}
    mpz_class value_ = 0;
};

}  // namespace reference::kernel
