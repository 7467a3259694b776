#include "tests/given/hard_cases.h"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>

#include "reference/accuracy/rays/truth.h"
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

/// One unit of the last digit quoted: "9.5e-20" is quoted to 1e-21. Whole numbers and short decimals are exact
/// nevertheless; the comparison with the fractions shows that.
double quoted_unit(std::string_view text) {
    const std::size_t e = text.find('e');
    const std::string_view mantissa = text.substr(0, e);
    const std::size_t point = mantissa.find('.');
    const int decimals = point == std::string_view::npos ? 0 : static_cast<int>(mantissa.size() - point - 1);
    int exponent = 0;
    if (e != std::string_view::npos) std::from_chars(text.data() + e + 1, text.data() + text.size(), exponent);
    return std::pow(10.0, exponent - decimals);
}

void expect_quoted(double given, std::string_view quoted) {
    if (quoted.empty()) return;
    double expected = 0;
    std::from_chars(quoted.data(), quoted.data() + quoted.size(), expected);
    EXPECT_NEAR(given, expected, quoted_unit(quoted));
    EXPECT_FALSE(given == 0 && std::signbit(given)) << "negative zero";
}

TEST(HardCases, SpheresAreDecidedAndMeasured) {
    for (const auto& c : hard_cases::sphere_cases()) {
        SCOPED_TRACE(c.id);
        const SphereHit given = intersect(c.ray, c.sphere);
        EXPECT_EQ(given.result, c.result);
        if (c.result == SphereResult::miss || c.result == SphereResult::invalid) continue;
        expect_quoted(given.t, c.t);
        EXPECT_TRUE(truth::is_within_one_ulp(given.t, truth::sphere(c.ray, c.sphere).t()));
    }
}

TEST(HardCases, TrianglesAreDecidedAndMeasured) {
    for (const auto& c : hard_cases::triangle_cases()) {
        SCOPED_TRACE(c.id);
        const TriangleHit given = intersect(c.ray, c.triangle);
        EXPECT_EQ(given.result, c.result);
        if (c.result != TriangleResult::hit) continue;
        expect_quoted(given.t, c.t);
        expect_quoted(given.u, c.u);
        expect_quoted(given.v, c.v);
        const truth::TriangleTruth truth = truth::triangle(c.ray, c.triangle);
        EXPECT_TRUE(truth::is_within_one_ulp(given.t, truth::real(truth.t)));
        EXPECT_TRUE(truth::is_within_one_ulp(given.u, truth::real(truth.u)));
        EXPECT_TRUE(truth::is_within_one_ulp(given.v, truth::real(truth.v)));
    }
}

TEST(HardCases, H36_TheRayMeetsTheEdgeExactly) {
    // u + v = 1 in fractions: P = (0.3f, 2) lies on B-C, so w = 0, and the oracle's own u and v must say so.
    for (const auto& c : hard_cases::triangle_cases()) {
        if (c.id != "H36") continue;
        const truth::TriangleTruth truth = truth::triangle(c.ray, c.triangle);
        EXPECT_EQ(truth.u + truth.v, 1);
        EXPECT_EQ(decide(c.ray, c.triangle), TriangleResult::hit);
    }
}

First first_among(const Ray<double>& ray, const std::vector<Sphere<double>>& spheres,
                  const std::vector<Triangle<double>>& triangles) {
    Cast cast;
    cast_ray(ray, {spheres, triangles}, cast);
    return cast.first;
}

TEST(HardCases, H50_H52_OneUlpNearerBreaksATie) {
    using P = Vec3<double>;
    const Ray<double> ray{P(3, 0, 24), P(0, 0, -3)};
    const Sphere<double> sphere{P(0, 0, 0), 5};
    const auto at = [](double z) { return Triangle<double>{P(-4, -4, z), P(10, -4, z), P(3, 8, z)}; };
    const auto nearer = static_cast<double>(std::nextafter(4.0F, 5.0F));
    const auto farther = static_cast<double>(std::nextafter(4.0F, 3.0F));
    EXPECT_EQ(first_among(ray, {sphere}, {at(4)}).object, FirstObject::tie);
    EXPECT_EQ(first_among(ray, {sphere}, {at(nearer)}).object, FirstObject(Subject::triangle));
    EXPECT_EQ(first_among(ray, {sphere}, {at(farther)}).object, FirstObject(Subject::sphere));
    EXPECT_EQ(first_among(ray, {sphere}, {at(std::nextafter(4.0, 5.0))}).object, FirstObject(Subject::triangle));
    EXPECT_EQ(first_among(ray, {sphere}, {at(std::nextafter(4.0, 3.0))}).object, FirstObject(Subject::sphere));
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
