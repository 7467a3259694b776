// A number as the unevaluated sum of two doubles, about 106 bits: the middle level of the certified kernel.
// Dekker (1971); error bounds from Joldes, Muller and Popescu, "Tight and rigorous error bounds for basic building
// blocks of double-word arithmetic" (2017): sums 3u², products 5u², u = 2^-53, while nothing over- or underflows.
#pragma once

#include <cmath>
#include <compare>

namespace reference::kernel {

class DoubleDouble {
  public:
    DoubleDouble() = default;
    explicit DoubleDouble(int x) : high_(x) {}
    explicit DoubleDouble(double x) : high_(x) {}

    /// The nearest double, up to its last bit.
    explicit operator double() const { return high_ + low_; }

    DoubleDouble operator-() const { return DoubleDouble(-high_, -low_); }

    friend DoubleDouble operator+(const DoubleDouble& x, const DoubleDouble& y) {
        const DoubleDouble s = two_sum(x.high_, y.high_);
        const DoubleDouble t = two_sum(x.low_, y.low_);
        const DoubleDouble v = fast_two_sum(s.high_, s.low_ + t.high_);
        return fast_two_sum(v.high_, t.low_ + v.low_);
    }
    friend DoubleDouble operator-(const DoubleDouble& x, const DoubleDouble& y) { return x + -y; }
    friend DoubleDouble operator*(const DoubleDouble& x, const DoubleDouble& y) {
        const DoubleDouble p = two_product(x.high_, y.high_);
        return fast_two_sum(p.high_, p.low_ + (x.high_ * y.low_ + x.low_ * y.high_));
    }
    /// Relative error below 16u²: one correction of the double's quotient.
    friend DoubleDouble operator/(const DoubleDouble& x, const DoubleDouble& y) {
        const double quotient = x.high_ / y.high_;
        const DoubleDouble rest = x - y * DoubleDouble(quotient);
        return fast_two_sum(quotient, rest.high_ / y.high_);
    }
    /// Relative error below 16u²: one Newton step from the double's root. x >= 0.
    friend DoubleDouble sqrt(const DoubleDouble& x) {
        if (!(x.high_ > 0)) return DoubleDouble();
        const double root = std::sqrt(x.high_);
        const DoubleDouble rest = x - two_product(root, root);
        return fast_two_sum(root, rest.high_ / (2 * root));
    }
    friend std::partial_ordering sign_of(const DoubleDouble& x) { return x.high_ <=> 0.0; }

  private:
    DoubleDouble(double high, double low) : high_(high), low_(low) {}

    static DoubleDouble two_sum(double a, double b) {
        const double s = a + b;
        const double b_part = s - a;
        return DoubleDouble(s, (a - (s - b_part)) + (b - b_part));
    }
    /// |a| >= |b|, or a = 0.
    static DoubleDouble fast_two_sum(double a, double b) {
        const double s = a + b;
        return DoubleDouble(s, b - (s - a));
    }
    /// a b exactly.
    static DoubleDouble two_product(double a, double b) {
#ifdef FP_FAST_FMA
        // Not a * b: under -ffp-contract=fast GCC may fuse that product into a later sum and round it differently
        // there.
        const double p = std::fma(a, b, 0.0);
        return DoubleDouble(p, std::fma(a, b, -p));
#else
        const double p = a * b;
        const DoubleDouble x = split(a);
        const DoubleDouble y = split(b);
        const double rest = ((x.high_ * y.high_ - p) + x.high_ * y.low_) + x.low_ * y.high_;
        return DoubleDouble(p, rest + x.low_ * y.low_);
#endif
    }
#ifndef FP_FAST_FMA
    /// Veltkamp's splitting into halves of 26 bits.
    static DoubleDouble split(double a) {
        const double c = 134217729.0 * a;  // 2^27 + 1
        const double high = c - (c - a);
        return DoubleDouble(high, a - high);
    }
#endif

    double high_ = 0;
    double low_ = 0;
};

}  // namespace reference::kernel
