// The float form of the distributions: every number is a float, and the cases are as hard as their names say.
#include "reference/accuracy/rays/distributions.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "reference/accuracy/rays/truth.h"

namespace reference::accuracy {
namespace {

using reference::Cylinder;
using reference::Sphere;
using reference::Triangle;

constexpr int draws_of_each = 2'000;

/// Goes through memory, because g++ 12 may omit a rounding to float and back.
void expect_float(double x) {
    volatile float rounded = static_cast<float>(x);
    EXPECT_EQ(x, static_cast<double>(rounded));
}
void expect_floats(const P& p) {
    expect_float(p.x);
    expect_float(p.y);
    expect_float(p.z);
}
void expect_floats(const Ray<double>& ray) {
    expect_floats(ray.origin);
    expect_floats(ray.direction);
    EXPECT_NE(ray.direction, P(0, 0, 0));
}
void expect_floats(const Sphere<double>& sphere) {
    expect_floats(sphere.center);
    expect_float(sphere.radius);
    EXPECT_GT(sphere.radius, 0);
}
void expect_floats(const Cylinder<double>& cylinder) {
    expect_floats(cylinder.center);
    expect_float(cylinder.radius);
    expect_float(cylinder.height);
    EXPECT_GT(std::min(cylinder.radius, cylinder.height), 0);
}
void expect_floats(const Triangle<double>& triangle) {
    expect_floats(triangle.A);
    expect_floats(triangle.B);
    expect_floats(triangle.C);
}

template <class Case, class Check>
void for_each_in_floats(const std::vector<Distribution<Case>>& distributions, Check check) {
    for (const auto& distribution : distributions) {
        if (distribution.exists == Exists::in_doubles_only) continue;
        for (std::uint64_t seed = 0; seed < draws_of_each && !testing::Test::HasFailure(); ++seed) {
            SCOPED_TRACE(testing::Message() << distribution.name << ", seed " << seed);
            check(distribution.make_in_floats(seed));
        }
    }
}

TEST(DistributionsInFloats, ContainOnlyFloats) {
    for_each_in_floats(sphere_distributions(), [](const SphereCase& c) {
        expect_floats(c.ray);
        expect_floats(c.sphere);
    });
    for_each_in_floats(triangle_distributions(), [](const TriangleCase& c) {
        expect_floats(c.ray);
        expect_floats(c.triangle);
    });
    for_each_in_floats(cylinder_distributions(), [](const CylinderCase& c) {
        expect_floats(c.ray);
        expect_floats(c.cylinder);
    });
    for_each_in_floats(order_distributions(), [](const OrderCase& c) {
        expect_floats(c.ray);
        expect_floats(c.sphere);
        expect_floats(c.triangle);
    });
}

template <class Case>
Distribution<Case> named(const std::vector<Distribution<Case>>& distributions, std::string_view name) {
    for (const auto& distribution : distributions) {
        if (distribution.name == name) return distribution;
    }
    throw std::logic_error("no such distribution");
}

TEST(DistributionsInFloats, AnExactTangentStaysExact) {
    const auto distribution = named(sphere_distributions(), "exact tangent");
    for (std::uint64_t seed = 0; seed < draws_of_each; ++seed) {
        const SphereCase c = distribution.make_in_floats(seed);
        const truth::SphereTruth found = truth::sphere(c.ray, c.sphere);
        ASSERT_EQ(found.h * found.h, found.a * found.c) << "seed " << seed;
    }
}

/// Checks that some rays hit and some miss.
template <class Case, class IsHit>
void expect_both_answers(const std::vector<Distribution<Case>>& distributions, IsHit is_hit) {
    for (const auto& distribution : distributions) {
        if (distribution.exists == Exists::in_doubles_only) continue;
        int hits = 0;
        for (std::uint64_t seed = 0; seed < draws_of_each; ++seed) hits += is_hit(distribution.make_in_floats(seed));
        EXPECT_GT(hits, draws_of_each / 100) << distribution.name;
        if (distribution.name == "huge and near") continue;  // all rays hit; only t is hard
        EXPECT_LT(hits, draws_of_each - draws_of_each / 100) << distribution.name;
    }
}

TEST(DistributionsInFloats, ContainHitsAndMisses) {
    expect_both_answers(sphere_distributions(), [](const SphereCase& c) {
        return truth::sphere(c.ray, c.sphere).result != reference::kernel::SphereResult::miss ? 1 : 0;
    });
    expect_both_answers(triangle_distributions(), [](const TriangleCase& c) {
        return truth::triangle(c.ray, c.triangle).result == reference::kernel::TriangleResult::hit ? 1 : 0;
    });
    expect_both_answers(cylinder_distributions(),
                        [](const CylinderCase& c) { return truth::cylinder(c.ray, c.cylinder) ? 1 : 0; });
}

}  // namespace
}  // namespace reference::accuracy
