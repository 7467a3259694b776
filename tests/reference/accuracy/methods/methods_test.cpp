// The methods by themselves: their common policy, and their treatment of nan and infinity.
#include <gtest/gtest.h>

#include <limits>

#include "reference/accuracy/methods/cast_methods.h"
#include "reference/accuracy/methods/cylinder_methods.h"
#include "reference/accuracy/methods/method.h"
#include "reference/hard_cases/cases.h"

namespace {

using namespace reference::accuracy;
using reference::Vec3;

template <class S>
void expect_no_surprise(const Hit<S>& found) {
    if (found.hit) {
        EXPECT_GE(found.t, 0);
    }
}

template <class Case, class Check>
void for_each_in_floats(const std::vector<Distribution<Case>>& distributions, Check check) {
    for (const auto& distribution : distributions) {
        if (distribution.exists == Exists::in_doubles_only) continue;
        SCOPED_TRACE(distribution.name);
        for (std::uint64_t seed = 0; seed < 5'000; ++seed) check(distribution.make_in_floats(seed));
    }
}

TEST(NaiveDouble, NeverReportsAHitWithoutANumber) {
    for_each_in_floats(sphere_distributions(), [](const SphereCase& c) {
        expect_no_surprise(naive_quadratic(c.ray, c.sphere));
        expect_no_surprise(half_b(c.ray, c.sphere));
        expect_no_surprise(stable(c.ray, c.sphere));
    });
    for_each_in_floats(triangle_distributions(), [](const TriangleCase& c) {
        expect_no_surprise(by_inverse(c.ray, c.triangle));
        expect_no_surprise(cramer(c.ray, c.triangle));
        expect_no_surprise(moller_trumbore(c.ray, c.triangle));
        expect_no_surprise(moller_trumbore_branch_free(c.ray, c.triangle));
    });
    for_each_in_floats(cylinder_distributions(), [](const CylinderCase& c) {
        expect_no_surprise(textbook_parts(c.ray, c.cylinder));
        expect_no_surprise(stable_parts(c.ray, c.cylinder));
        expect_no_surprise(slabs(c.ray, c.cylinder));
    });
}

TEST(NaiveDouble, NeverReportsAHitWithoutANumberInTheCatalog) {
    for (const auto& c : reference::hard_cases::cases()) {
        SCOPED_TRACE(c.id);
        if (const auto* sphere = std::get_if<reference::Sphere<double>>(&c.target)) {
            expect_no_surprise(naive_quadratic(c.ray, *sphere));
            expect_no_surprise(half_b(c.ray, *sphere));
            expect_no_surprise(stable(c.ray, *sphere));
        }
        if (const auto* triangle = std::get_if<reference::Triangle<double>>(&c.target)) {
            expect_no_surprise(cramer(c.ray, *triangle));
            expect_no_surprise(moller_trumbore(c.ray, *triangle));
            expect_no_surprise(moller_trumbore_branch_free(c.ray, *triangle));
        }
        if (const auto* cylinder = std::get_if<reference::Cylinder<double>>(&c.target)) {
            expect_no_surprise(textbook_parts(c.ray, *cylinder));
            expect_no_surprise(stable_parts(c.ray, *cylinder));
            expect_no_surprise(slabs(c.ray, *cylinder));
        }
    }
}

TEST(Answers, TreatAHitAtInfinityAsAMiss) {
    EXPECT_EQ(as_answer(Hit<float>{true, std::numeric_limits<float>::infinity()}).outcome, Outcome::miss);
    EXPECT_EQ(as_answer(Hit<float>{true, 1}).outcome, Outcome::hit);
    EXPECT_EQ(as_answer(Hit<float>{false, 1}).outcome, Outcome::miss);
}

/// Checks the methods' answers for a case in whole numbers, where every formula is exact.
template <template <class> class Problem>
void expect_all(const std::vector<Method<Problem>>& methods, const Rays<Problem>& rays, const Answer& expected) {
    for (const auto& method : methods) {
        SCOPED_TRACE(method.name());
        const Answer answer = method.judge(rays, 1).front();
        EXPECT_EQ(answer.outcome, expected.outcome);
        EXPECT_NEAR(answer.t, expected.t, 1e-6);
    }
}

using PF = Vec3<float>;
using PD = Vec3<double>;

Rays<SphereProblem> sphere_ray(const P& origin, const P& direction, double radius) {
    const SphereCase c{{origin, direction}, {P(0, 0, 0), radius}};
    return {{{{PF(origin), PF(direction)}, {PF(0, 0, 0), static_cast<float>(radius)}}}, {c}};
}
Rays<TriangleProblem> triangle_ray(const P& origin, const P& direction) {
    const P A(0, -2, 2);
    const P B(2, 2, 2);
    const P C(-2, 2, 2);
    return {{{{PF(origin), PF(direction)}, {PF(A), PF(B), PF(C)}}}, {{{origin, direction}, {A, B, C}}}};
}

TEST(Methods, FollowOnePolicyForSpheres) {
    const auto methods = sphere_methods();
    expect_all(methods, sphere_ray({0, 0, 10}, {0, 0, -3}, 1), {Outcome::hit, 3});
    expect_all(methods, sphere_ray({0, 0, 0}, {0, 0, -1}, 2), {Outcome::hit, 2});
    expect_all(methods, sphere_ray({0, 0, 5}, {0, 0, 1}, 1), {Outcome::miss});
    expect_all(methods, sphere_ray({0, 3, 5}, {0, 0, -1}, 1), {Outcome::miss});
    expect_all(methods, sphere_ray({3, 4, 100}, {0, 0, -1}, 5), {Outcome::hit, 100});
    expect_all(methods, sphere_ray({3, 4, 0}, {0, 0, -1}, 5), {Outcome::hit, 0});
}

TEST(Methods, FollowOnePolicyForCylinders) {
    const auto expect = [](const P& origin, const P& direction, const Answer& expected) {
        const CylinderCase c{{origin, direction}, {P(0, 0, 0), 5, 4}};
        expect_all(cylinder_methods(), {{in_floats(c)}, {c}}, expected);
    };
    expect({-9, 1, 0}, {1, 0, 0}, {Outcome::hit, 4});
    expect({3, 6, 1}, {0, -2, 0}, {Outcome::hit, 2});
    expect({-9, 6, 0}, {2, -1, 0}, {Outcome::hit, 4});  // the top
    expect({-9, 6, 0}, {1, -1, 0}, {Outcome::hit, 4});  // its rim
    expect({1, 1, 1}, {0, -1, 0}, {Outcome::hit, 3});   // from inside to the bottom
    expect({-3, 1, 0}, {1, 0, 0}, {Outcome::hit, 8});
    expect({5, 1, -3}, {0, 0, 1}, {Outcome::hit, 3});  // a tangent
    expect({-5, 0, 0}, {1, 0, 0}, {Outcome::hit, 0});
    expect({-9, 3, 0}, {1, 0, 0}, {Outcome::miss});
    expect({4, 6, 4}, {0, -1, 0}, {Outcome::miss});
    expect({3, 6, 4}, {0, -1, 0}, {Outcome::miss});  // along the side
    expect({0, 3, 0}, {0, 1, 0}, {Outcome::miss});
}

TEST(Methods, FollowOnePolicyForTriangles) {
    const auto methods = triangle_methods();
    expect_all(methods, triangle_ray({0, 0, 5}, {0, 0, -2}), {Outcome::hit, 1.5});
    expect_all(methods, triangle_ray({0, 0, 2}, {0, 0, -1}), {Outcome::hit, 0});
    expect_all(methods, triangle_ray({0, -2, 5}, {0, 0, -1}), {Outcome::hit, 3});
    expect_all(methods, triangle_ray({1, 2, 5}, {0, 0, -1}), {Outcome::hit, 3});
    expect_all(methods, triangle_ray({0, 0, 1}, {0, 0, -1}), {Outcome::miss});
    expect_all(methods, triangle_ray({2, 0, 5}, {0, 0, -1}), {Outcome::miss});
    expect_all(methods, triangle_ray({-5, 0, 3}, {1, 0, 0}), {Outcome::miss});
    expect_all(methods, triangle_ray({-5, 0, 2}, {1, 0, 0}), {Outcome::miss});
}

}  // namespace
