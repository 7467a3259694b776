// The truth that judges every method: on every case of the catalog, and for orders beside a thousand digits. The
// kernel's tests compare it with the kernel, which uses other formulas, on random rays of all distributions.
#include "reference/accuracy/rays/truth.h"

#include <gtest/gtest.h>

#include "reference/accuracy/rays/distributions.h"
#include "reference/hard_cases/cases.h"

namespace reference::accuracy {
namespace {

using reference::Vec3;
using reference::kernel::SphereResult;
using reference::kernel::TriangleResult;

constexpr std::uint64_t seed = 20211101;
constexpr int rays_of_each = 2'500;

TEST(Truth, AgreesWithTheCatalog) {
    for (const auto& c : hard_cases::cases()) {
        if (c.decision == "invalid") continue;
        SCOPED_TRACE(c.id);
        if (const auto* sphere = std::get_if<Sphere<double>>(&c.target)) {
            const SphereResult found = truth::sphere(c.ray, *sphere).result;
            EXPECT_EQ(found == SphereResult::tangent, c.decision == "tangent");
            EXPECT_EQ(found == SphereResult::miss, c.decision == "miss");
        }
        if (const auto* triangle = std::get_if<Triangle<double>>(&c.target)) {
            const TriangleResult found = truth::triangle(c.ray, *triangle).result;
            EXPECT_EQ(found == TriangleResult::hit, c.decision == "hit");
            EXPECT_EQ(found == TriangleResult::degenerate, c.decision == "degenerate");
            EXPECT_EQ(found == TriangleResult::coplanar, c.decision == "coplanar");
        }
        if (const auto* cylinder = std::get_if<Cylinder<double>>(&c.target)) {
            const auto found = truth::cylinder(c.ray, *cylinder);
            EXPECT_EQ(found && found->is_tangent, c.decision == "tangent");
            EXPECT_EQ(!found, c.decision == "miss");
        }
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
    Random seeds(seed);
    for (const auto& distribution : order_distributions()) {
        SCOPED_TRACE(distribution.name);
        for (int i = 0; i < rays_of_each; ++i) {
            const OrderCase c = distribution.draw(seeds.bits(), i % 2 == 0 ? Inputs::mixed : Inputs::floats);
            const truth::SphereTruth sphere = truth::sphere(c.ray, c.sphere);
            const truth::TriangleTruth triangle = truth::triangle(c.ray, c.triangle);
            if (sphere.result == SphereResult::miss || triangle.result != TriangleResult::hit) continue;
            const int order = order_by_digits(sphere.t(), truth::real(triangle.t));
            ties += order == 0 ? 1 : 0;
            EXPECT_EQ(true_answer(c).outcome, order == 0  ? Outcome::tie
                                              : order < 0 ? Outcome::sphere_first
                                                          : Outcome::triangle_first);
        }
    }
    EXPECT_GT(ties, 500);
}

/// By hand: the tube x² + z² = 25 with the caps at y = -2 and y = 2.
TEST(Truth, TakesTheFirstOfACylindersParts) {
    using enum kernel::CylinderPart;
    struct ByHand {
        Vec3<double> start, direction;
        kernel::CylinderPart part;
        double t;
    };
    const Cylinder<double> can{Vec3<double>(0, 0, 0), 5, 4};
    for (const auto& [start, direction, part, t] :
         {ByHand{{-9, 1, 0}, {1, 0, 0}, tube, 4}, ByHand{{3, 6, 1}, {0, -2, 0}, top, 2},
          ByHand{{-9, 6, 0}, {1, -1, 0}, tube, 4},  // the rim
          ByHand{{1, 1, 1}, {0, -1, 0}, bottom, 3}, ByHand{{-3, 1, 0}, {1, 0, 0}, tube, 8}}) {
        const auto hit = truth::cylinder({start, direction}, can);
        ASSERT_TRUE(hit);
        EXPECT_EQ(hit->part, part);
        EXPECT_EQ(hit->t.value(), t);
        EXPECT_EQ(true_answer(CylinderCase{{start, direction}, can}).t, t);
    }
    EXPECT_FALSE(truth::cylinder({{-9, 6, 0}, {1, 0, 0}}, can));
    EXPECT_FALSE(truth::cylinder({{3, 6, 4}, {0, -1, 0}}, can)) << "along the side";
    EXPECT_FALSE(truth::cylinder({{5, 0, 0}, {1, 0, 0}}, can, Boundary::positive));
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
