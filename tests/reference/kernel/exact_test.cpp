// Compares exact numbers, and the doubles nearest to their quotients and roots, with fractions and a thousand digits.
#include "reference/kernel/exact.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>

#include "reference/accuracy/rays/random_numbers.h"
#include "reference/accuracy/rays/truth.h"

namespace {

namespace truth = reference::accuracy::truth;

using namespace reference::kernel;
using reference::Quadratic;
using reference::QuadraticRoot;
using reference::RootChoice;
using reference::accuracy::Random;
using reference::accuracy::truth::Real;

/// Of few or many bits, near 1 or very large or small; often 0 or a neighbor of a whole number.
double drawn(Random& random) {
    switch (random.whole(0, 3)) {
        case 0: return random.whole(-9, 9);
        case 1: return random.nudged(random.whole(-9, 9));
        case 2: return random.number() * std::exp2(random.whole(-300, 300));
        default: return random.number();
    }
}

/// No other double is nearer to the true value; infinite if that is beyond the largest double by half a unit in its
/// last place.
void expect_nearest(double given, const Real& true_value) {
    EXPECT_FALSE(given == 0 && std::signbit(given));
    if (std::isinf(given)) {
        EXPECT_GE(given > 0 ? true_value : -true_value, Real(DBL_MAX) + Real(0x1p969));
        return;
    }
    if (std::abs(given) < DBL_MIN) {  // rounded twice: to 53 bits, then to a multiple of 2^-1074
        EXPECT_LE(abs(Real(given) - true_value), pow(Real(2), -1075) * (1 + Real(0x1p-50)));
        return;
    }
    const Real error = abs(Real(given) - true_value);
    EXPECT_LE(error, abs(Real(std::nextafter(given, HUGE_VAL)) - true_value)) << given;
    EXPECT_LE(error, abs(Real(std::nextafter(given, -HUGE_VAL)) - true_value)) << given;
}

TEST(Exact, AddsSubtractsAndMultipliesAsFractionsDo) {
    Random random(1);
    for (int i = 0; i < 5000; ++i) {
        const double x = drawn(random), y = drawn(random), z = drawn(random);
        const Dyadic all = (Dyadic(x) + Dyadic(y)) * Dyadic(z) - Dyadic(x) * Dyadic(x);
        const mpq_class expected = (mpq_class(x) + y) * z - mpq_class(x) * x;
        ASSERT_EQ(sign_of(all), sgn(expected) <=> 0);
        ASSERT_EQ(sign_of(all - all), std::partial_ordering::equivalent);
        ASSERT_NEAR(nearest(reference::Fraction<Dyadic>{all, Dyadic(1)}), expected.get_d(),
                    std::abs(expected.get_d()) * 0x1p-52);
    }
}

TEST(Exact, FindsTheDoubleNearestToAQuotient) {
    Random random(2);
    for (int i = 0; i < 2000; ++i) {
        const double x = drawn(random), y = drawn(random);
        if (y == 0) continue;
        expect_nearest(nearest(reference::Fraction<Dyadic>{Dyadic(x), Dyadic(y)}), Real(x) / Real(y));
    }
}

/// Of a (t - p)(t - q), whose roots are rational, often equal or 0; and of quadratics of any numbers.
TEST(Exact, FindsTheDoubleNearestToARoot) {
    Random random(3);
    int found = 0;
    for (int i = 0; i < 4000; ++i) {
        const double p = drawn(random), q = random.whole(0, 3) == 0 ? p : drawn(random);
        const bool is_rational = i % 2 == 0;
        const Dyadic a = is_rational ? Dyadic(random.whole(1, 9)) : Dyadic(std::abs(drawn(random)));
        const Dyadic b = is_rational ? -(a * (Dyadic(p) + Dyadic(q))) : Dyadic(p);
        const Dyadic c = is_rational ? a * Dyadic(p) * Dyadic(q) : Dyadic(q);
        const Dyadic d = b * b - Dyadic(4) * a * c;
        if (sign_of(a) == 0 || sign_of(d) < 0) continue;
        ++found;
        const auto real = [](const Dyadic& x) {
            return Real(x.mantissa().get_str()) * pow(Real(2), static_cast<int>(x.exponent()));
        };
        const Real spread = sqrt(real(d));
        const Quadratic<Dyadic> quadratic{a, b, c, d};
        const Real twice_a = 2 * real(a);
        expect_nearest(nearest(QuadraticRoot<Dyadic>{quadratic, RootChoice::smaller}), (-real(b) - spread) / twice_a);
        expect_nearest(nearest(QuadraticRoot<Dyadic>{quadratic, RootChoice::larger}), (-real(b) + spread) / twice_a);
        if (HasFailure()) return;
    }
    EXPECT_GT(found, 2000);
}

// The square of the middle of two doubles, a little more and a little less: few bits of the root do not tell which of
// the doubles is nearer.
TEST(Exact, FindsTheDoubleNearestToARootBesideTheMiddleOfTwo) {
    const Dyadic middle = Dyadic(1.0) + Dyadic(0x1p-53);
    for (const double beside : {0x1p-200, -0x1p-200, 0x1p-600, -0x1p-600}) {
        const Dyadic square = middle * middle + Dyadic(beside);
        const Quadratic<Dyadic> quadratic{Dyadic(1), Dyadic(0), -square, Dyadic(4) * square};
        EXPECT_EQ(nearest(QuadraticRoot<Dyadic>{quadratic, RootChoice::larger}), beside > 0 ? 1 + 0x1p-52 : 1.0);
        EXPECT_EQ(nearest(QuadraticRoot<Dyadic>{quadratic, RootChoice::smaller}), beside > 0 ? -1 - 0x1p-52 : -1.0);
    }
}

}  // namespace
