// Compares the truth that judges every method with a second derivation: on more than 100,000 random rays of all
// distributions, and on every case of the catalogue.
#include "reference/accuracy/rays/truth.h"

#include <gtest/gtest.h>

#include "reference/accuracy/rays/distributions.h"
#include "tests/given/hard_cases.h"
#include "tests/given/second_derivation.h"

namespace reference::accuracy {
namespace {

using reference::Vec3;
using reference::kernel::SphereResult;
using reference::kernel::TriangleResult;

constexpr std::uint64_t seed = 20211101;
constexpr int rays_of_each = 2'500;  // 43 distributions, counted once in floats and once mixed

template <class Case, class Check>
int for_each_case(const std::vector<Distribution<Case>>& distributions, Check check) {
    int count = 0;
    Random seeds(seed);
    for (const auto& distribution : distributions) {
        for (const Inputs inputs : {Inputs::mixed, Inputs::floats}) {
            if (inputs == Inputs::floats && distribution.exists == Exists::in_doubles_only) continue;
            for (int i = 0; i < rays_of_each && !testing::Test::HasFailure(); ++i, ++count) {
                const std::uint64_t case_seed = seeds.bits();
                SCOPED_TRACE(testing::Message() << distribution.name << ", seed " << case_seed);
                check(distribution.draw(case_seed, inputs));
            }
        }
    }
    return count;
}

mpq_class as_gmp(const truth::Rational& x) {
    return mpq_class(x.backend().data());
}

/// Whether the value agrees with a truth of 1,000 digits to a relative error of 2^-900.
mpq_class floor_of(const truth::Real& x, int bits) {
    mpq_class result(mpz_class(truth::Real(floor(ldexp(x, bits))).str(0, std::ios_base::fixed).c_str()));
    if (bits >= 0) return result >> static_cast<mp_bitcnt_t>(bits);
    return result << static_cast<mp_bitcnt_t>(-bits);
}

void expect_t(const SphereCase& c, const truth::Real& t) {
    constexpr int significant = 900;
    const int bits = t == 0 ? significant : significant - static_cast<int>(ilogb(t));
    const mpq_class below = floor_of(t, bits);
    const mpq_class step = floor_of(ldexp(truth::Real(1), -bits), bits);
    EXPECT_TRUE(second_derivation::is_first_t_within(c.ray, c.sphere, below - step, below + 2 * step));
}

void expect_agreement(const SphereCase& c) {
    const truth::SphereTruth found = truth::sphere(c.ray, c.sphere);
    ASSERT_EQ(found.result, second_derivation::decide(c.ray, c.sphere));
    if (found.result != SphereResult::miss) expect_t(c, found.t());
}

void expect_agreement(const TriangleCase& c) {
    const truth::TriangleTruth found = truth::triangle(c.ray, c.triangle);
    const second_derivation::TriangleSolution second = second_derivation::solve(c.ray, c.triangle);
    ASSERT_EQ(found.result, second.result);
    EXPECT_EQ(as_gmp(found.t), second.t);
    EXPECT_EQ(as_gmp(found.u), second.u);
    EXPECT_EQ(as_gmp(found.v), second.v);
}

TEST(Truth, TwoDerivationsAgreeOnAHundredThousandRandomRays) {
    const int spheres = for_each_case(sphere_distributions(), [](const SphereCase& c) { expect_agreement(c); });
    const int triangles = for_each_case(triangle_distributions(), [](const TriangleCase& c) { expect_agreement(c); });
    EXPECT_GE(spheres + triangles, 100'000);
}

TEST(Truth, TwoDerivationsAndTheCatalogueAgree) {
    for (const auto& c : hard_cases::sphere_cases()) {
        if (c.result == SphereResult::invalid) continue;
        SCOPED_TRACE(c.id);
        EXPECT_EQ(truth::sphere(c.ray, c.sphere).result, c.result);
        expect_agreement(SphereCase{c.ray, c.sphere});
    }
    for (const auto& c : hard_cases::triangle_cases()) {
        if (c.result == TriangleResult::invalid) continue;
        SCOPED_TRACE(c.id);
        EXPECT_EQ(truth::triangle(c.ray, c.triangle).result, c.result);
        expect_agreement(TriangleCase{c.ray, c.triangle});
    }
}

/// Compares 1,000 digits, which suffice: numbers of these heights that differ do so in the first 200 digits.
int order_by_digits(const truth::Real& sphere_t, const truth::Real& triangle_t) {
    const truth::Real difference = sphere_t - triangle_t;
    if (abs(difference) < truth::Real("1e-900")) return 0;
    return difference < 0 ? -1 : 1;
}

TEST(Truth, OrdersHitsAsAThousandDigitsDo) {
    int ties = 0;
    for_each_case(order_distributions(), [&](const OrderCase& c) {
        const truth::SphereTruth sphere = truth::sphere(c.ray, c.sphere);
        const truth::TriangleTruth triangle = truth::triangle(c.ray, c.triangle);
        if (sphere.result == SphereResult::miss || triangle.result != TriangleResult::hit) return;
        const int order = order_by_digits(sphere.t(), truth::real(triangle.t));
        const Outcome outcome = true_answer(c).outcome;
        if (order == 0) {
            ++ties;
            EXPECT_EQ(outcome, Outcome::tie);
        } else {
            EXPECT_EQ(outcome, order < 0 ? Outcome::sphere_first : Outcome::triangle_first);
        }
    });
    EXPECT_GT(ties, 1'000);
}

TEST(TrueAnswer, KnowsTToTwiceTheDigitsOfADouble) {
    // 2 - √2, whose nearest double is 0.585786437626905 to 15 digits.
    const Answer truth =
        true_answer(SphereCase{{Vec3<double>(0, 0, 2), Vec3<double>(0, 0, -1)}, {Vec3<double>(1, 1, 0), 2}});
    EXPECT_EQ(truth.outcome, Outcome::hit);
    const truth::Real t = truth::Real(truth.t) + truth.t_rest;
    const truth::Real error = abs(truth::Real((2 - t) * (2 - t) - 2));
    EXPECT_LT(error, truth::Real(0x1p-104));
    EXPECT_NE(truth.t_rest, 0);
}

}  // namespace
}  // namespace reference::accuracy
