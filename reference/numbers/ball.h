// A real number known to lie in a ball, by Arb: midpoint and radius, every operation rigorous.
#pragma once

#include <arb.h>

#include <compare>

#include "reference/exact/rational.h"

namespace reference {

/// Bits of Arb's midpoint. 80 settle every item of a usual scene; what they do not settle is done again with twice as
/// many.
using Bits = slong;
inline constexpr Bits first_bits = 128;
inline constexpr Bits most_bits = 4096;

class Ball {
  public:
    Ball() {
        tidy_up_with_this_thread();
        arb_init(value_);
    }
    /// The fraction, rounded to `bits` with its error in the radius.
    Ball(const Rational& x, Bits bits);
    Ball(const Ball& other) : Ball() { arb_set(value_, other.value_); }
    Ball(Ball&& other) noexcept : Ball() { arb_swap(value_, other.value_); }
    Ball& operator=(Ball other) noexcept {
        arb_swap(value_, other.value_);
        return *this;
    }
    ~Ball() { arb_clear(value_); }

    /// Of the numbers in the ball that are not negative: the caller knows that the true value is one.
    Ball sqrt(Bits bits) const;
    /// Everything where y may be zero.
    static Ball divide(const Ball& x, const Ball& y, Bits bits);
    static Ball multiply(const Ball& x, const Ball& y, Bits bits);
    static Ball add(const Ball& x, const Ball& y, Bits bits);
    static Ball subtract(const Ball& x, const Ball& y, Bits bits);

    /// Unordered where the ball holds zero and other numbers.
    std::partial_ordering sign() const;
    /// The tightest doubles around the whole ball; `nearest` is that of the midpoint.
    Enclosure enclosure() const;
    /// All numbers of the ball round to the same double.
    bool settles_a_double() const;

  private:
    /// FLINT keeps what a thread has freed until that thread tells it that it ends.
    static void tidy_up_with_this_thread();
    arb_t value_;
};

}  // namespace reference
