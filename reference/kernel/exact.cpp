#include "reference/kernel/exact.h"

#include "reference/numbers/rational.h"

namespace reference::kernel {
namespace {

/// √x rounded down to at least this many bits; x > 0.
struct RootBelow {
    Dyadic root;
    Dyadic next;  ///< the same with 1 added in the last place: above √x
    bool is_exact;

    RootBelow(const Dyadic& x, std::size_t bits) {
        const std::size_t size = mpz_sizeinbase(x.mantissa().get_mpz_t(), 2);
        std::size_t shift = size < 2 * bits ? 2 * bits - size : 0;
        if ((x.exponent() - static_cast<long>(shift)) % 2 != 0) ++shift;
        const mpz_class shifted = x.mantissa() << shift;
        mpz_class below, rest;
        mpz_sqrtrem(below.get_mpz_t(), rest.get_mpz_t(), shifted.get_mpz_t());
        const long exponent = (x.exponent() - static_cast<long>(shift)) / 2;
        root = Dyadic(below, exponent);
        next = Dyadic(mpz_class(below + 1), exponent);
        is_exact = rest == 0;
    }
};

/// The quadratic's root with `spread` instead of √d, in the form without a subtraction: no digits cancel.
reference::Fraction<Dyadic> fraction_of(const QuadraticRoot<Dyadic>& t, const Dyadic& spread) {
    const auto& [a, b, c, d] = t.quadratic;
    const bool is_smaller = t.choice == RootChoice::smaller;
    const auto b_sign = sign_of(b);
    const Dyadic sum = b_sign < 0 ? spread - b : spread + b;  // |b| + √d
    const bool has_same_sign = is_smaller ? b_sign >= 0 : b_sign <= 0;
    if (has_same_sign) return {is_smaller ? -sum : sum, a + a};
    return {is_smaller ? c + c : -(c + c), sum};
}

}  // namespace

double nearest(const reference::Fraction<Dyadic>& t) {
    Rational x(t.numerator.mantissa(), t.denominator.mantissa());
    x.canonicalize();
    const long exponent = t.numerator.exponent() - t.denominator.exponent();
    const auto bits = static_cast<mp_bitcnt_t>(std::abs(exponent));
    if (exponent < 0) {
        x >>= bits;
    } else {
        x <<= bits;
    }
    return enclose(x).nearest;
}

double nearest(const QuadraticRoot<Dyadic>& t) {
    if (sign_of(t.quadratic.d) == 0) return nearest(fraction_of(t, Dyadic()));
    // An irrational t is neither a double nor halfway between two, so some number of bits shows which double is
    // nearest.
    for (std::size_t bits = 128;; bits *= 2) {
        const RootBelow spread(t.quadratic.d, bits);
        const double from_below = nearest(fraction_of(t, spread.root));
        if (spread.is_exact || from_below == nearest(fraction_of(t, spread.next))) return from_below;
    }
}

double nearest(const HitParameter<Dyadic>& t) {
    return std::visit([](const auto& known) { return nearest(known); }, t);
}

}  // namespace reference::kernel
