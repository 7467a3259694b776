// Exact numbers made from doubles by sums and products: a whole number times a power of two. The stages run over them
// if the filters leave a decision open. Unlike with rationals, no fraction is ever reduced, which would take most of
// the time.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <utility>

#include "reference/stages/order.h"

namespace reference::kernel {

class Dyadic {
  public:
    Dyadic() = default;
    explicit Dyadic(int x) : mantissa_(x) {}
    /// x is finite.
    explicit Dyadic(double x) {
        int exponent = 0;
        mantissa_ = std::ldexp(std::frexp(x, &exponent), 53);
        exponent_ = exponent - 53;
    }
    Dyadic(mpz_class mantissa, long exponent) : mantissa_(std::move(mantissa)), exponent_(exponent) {}

    const mpz_class& mantissa() const { return mantissa_; }
    long exponent() const { return exponent_; }

    Dyadic operator-() const { return {mpz_class(-mantissa_), exponent_}; }
    friend Dyadic operator*(const Dyadic& x, const Dyadic& y) {
        return {mpz_class(x.mantissa_ * y.mantissa_), x.exponent_ + y.exponent_};
    }
    friend Dyadic operator+(const Dyadic& x, const Dyadic& y) {
        const long exponent = std::min(x.exponent_, y.exponent_);
        return {mpz_class(x.mantissa_at(exponent) + y.mantissa_at(exponent)), exponent};
    }
    friend Dyadic operator-(const Dyadic& x, const Dyadic& y) { return x + -y; }

    friend std::partial_ordering sign_of(const Dyadic& x) { return sgn(x.mantissa_) <=> 0; }

  private:
    /// exponent <= exponent_
    mpz_class mantissa_at(long exponent) const {
        return mpz_class(mantissa_ << static_cast<mp_bitcnt_t>(exponent_ - exponent));
    }

    mpz_class mantissa_ = 0;
    long exponent_ = 0;
};

/// The double nearest to t; +0 for 0, and infinite beyond the range of doubles. Below 1e-308 t is rounded twice.
double nearest(const reference::Fraction<Dyadic>& t);
double nearest(const QuadraticRoot<Dyadic>& t);
double nearest(const HitParameter<Dyadic>& t);

}  // namespace reference::kernel
