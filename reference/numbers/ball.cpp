#include "reference/numbers/ball.h"

#include <flint/flint.h>
#include <flint/fmpq.h>
#include <unistd.h>

namespace reference {
namespace {

/// Both ends of the ball as doubles, the lower rounded by `below`, the upper by `above`.
std::pair<double, double> ends(const arb_t& x, arf_rnd_t below, arf_rnd_t above) {
    arf_t lower;
    arf_t upper;
    arf_init(lower);
    arf_init(upper);
    arb_get_interval_arf(lower, upper, x, most_bits * 2);
    const std::pair<double, double> result{arf_get_d(lower, below) + 0.0, arf_get_d(upper, above) + 0.0};
    arf_clear(lower);
    arf_clear(upper);
    return result;
}

}  // namespace

void Ball::tidy_up_with_this_thread() {
    // The first thread does not clean up: its memory is freed with the process, because static objects may have a Ball
    // until then.
    struct Tidying {
        bool is_first = gettid() == getpid();
        ~Tidying() {
            if (!is_first) flint_cleanup();
        }
    };
    thread_local const Tidying tidying;
    static_cast<void>(tidying.is_first);
}

Ball::Ball(const Rational& x, Bits bits) : Ball() {
    fmpq_t fraction;
    fmpq_init(fraction);
    fmpq_set_mpq(fraction, x.get_mpq_t());
    arb_set_fmpq(value_, fraction, bits);
    fmpq_clear(fraction);
}

Ball Ball::sqrt(Bits bits) const {
    Ball result;
    arb_sqrtpos(result.value_, value_, bits);
    return result;
}

Ball Ball::divide(const Ball& x, const Ball& y, Bits bits) {
    Ball result;
    arb_div(result.value_, x.value_, y.value_, bits);
    return result;
}

Ball Ball::multiply(const Ball& x, const Ball& y, Bits bits) {
    Ball result;
    arb_mul(result.value_, x.value_, y.value_, bits);
    return result;
}

Ball Ball::add(const Ball& x, const Ball& y, Bits bits) {
    Ball result;
    arb_add(result.value_, x.value_, y.value_, bits);
    return result;
}

Ball Ball::subtract(const Ball& x, const Ball& y, Bits bits) {
    Ball result;
    arb_sub(result.value_, x.value_, y.value_, bits);
    return result;
}

std::partial_ordering Ball::sign() const {
    if (arb_is_positive(value_) != 0) return std::partial_ordering::greater;
    if (arb_is_negative(value_) != 0) return std::partial_ordering::less;
    return arb_is_zero(value_) != 0 ? std::partial_ordering::equivalent : std::partial_ordering::unordered;
}

Enclosure Ball::enclosure() const {
    const auto [lo, hi] = ends(value_, ARF_RND_FLOOR, ARF_RND_CEIL);
    return {lo, hi, arf_get_d(arb_midref(value_), ARF_RND_NEAR) + 0.0};
}

bool Ball::settles_a_double() const {
    const auto [lo, hi] = ends(value_, ARF_RND_NEAR, ARF_RND_NEAR);
    return lo == hi;
}

}  // namespace reference
