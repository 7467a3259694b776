// Hits too close for doubles, and starts on a triangle, agree with exact geometry.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "reference/accuracy/rays/random_numbers.h"
#include "reference/numbers/rational.h"
#include "reference/render/visibility.h"
#include "tests/given/render/scenes.h"
#include "tests/reference/render/scene_parts.h"

namespace {

using namespace reference;
using namespace reference::render;
using accuracy::Random;
using scenes::above;
using scenes::level_at;
using scenes::level_at_5;
using Point = Vec3<double>;

constexpr std::uint64_t start_seed = 20211101;

/// The start is exact for any requested point, even outside the triangle, as start.h promises.
TEST(StartOn, IsExactlyOnItsTriangle) {
    Random random(start_seed);
    int off = 0;
    for (int i = 0; i < 1000; ++i) {
        const Triangle<double> corners{random.point(2), random.point(2), random.point(2)};
        const kernel::PreparedTriangle triangle(corners);
        const Start start = start_on(triangle, 0, random.point(3));
        EXPECT_TRUE(start.u >= 0 && start.v >= 0 && start.u + start.v <= 1) << start.u << ' ' << start.v;
        EXPECT_EQ(start.u * 0x1p52, std::trunc(start.u * 0x1p52));
        EXPECT_EQ(start.v * 0x1p52, std::trunc(start.v * 0x1p52));
        Rational distance = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const auto exact = [&](const Point& p) { return Rational(p[axis]); };
            const Rational A = exact(corners.A);
            const Rational on =
                A + Rational(start.u) * (exact(corners.B) - A) + Rational(start.v) * (exact(corners.C) - A);
            distance += abs(on - exact(start.point));
        }
        EXPECT_LE(distance, Rational(start.uncertainty));
        off += distance > 0 ? 1 : 0;
    }
    EXPECT_GT(off, 500) << "without uncertainty it would be wrong";
}

/// The second triangle surrounds the triangle that the rays start on, in the same plane 3x + 5y + 7z = 0.
TEST(FirstHit, IgnoresThePlaneOfTheTriangleItStartsOn) {
    Random random(start_seed);
    const PreparedScene scene =
        scenes::prepared(scenes::with_camera(scenes::triangle("[[0, 0, 0], [7, 0, -3], [0, 7, -5]]") +
                                             scenes::triangle("[[-63, -63, 72], [140, 0, -60], [0, 140, -100]]")));
    for (int i = 0; i < 2000; ++i) {
        const Point near(random.between(0, 7), random.between(0, 7), 0);
        const Start start = start_on(scene.triangles[0], 0, near);
        EXPECT_FALSE(first_hit(scene, {{start.point, random.point(1)}, start}).is_hit()) << i;
    }
}

std::string ball_at(const std::string& z, const std::string& radius = "1") {
    return scenes::sphere(fmt::format("[0.125, 0.25, {}]", z), radius);
}

/// The first hits of rays straight down: from z = 4, and from a triangle at z = 5.
std::pair<std::uint32_t, std::uint32_t> objects_below(const std::string& objects) {
    const PreparedScene scene = scenes::prepared(scenes::with_camera(objects + level_at_5));
    const Start start = start_on(scene.triangles.back(), scene.object_count() - 1, above);
    const Hit of_camera = first_hit(scene, {{above - Point(0, 0, 1), Point(0, 0, -1)}});
    const Hit of_surface = first_hit(scene, {{start.point, Point(0, 0, -1)}, start});
    EXPECT_TRUE(of_camera.is_hit() && of_surface.is_hit());
    return {of_camera.object, of_surface.object};
}

TEST(FirstHit, IsTheNearerOfTwoTooCloseForDoubles) {
    const auto object = [](std::uint32_t i) { return std::pair(i, i); };
    EXPECT_EQ(objects_below(level_at("1e-10") + level_at("0")), object(0));
    EXPECT_EQ(objects_below(level_at("0") + level_at("1e-10")), object(1));
    EXPECT_EQ(objects_below(ball_at("1e-10") + ball_at("0")), object(0));
    EXPECT_EQ(objects_below(ball_at("0") + ball_at("1e-10")), object(1));
    EXPECT_EQ(objects_below(ball_at("0") + level_at("0.9999999999")), object(0));
    EXPECT_EQ(objects_below(ball_at("0") + level_at("1.0000000001")), object(1));
}

TEST(FirstHit, IsTheFirstListedOfTwoAtTheSameT) {
    const std::string one = scenes::triangle("[[-9, -9, 1], [9, -9, 1], [0, 9, 1]]");
    const std::string other = scenes::triangle("[[-8, -8, 1], [8, -8, 1], [0, 8, 1]]");
    EXPECT_EQ(objects_below(one + other), std::pair(0U, 0U));
    EXPECT_EQ(objects_below(other + one + one), std::pair(0U, 0U));
    EXPECT_EQ(objects_below(ball_at("0") + one).first, 0U);
}

/// The lamp is at z = 1. An object 1e-10 before the lamp casts a shadow, an object 1e-10 behind it does not.
TEST(Shadows, EndExactlyAtTheLamp) {
    const auto is_dark = [](const std::string& object) {
        const PreparedScene scene = scenes::prepared(scenes::with_camera(object + level_at_5));
        const Start start = start_on(scene.triangles.back(), scene.object_count() - 1, above);
        return is_blocked(scene, {{start.point, Point(0, 0, -4)}, start}, 1);
    };
    const auto turned_level_at = [](const std::string& z) {
        return scenes::triangle(fmt::format("[[9, -9, {0}], [-9, -9, {0}], [0, 9, {0}]]", z));
    };
    EXPECT_TRUE(is_dark(level_at("1.0000000001")));
    EXPECT_FALSE(is_dark(level_at("0.9999999999")));
    EXPECT_TRUE(is_dark(turned_level_at("1.0000000001")));
    EXPECT_FALSE(is_dark(turned_level_at("0.9999999999")));
    EXPECT_TRUE(is_dark(ball_at("0.0000000001")));
    EXPECT_FALSE(is_dark(ball_at("-0.0000000001")));
    // The ray starts inside the ball, at its far side.
    EXPECT_TRUE(is_dark(ball_at("5", "3.9999999999")));
    EXPECT_FALSE(is_dark(ball_at("5", "4.0000000001")));
}

}  // namespace
