// The renderer's hits with cylinders agree with the handout's own words in fractions.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "reference/accuracy/rays/random_numbers.h"
#include "reference/accuracy/rays/truth.h"
#include "reference/render/visibility.h"
#include "tests/given/cases.h"
#include "tests/given/render/scenes.h"
#include "tests/reference/render/scene_parts.h"

namespace {

namespace truth = reference::accuracy::truth;

using namespace reference;
using namespace reference::render;
using accuracy::Random;
using kernel::CylinderPart;
using scenes::above;
using scenes::level_at;
using scenes::level_at_5;
using Place = Vec3<double>;

constexpr std::uint64_t cylinder_seed = 20241101;

/// In halves, so that rays often meet the rim, run along a surface or start on it.
Cylinder<double> small_cylinder(Random& random) {
    return {scaled(random.whole_point(2), 0.5), 0.5 * random.whole(1, 5), 0.5 * random.whole(1, 6)};
}
std::string text_of(const Cylinder<double>& cylinder) {
    const Place& C = cylinder.center;
    return scenes::cylinder(fmt::format("[{}, {}, {}]", C.x, C.y, C.z), fmt::format("{}", cylinder.radius),
                            fmt::format("{}", cylinder.height));
}
/// Half of the rays go towards a point in or near the cylinder; a fourth of them have a few bits.
Place some_direction(Random& random, const Place& start, const Cylinder<double>& cylinder) {
    Place direction(0, 0, 0);
    while (direction == Place(0, 0, 0)) {
        const Place target = cylinder.center + scaled(random.whole_point(2), 0.5);
        direction = random.whole(0, 1) == 0   ? Place(target - start)
                    : random.whole(0, 1) == 0 ? random.direction()
                                              : scaled(random.whole_point(3), 0.5);
    }
    return direction;
}

void expect_hit(const Hit& given, const std::optional<truth::CylinderTruth>& hit) {
    ASSERT_EQ(given.is_hit(), hit.has_value());
    if (!hit) return;
    EXPECT_EQ(given.part, hit->part);
    const auto t = static_cast<double>(hit->t.value());
    EXPECT_NEAR(given.t, t, 0x1p-26 * t);
}

TEST(CylinderHit, IsThatOfTheHandoutsPartsForCameraRays) {
    Random random(cylinder_seed);
    std::uint64_t hits = 0;
    for (std::uint64_t i = 0; i < cases(4000); ++i) {
        SCOPED_TRACE(i);
        const Cylinder<double> cylinder = small_cylinder(random);
        PreparedScene scene = scenes::prepared(scenes::with_camera(text_of(cylinder)));
        const Place start = random.whole(0, 1) == 0 ? random.point(4) : scaled(random.whole_point(6), 0.5);
        const Ray ray{{start, some_direction(random, start, cylinder)}};
        for (const Boundary boundary : {Boundary::positive, Boundary::nonnegative}) {
            scene.boundary = boundary;
            const auto hit = truth::cylinder(ray.ray, cylinder, boundary);
            hits += hit ? 1 : 0;
            expect_hit(hit_object(scene, ray, 0), hit);
        }
    }
    std::cout << hits << " of " << 2 * cases(4000) << " rays hit\n";
    EXPECT_GT(hits, cases(4000) / 4);
}

/// The point of the triangle whose coordinates a start has, rounded.
truth::Point exact_start(const Triangle<double>& triangle, const Start& start) {
    const auto along = [&](int axis) {
        const truth::Rational a(triangle.A[axis]), b(triangle.B[axis]), c(triangle.C[axis]);
        return truth::Rational(a + truth::Rational(start.u) * (b - a) + truth::Rational(start.v) * (c - a));
    };
    return {along(0), along(1), along(2)};
}

/// From the exact point of a triangle whose coordinates are rounded: what is decided is about the exact point.
TEST(CylinderHit, IsThatOfTheHandoutsPartsForRaysFromATriangle) {
    Random random(cylinder_seed + 1);
    std::uint64_t hits = 0;
    std::uint64_t rounded = 0;
    for (std::uint64_t i = 0; i < cases(3000); ++i) {
        SCOPED_TRACE(i);
        const Cylinder<double> cylinder = small_cylinder(random);
        const bool in_caps_plane = random.whole(0, 2) == 0;
        const double y = cylinder.center.y + cylinder.height / 2;
        Triangle<double> corners{scaled(random.whole_point(9), 0.5), random.point(3), random.point(5)};
        if (in_caps_plane) corners.A.y = corners.B.y = corners.C.y = y;
        const Place& A = corners.A;
        const Place& B = corners.B;
        const Place& C = corners.C;
        const PreparedScene scene = scenes::prepared(
            scenes::with_camera(scenes::triangle(fmt::format("[[{}, {}, {}], [{}, {}, {}], [{}, {}, {}]]", A.x, A.y,
                                                             A.z, B.x, B.y, B.z, C.x, C.y, C.z)) +
                                text_of(cylinder)));
        if (scene.triangles.empty()) continue;
        const Start start = start_on(scene.triangles[0], 0, random.point(4));
        const Ray ray{{start.point, some_direction(random, start.point, cylinder)}, start};
        const truth::Point S = exact_start(corners, start);
        rounded += S.x != start.point.x || S.y != start.point.y || S.z != start.point.z ? 1 : 0;
        const auto hit =
            truth::cylinder(S, truth::exact(ray.ray.direction), truth::exact(cylinder), Boundary::positive);
        hits += hit ? 1 : 0;
        expect_hit(hit_object(scene, ray, 1), hit);
    }
    std::cout << hits << " of " << cases(3000) << " rays hit, " << rounded << " starts were rounded\n";
    EXPECT_GT(hits, cases(3000) / 15);
    EXPECT_GT(rounded, cases(3000) / 3);
}

/// At coordinates of a million a start in doubles is off by up to 1e-10. The ray passes the top's plane, or seen from
/// above the tube, at such a distance.
TEST(CylinderHit, IsDecidedByTheExactStartOnATriangle) {
    constexpr double size = 1e6;
    Random random(cylinder_seed + 4);
    std::uint64_t decided_otherwise = 0;
    for (std::uint64_t i = 0; i < cases(400); ++i) {
        const Triangle<double> corners{random.point(size), random.point(size), random.point(size)};
        const Start start = start_on(kernel::PreparedTriangle(corners), 0, random.point(size));
        const Place& S = start.point;
        const double off = 2e-10 * random.number();
        PreparedScene scene{};
        scene.triangles.emplace_back(corners);
        scene.cylinders.push_back(i % 2 == 0 ? Cylinder<double>{Place(S.x, S.y - 1, S.z - 5), 1, 2 + off}
                                             : Cylinder<double>{Place(S.x + 1, S.y, S.z - 5), 1 + off, 2});
        const Ray ray{{S, Place(0, 0, -1)}, start};
        const auto hit = truth::cylinder(exact_start(corners, start), {0, 0, -1}, truth::exact(scene.cylinders[0]),
                                         Boundary::positive);
        const auto of_rounded = truth::cylinder(ray.ray, scene.cylinders[0], Boundary::positive);
        decided_otherwise += hit.has_value() != of_rounded.has_value() ? 1 : 0;
        SCOPED_TRACE(i);
        expect_hit(hit_object(scene, ray, 1), hit);
    }
    EXPECT_GT(decided_otherwise, cases(400) / 20);
}

/// A ray from a cylinder's surface goes through the inside to the surface, or stays outside and never meets it again.
TEST(CylinderHit, FindsTheWayOutOfItsOwnCylinder) {
    Random random(cylinder_seed + 2);
    std::array<std::uint64_t, 3> left_by{};
    for (std::uint64_t i = 0; i < cases(3000); ++i) {
        SCOPED_TRACE(i);
        const Cylinder<double> cylinder{random.point(3), random.between(0.1, 3), random.between(0.1, 3)};
        const PreparedScene scene = scenes::prepared(scenes::with_camera(text_of(cylinder)));
        const auto part = static_cast<CylinderPart>(random.whole(0, 2));
        const Place across = scaled(Place(random.number(), 0, random.number()), 0.7 * cylinder.radius);
        const Start start =
            start_on(cylinder, 0, part, cylinder.center + across + Place(0, random.between(-9, 9), 0), true);
        const Place out = normal_of(cylinder, part, start.point);
        Place V = random.direction();
        if (dot(V, out) > 0) V = -V;
        const Hit hit = hit_object(scene, {{start.point, V}, start}, 0);
        ASSERT_TRUE(hit.is_hit() && hit.from_inside);
        ++left_by[static_cast<std::size_t>(hit.part)];
        const Place end = start.point + scaled(V, hit.t) - cylinder.center;
        const double from_axis = std::hypot(end.x, end.z);
        if (hit.part == CylinderPart::tube) {
            EXPECT_NEAR(from_axis, cylinder.radius, 1e-7);
            EXPECT_LE(std::abs(end.y), cylinder.height / 2 + 1e-7);
        } else {
            EXPECT_NEAR(end.y, (hit.part == CylinderPart::top ? 0.5 : -0.5) * cylinder.height, 1e-7);
            EXPECT_LE(from_axis, cylinder.radius + 1e-7);
        }
        Start outside = start;
        outside.is_inside = false;
        EXPECT_FALSE(first_hit(scene, {{start.point, -V}, outside}).is_hit());
        EXPECT_FALSE(is_blocked(scene, {{start.point, -V}, outside}, HUGE_VAL));
    }
    for (const std::uint64_t count : left_by) EXPECT_GT(count, cases(3000) / 30);
}

/// Rounding may point a grazing ray outside. It then leaves the cylinder where it starts.
TEST(CylinderHit, IsAtTheStartForARayThatPointsOutOfItsOwnCylinder) {
    const PreparedScene scene = scenes::prepared(scenes::with_camera(scenes::cylinder("[0, 0, 0]", "1", "2")));
    for (const CylinderPart part : {CylinderPart::tube, CylinderPart::top, CylinderPart::bottom}) {
        const Start start = start_on(scene.cylinders[0], 0, part, Place(0.5, 0, 0.25), true);
        const Hit hit = hit_object(scene, {{start.point, normal_of(scene.cylinders[0], part, start.point)}, start}, 0);
        EXPECT_TRUE(hit.is_hit());
        EXPECT_EQ(hit.t, 0);
        EXPECT_EQ(hit.part, part);
    }
}

TEST(StartOn, KeepsToAPartOfTheCylinder) {
    const Cylinder<double> cylinder{Place(1, 2, 3), 2, 1};
    EXPECT_EQ(start_on(cylinder, 0, CylinderPart::top, Place(1.5, 9, 3), false).point, Place(1.5, 2.5, 3));
    EXPECT_EQ(start_on(cylinder, 0, CylinderPart::bottom, Place(1.5, 9, 3), false).point, Place(1.5, 1.5, 3));
    EXPECT_EQ(start_on(cylinder, 0, CylinderPart::tube, Place(1.5, 2.5000001, 3), false).point, Place(3, 2.5, 3));
    EXPECT_EQ(start_on(cylinder, 0, CylinderPart::tube, Place(1, 1.4999999, 9), false).point, Place(1, 1.5, 5));
}

/// The colors of normals where the camera looks at a tube, from above on a top and from below on a bottom.
TEST(CylinderHit, HasTheNormalOfItsPart) {
    const auto color_at = [](const std::string& center) {
        const PreparedScene scene = scenes::prepared(scenes::with_camera(scenes::cylinder(center, "1", "1")));
        return scenes::colors_of(scene, {}).at(15 * 40 + 20);  // beside and above the middle by half a pixel
    };
    const Color tube = color_at("[0.05, 0, 0]");
    EXPECT_NEAR(tube.x, 0.5, 2e-2);
    EXPECT_EQ(tube.y, 0.5);
    EXPECT_NEAR(tube.z, 1, 1e-3);
    // (0.05 t + 0.55)² + (4 - 2t)² = 1 has its smaller root at t = 1.61195, where N.x = 0.63060.
    const Color aside = color_at("[-0.55, 0, 0]");
    EXPECT_NEAR(aside.x, 0.81530, 1e-5);
    EXPECT_EQ(aside.y, 0.5);
    const auto from = [](const std::string& y) {
        std::string text = scenes::with_camera(scenes::cylinder("[0, 0, 0]", "1", "1"));
        text.replace(text.find("eye = [0, 0, 4]"), 15, "eye = [0, " + y + ", 0.5]");
        return scenes::colors_of(scenes::prepared(text), {}).at(15 * 40 + 20);
    };
    EXPECT_EQ(from("7"), Color(0.5, 1, 0.5));
    EXPECT_EQ(from("-7"), Color(0.5, 0, 0.5));
}

/// Its side is met at z along the ray from above(5) straight down -z: the center is 1 behind.
std::string tube_at(const std::string& z) {
    return scenes::cylinder(fmt::format("[0.125, 0, {}]", z), "1", "2");
}

std::uint32_t object_below(const std::string& objects) {
    const PreparedScene scene = scenes::prepared(scenes::with_camera(objects + level_at_5));
    const Ray ray{{above - Place(0, 0, 1), Place(0, 0, -1)}};
    const Hit nearest = first_hit(scene, ray);
    EXPECT_TRUE(nearest.is_hit());
    return nearest.object;
}

/// Objects are numbered with cylinders last, so that of two at the same t a cylinder is the second.
TEST(CylinderHit, IsOrderedWhereTwoAreTooCloseForDoubles) {
    EXPECT_EQ(object_below(tube_at("0") + tube_at("1e-10")), 2U);
    EXPECT_EQ(object_below(tube_at("1e-10") + tube_at("0")), 1U);
    EXPECT_EQ(object_below(tube_at("0") + level_at("0.9999999999")), 2U);
    EXPECT_EQ(object_below(tube_at("0") + level_at("1.0000000001")), 0U);
    EXPECT_EQ(object_below(tube_at("0") + level_at("1")), 0U);
    const auto ball_at = [](const std::string& z) { return scenes::sphere("[0.125, 0.25, " + z + "]", "1"); };
    EXPECT_EQ(object_below(tube_at("0") + ball_at("-0.0000000001")), 2U);
    EXPECT_EQ(object_below(tube_at("0") + ball_at("0.0000000001")), 0U);
    EXPECT_EQ(object_below(tube_at("0") + ball_at("0")), 0U);
}

/// A ray inside the cylinder x² + z² = 1, |y| <= 1 goes from its top to its bottom, and from one side to the other. At
/// the far end stands a triangle.
TEST(CylinderHit, IsOrderedAmongTheOthersWhereTheRayLeavesItsOwn) {
    const auto is_own_first = [](CylinderPart part, const std::string& triangle) {
        const PreparedScene scene =
            scenes::prepared(scenes::with_camera(scenes::triangle(triangle) + scenes::cylinder("[0, 0, 0]", "1", "2")));
        const Place near = part == CylinderPart::top ? Place(0.125, 1, 0.25) : Place(-1, 0.25, 0);
        const Start start = start_on(scene.cylinders[0], 1, part, near, true);
        const Place V = part == CylinderPart::top ? Place(0, -1, 0) : Place(1, 0, 0);
        const Hit nearest = first_hit(scene, {{start.point, V}, start});
        EXPECT_NEAR(nearest.t, 2, 1e-9);
        return nearest.object == 1;
    };
    const auto level = [](const std::string& y) {
        return fmt::format("[[-9, {0}, -9], [9, {0}, -9], [0, {0}, 9]]", y);
    };
    EXPECT_TRUE(is_own_first(CylinderPart::top, level("-1.0000000001")));
    EXPECT_FALSE(is_own_first(CylinderPart::top, level("-0.9999999999")));
    EXPECT_FALSE(is_own_first(CylinderPart::top, level("-1"))) << "the first listed of two at the same t";
    const auto wall = [](const std::string& x) { return fmt::format("[[{0}, -9, -9], [{0}, 9, -9], [{0}, 0, 9]]", x); };
    EXPECT_TRUE(is_own_first(CylinderPart::tube, wall("1.0000000001")));
    EXPECT_FALSE(is_own_first(CylinderPart::tube, wall("0.9999999999")));
    EXPECT_FALSE(is_own_first(CylinderPart::tube, wall("1")));
}

/// The lamp is at z = 1, at t = 1. A cylinder 1e-10 before it casts a shadow, and one 1e-10 behind it does not.
TEST(Shadows, OfACylinderEndExactlyAtTheLamp) {
    const auto is_dark = [](const std::string& object) {
        const PreparedScene scene = scenes::prepared(scenes::with_camera(object + level_at_5));
        const Start start = start_on(scene.triangles.back(), 0, above);
        return is_blocked(scene, {{start.point, Place(0, 0, -4)}, start}, 1);
    };
    EXPECT_TRUE(is_dark(tube_at("0.0000000001")));
    EXPECT_FALSE(is_dark(tube_at("-0.0000000001")));
    EXPECT_FALSE(is_dark(tube_at("0")));
}

TEST(PreparedScene, LeavesOutACylinderThatIsThereTwice) {
    const std::string one = scenes::cylinder("[0, 0, 0]", "1", "2");
    const PreparedScene scene =
        scenes::prepared(scenes::with_camera(one + one + scenes::cylinder("[0, 0, 0]", "1", "3") + one));
    EXPECT_EQ(scene.cylinders.size(), 2U);
    ASSERT_EQ(scene.notes.size(), 1U);
    EXPECT_EQ(scene.notes.front(), "2 cylinders are left out: an earlier one is the same.");
}

}  // namespace
