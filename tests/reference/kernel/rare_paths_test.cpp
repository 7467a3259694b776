// Rays that take a path of the kernel which random rays hardly ever take, made for it by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "reference/kernel/first.h"

namespace reference::kernel {
namespace {

using P = Vec3<double>;

// c = |S|² + |C|² - 2 S.C - R² with S = (2, p, 0), C = (2^-300, 0, 0) and R = 2 is p² - 2^-298 + 2^-600. No whole
// number of bits holds all of it. With p² = 1.125 2^-299 the ray starts inside; with S.C in place of 2 S.C it would
// start outside and point away.
TEST(RarePath, CountsTheMixedTermOfCTwice) {
    const P start(2, 0x1.8p-150, 0);
    for (const double scale : {1.0, 0x1p-40, 0x1p60}) {
        const Ray<double> ray{scaled(start, scale), P(1, 0, 0)};
        const Sphere<double> sphere{P(0x1p-300 * scale, 0, 0), 2 * scale};
        EXPECT_EQ(decide(ray, sphere), SphereResult::hit) << scale;
        // From the other side of the center, every term has the other sign but p²: outside.
        const Ray<double> other{scaled(P(-2, start.y, 0), scale), P(-1, 0, 0)};
        EXPECT_EQ(decide(other, sphere), SphereResult::miss) << scale;
    }
}

// x² + y² - R² = -1 for x = 2^47, y = 2^24, R = 2^47 + 1: a ray along z cuts the sphere at z = 1 and -1. With a
// direction of more than a few bits, the discriminant is lost among squares that no two doubles hold.
TEST(RarePath, FindsTheRootWhereTheDiscriminantIsLostAmongSquares) {
    for (const double step : {3.0, 5.0, 7.0, 13.0, 101.0, 1021.0, 65537.0}) {
        const double z = step * std::floor(0x1p52 / step) + 1;
        const Ray<double> ray{P(0x1p47, 0x1p24, z), P(0, 0, -step)};
        const SphereHit hit = intersect(ray, Sphere<double>{P(0, 0, 0), 0x1p47 + 1});
        EXPECT_EQ(hit.result, SphereResult::hit) << step;
        EXPECT_EQ(hit.t, (z - 1) / step) << step;
    }
}

TEST(RarePath, ComparesATriangleWithTheFarRoot) {
    const Ray<double> ray{P(0, 0, 0), P(0, 0, -2)};
    const Sphere<double> sphere{P(0, 0, -1), 4};
    const auto first = [&](double z) {
        return first_of(ray, sphere, Triangle<double>{P(-9, -9, z), P(9, -9, z), P(0, 9, z)}).kind;
    };
    EXPECT_EQ(first(-5), FirstHit::Kind::tie) << "from inside, the sphere is met at z = -5";
    EXPECT_EQ(first(std::nextafter(-5.0, 0)), FirstHit::Kind::triangle);
    EXPECT_EQ(first(std::nextafter(-5.0, -9)), FirstHit::Kind::sphere);
    EXPECT_EQ(order_exactly(ray, sphere, Triangle<double>{P(-9, -9, -5), P(9, -9, -5), P(0, 9, -5)}),
              std::partial_ordering::equivalent);
}

// Two triangles that are met within one unit in the last place of each other, turned either way: what is known of t in
// double does not tell which is nearer.
TEST(RarePath, OrdersTwoTrianglesThatAreTurnedEitherWay) {
    const Ray<double> ray{P(0, 0, 3), P(0, 0, -1)};
    const auto triangle = [](double z, bool turned) {
        const P a(-9, -9, z), b(9, -9, z), c(0, 9, z);
        return turned ? Triangle<double>{b, a, c} : Triangle<double>{a, b, c};
    };
    const double far = 1, near = std::nextafter(1.0, 2.0);
    Cast cast;
    for (const bool one : {false, true}) {
        for (const bool other : {false, true}) {
            cast_ray(ray, {{}, {triangle(far, one), triangle(near, other)}}, cast);
            EXPECT_EQ(cast.first.index, 1U);
            cast_ray(ray, {{}, {triangle(near, one), triangle(far, other)}}, cast);
            EXPECT_EQ(cast.first.index, 0U);
            EXPECT_EQ(cast.first.object, FirstObject(Subject::triangle));
            cast_ray(ray, {{}, {triangle(far, one), triangle(far, other)}}, cast);
            EXPECT_EQ(cast.first.object, FirstObject::tie);
        }
    }
}

// The ray starts on the sphere, where it enters or leaves it, and in the triangle's plane: both are met at t = 0.
TEST(RarePath, OrdersObjectsThatAreHitAtTheStart) {
    const Sphere<double> sphere{P(0, 0, 0), 1};
    const auto first = [&](double step, double z) {
        const Triangle<double> triangle{P(-9, -9, z), P(9, -9, z), P(0, 9, z)};
        const FirstHit::Kind kind = first_of(Ray<double>{P(0, 0, 1), P(0, 0, step)}, sphere, triangle).kind;
        Cast cast;
        cast_ray({P(0, 0, 1), P(0, 0, step)}, {{sphere}, {triangle}}, cast);
        EXPECT_EQ(cast.first.object, kind == FirstHit::Kind::tie ? FirstObject::tie : FirstObject(Subject::sphere));
        return kind;
    };
    EXPECT_EQ(first(-1, 1), FirstHit::Kind::tie);
    EXPECT_EQ(first(1, 1), FirstHit::Kind::tie);
    EXPECT_EQ(first(-1, std::nextafter(1.0, 0.0)), FirstHit::Kind::sphere);
    EXPECT_EQ(first(1, std::nextafter(1.0, 2.0)), FirstHit::Kind::sphere);
}

}  // namespace
}  // namespace reference::kernel
