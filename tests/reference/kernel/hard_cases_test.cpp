// The catalog under every set of flags; what is hard beyond it follows.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "reference/accuracy/rays/truth.h"
#include "reference/hard_cases/answers.h"
#include "reference/kernel/sphere.h"
#include "reference/kernel/triangle.h"
#include "reference/stages/sphere.h"
#include "tests/given/ulp.h"

namespace {

namespace truth = reference::accuracy::truth;

using namespace reference::kernel;
using reference::FirstObject;
using reference::Sphere;
using reference::Subject;
using reference::Triangle;
using reference::Vec3;

using reference::hard_cases::Answer;
using reference::hard_cases::Arithmetic;
using reference::hard_cases::Case;
using reference::hard_cases::SphereAndTriangle;

void expect_quoted(const Answer& given, const Case& hard) {
    ASSERT_EQ(given.numbers.empty(), hard.numbers.empty());
    for (std::size_t i = 0; i < hard.numbers.size(); ++i) {
        EXPECT_FALSE(given.numbers[i] == 0 && std::signbit(given.numbers[i])) << "negative zero";
        if (hard.numbers[i].empty()) continue;
        const auto [value, unit] = reference::hard_cases::quoted(hard.numbers[i]);
        EXPECT_NEAR(given.numbers[i], value, unit);
    }
}

/// The true numbers, by fractions.
std::vector<truth::Real> truths(const Ray<double>& ray, const Sphere<double>& sphere) {
    return {truth::sphere(ray, sphere).t()};
}
std::vector<truth::Real> truths(const Ray<double>& ray, const Triangle<double>& triangle) {
    const truth::TriangleTruth truth = truth::triangle(ray, triangle);
    return {truth::real(truth.t), truth::real(truth.u), truth::real(truth.v)};
}
template <class Other>
std::vector<truth::Real> truths(const Ray<double>& /*ray*/, const Other& /*target*/) {
    return {};
}

TEST(HardCases, AreDecidedAndMeasured) {
    for (const Case& hard : reference::hard_cases::cases()) {
        SCOPED_TRACE(hard.id);
        const Answer given = answer(hard, Arithmetic::certified);
        EXPECT_EQ(given.decision, hard.decision);
        EXPECT_TRUE(is_right(hard, given));
        expect_quoted(given, hard);
        if (given.numbers.empty()) continue;
        const auto exact = std::visit([&](const auto& target) { return truths(hard.ray, target); }, hard.target);
        for (std::size_t i = 0; i < exact.size(); ++i)
            EXPECT_TRUE(truth::is_within_one_ulp(given.numbers[i], exact[i])) << i;
    }
}

/// The exact level without the filter, which has decided some of the cases above.
TEST(HardCases, AreDecidedAlikeWithoutTheFilter) {
    for (const Case& hard : reference::hard_cases::cases()) {
        SCOPED_TRACE(hard.id);
        if (const auto* sphere = std::get_if<Sphere<double>>(&hard.target)) {
            EXPECT_EQ(decide(hard.ray, *sphere), decide_exactly(hard.ray, *sphere));
        }
        if (const auto* triangle = std::get_if<Triangle<double>>(&hard.target)) {
            EXPECT_EQ(decide(hard.ray, *triangle), decide_exactly(hard.ray, *triangle));
        }
    }
}

/// A catalog that every arithmetic answers rightly would show nothing.
TEST(HardCases, AreTooHardForFloatAndSomeForDouble) {
    std::vector<std::string_view> wrong_in_float, wrong_in_double;
    for (const Case& hard : reference::hard_cases::cases()) {
        if (!is_right(hard, answer(hard, Arithmetic::float_))) wrong_in_float.push_back(hard.id);
        if (!is_right(hard, answer(hard, Arithmetic::double_))) wrong_in_double.push_back(hard.id);
    }
    EXPECT_THAT(wrong_in_float, testing::IsSupersetOf({"H13", "H27", "H46", "H56 1e8"}));
    EXPECT_THAT(wrong_in_double, testing::Contains("H31 R=0"));
    EXPECT_LT(wrong_in_double.size(), wrong_in_float.size());
}

TEST(HardCases, NeedFiveRightDigits) {
    const Case& far = *std::ranges::find(reference::hard_cases::cases(), "H8", &Case::id);
    EXPECT_TRUE(is_right(far, {"hit", {99.9985}}));
    EXPECT_FALSE(is_right(far, {"hit", {99.9965}}));
    EXPECT_FALSE(is_right(far, {"miss", {}}));
    EXPECT_FALSE(is_right(far, {"hit", {std::nan("")}}));
}

TEST(HardCases, H36_TheRayMeetsTheEdgeExactly) {
    // u + v = 1 in fractions: P = (0.3f, 2) lies on B-C, so w = 0, and the oracle's own u and v must say so.
    const Case& edge = *std::ranges::find(reference::hard_cases::cases(), "H36", &Case::id);
    const truth::TriangleTruth truth = truth::triangle(edge.ray, std::get<Triangle<double>>(edge.target));
    EXPECT_EQ(truth.u + truth.v, 1);
}

First first_among(const Ray<double>& ray, const std::vector<Sphere<double>>& spheres,
                  const std::vector<Triangle<double>>& triangles) {
    Cast cast;
    cast_ray(ray, {spheres, triangles}, cast);
    return cast.first;
}

TEST(HardCases, H18_H19_H20_TheOpenPolicyRequiresAPositiveRoot) {
    using namespace reference;
    const auto open = [](const Vec3<double>& V) {
        const auto quadratic = sphere_quadratic(Vec3<double>(0, 0, 2), V, Sphere<double>{Vec3<double>(0, 0, 0), 2});
        return root(quadratic, choose_root(quadratic, Boundary::positive));
    };
    EXPECT_EQ(open(Vec3<double>(0, 0, -1)), 4.0);
    EXPECT_EQ(open(Vec3<double>(0, 0, 1)), std::nullopt);
    EXPECT_EQ(open(Vec3<double>(1, 0, 0)), std::nullopt);
}

TEST(HardCases, DoublesAtTheEndsOfTheirRangeNeitherOverflowNorUnderflow) {
    using P = Vec3<double>;
    for (const double scale : {1e-300, 0x1p-1060, 1e-170, 1e170, 1e300}) {
        SCOPED_TRACE(scale);
        const Ray<double> ray{P(0, 0, 10 * scale), P(0, 0, -1)};
        const SphereHit sphere = intersect(ray, Sphere<double>{P(0, 0, 0), scale});
        EXPECT_EQ(sphere.result, SphereResult::hit);
        EXPECT_DOUBLE_EQ(sphere.t, 10 * scale - scale);
        const TriangleHit triangle =
            intersect(ray, Triangle<double>{P(-scale, -scale, 0), P(scale, -scale, 0), P(0, scale, 0)});
        EXPECT_EQ(triangle.result, TriangleResult::hit);
        EXPECT_DOUBLE_EQ(triangle.t, 10 * scale);
        EXPECT_EQ(triangle.v, 0.5);
        EXPECT_EQ(first_among(ray, {{P(0, 0, 0), scale}}, {{P(-scale, -scale, 0), P(scale, -scale, 0), P(0, scale, 0)}})
                      .object,
                  FirstObject(Subject::sphere));
    }
}

TEST(HardCases, SquaresThatPartlyUnderflowDoNotDecide) {
    // |f|² = 0.98 s² and R² = 0.81 s², but s² is the smallest double: rounded to it they are 0 and 1.
    using P = Vec3<double>;
    const double s = 0x1p-537;
    const Ray<double> away{P(0.7 * s, 0.7 * s, 0), P(1, 1, 0)};
    EXPECT_EQ(decide(away, Sphere<double>{P(0, 0, 0), 0.9 * s}), SphereResult::miss);
}

}  // namespace
