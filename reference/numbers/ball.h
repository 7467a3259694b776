// A real number known to lie in a ball, by Arb: midpoint and radius, every operation rigorous.
#pragma once

// FLINT 3 contains Arb; before that, Arb was a separate library.
#if __has_include(<flint/arb.h>)
#include <flint/arb.h>
#else
#include <arb.h>
#endif

#include <compare>

#include "reference/numbers/rational.h"

namespace reference {

/// Bits of Arb's midpoint. 80 bits are enough for every item of a usual scene. If first_bits are not enough, the
/// computation is repeated with twice as many, up to most_bits.
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

    /// The roots of the nonnegative numbers in the ball. The caller knows that the true value is not negative.
    Ball sqrt(Bits bits) const;
    /// The whole line if y may be zero.
    static Ball divide(const Ball& x, const Ball& y, Bits bits);
    static Ball multiply(const Ball& x, const Ball& y, Bits bits);
    static Ball add(const Ball& x, const Ball& y, Bits bits);
    static Ball subtract(const Ball& x, const Ball& y, Bits bits);

    /// Unordered if the ball contains zero and other numbers.
    std::partial_ordering sign() const;
    /// The tightest doubles around the whole ball; `nearest` is the double nearest to the midpoint.
    Enclosure enclosure() const;
    /// Whether all numbers of the ball round to the same double.
    bool settles_a_double() const;

  private:
    /// FLINT caches the memory that a thread has freed until the thread calls FLINT's cleanup at its end.
    static void tidy_up_with_this_thread();
    arb_t value_;
};

}  // namespace reference
