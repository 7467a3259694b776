// Compares light with independent formulas: Fresnel and Snell by angles, shadows by distances, mirrors by mirrored
// scenes.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reference/render/fresnel.h"
#include "reference/render/picture.h"
#include "tests/given/render/scenes.h"
#include "tests/reference/render/scene_parts.h"

namespace {

using namespace reference;
using namespace reference::render;
using scenes::colors_of;
using scenes::cylinder;
using scenes::material;
using scenes::prepared;
using scenes::sphere;
using scenes::triangle;
using scenes::with_camera;
using scenes::with_shadows;
using Point = Vec3<double>;

/// The point at z = 2 where the ray of pixel (x, y) crosses the window of with_camera().
Point on_window(std::size_t x, std::size_t y) {
    return {-2 + 4 * (static_cast<double>(x) + 0.5) / 40, -1.5 + 3 * (static_cast<double>(y) + 0.5) / 30, 2};
}

template <class Check>
void for_each_pixel(const std::vector<Color>& colors, Check check) {
    for (std::size_t y = 0; y < 30; ++y) {
        for (std::size_t x = 0; x < 40; ++x) {
            SCOPED_TRACE(fmt::format("pixel {}, {}", x, y));
            check(on_window(x, y), colors[y * 40 + x]);
        }
    }
}

void expect_near(const Color& one, const Color& other, double distance) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(one[i], other[i], distance);
}

/// Fresnel's formula with sines and tangents of the two angles, in long doubles.
long double reflected_share(long double incident, long double from, long double into) {
    const long double bent = std::asin(std::sin(incident) * from / into);
    const long double across = std::sin(incident - bent) / std::sin(incident + bent);
    const long double along = std::tan(incident - bent) / std::tan(incident + bent);
    return (across * across + along * along) / 2;
}

TEST(Fresnel, MatchesTheFormulaWithAngles) {
    for (const auto& [from, into] :
         {std::pair(1.0, 1.5), std::pair(1.5, 1.0), std::pair(1.0, 2.4), std::pair(2.0, 0.7)}) {
        for (double angle = 0.01; angle < 1.57; angle += 0.01) {
            if (std::sin(angle) * from / into >= 1) continue;
            EXPECT_NEAR(fresnel(std::cos(angle), from, into).reflected,
                        static_cast<double>(reflected_share(angle, from, into)), 1e-12)
                << angle << " from " << from << " into " << into;
        }
    }
}

TEST(Fresnel, ReflectsAllOnlyBeyondTheCriticalAngle) {
    const double critical = std::asin(1 / 1.5);
    EXPECT_TRUE(fresnel(std::cos(critical + 1e-9), 1.5, 1).is_total);
    EXPECT_FALSE(fresnel(std::cos(critical - 1e-9), 1.5, 1).is_total);
    EXPECT_EQ(fresnel(std::cos(critical + 1e-9), 1.5, 1).reflected, 1);
    EXPECT_FALSE(fresnel(0.001, 1, 1.5).is_total) << "nothing is totally reflected by what is denser";
}

TEST(Refraction, KeepsSnellsLawInThePlaneOfIncidence) {
    const Point N(0, 1, 0);
    for (double angle = 0; angle < 1.57; angle += 0.01) {
        const Point V(std::sin(angle) * 0.6, -std::cos(angle), std::sin(angle) * 0.8);
        const Fresnel split = fresnel(std::cos(angle), 1, 1.5);
        const Point bent = refracted(V, N, std::cos(angle), split.cos_refracted, 1 / 1.5);
        EXPECT_NEAR(length(bent), 1, 1e-14);
        EXPECT_NEAR(std::hypot(bent.x, bent.z) * 1.5, std::sin(angle), 1e-14);
        EXPECT_NEAR(dot(cross(V, N), bent), 0, 1e-15);
        EXPECT_LT(bent.y, 0);
    }
}

/// A camera under water, below the surface y = 5: light comes in through Snell's window, and outside the window only
/// the mirror image of the bottom is seen. The water's vertices run counter-clockwise seen from above.
TEST(Refraction, EndsAtTheCriticalAngleOfAWaterSurface) {
    const PreparedScene scene = prepared(with_camera(
        "[render]\nbackground = [1, 1, 1]\n" + material("water", "transparency = 1\nrefractive_index = 1.1") +
        triangle("[[-900, 5, 900], [900, 5, 900], [0, 5, -900]]", "water") +
        triangle("[[-9000, -30, 9000], [9000, -30, 9000], [0, -30, -9000]]")));
    int inside = 0;
    int outside = 0;
    for_each_pixel(colors_of(scene, all_effects), [&](const Point& start, const Color& color) {
        const Point V = start - Point(0, 0, 4);
        if (V.y <= 0.3) return;  // too far away
        const double sine = std::hypot(V.x, V.z) / length(V);
        if (1.1 * sine > 1) {
            ++outside;
            EXPECT_EQ(color, Color(0.5, 1, 0.5)) << "the bottom, mirrored";
        } else {
            ++inside;
            EXPECT_GT(color.x, 0.5);
        }
    });
    EXPECT_GT(inside, 0);
    EXPECT_GT(outside, 0);
}

/// Air in air is invisible, in whatever shape.
TEST(Refraction, BendsNothingForAnIndexOfOne) {
    const std::string behind = sphere("[0.3, 0.1, -2]", "1.2") + triangle("[[-9, -2, 3], [9, -2, 3], [0, -2, -30]]");
    const auto without = colors_of(prepared(with_camera(behind)), all_effects);
    const std::string air = material("air", "transparency = 1");
    for (const std::string& object :
         {sphere("[-0.2, 0, 0]", "1.1", "air"), triangle("[[-1, -1, 1], [1, -1, 1], [0, 1, 0]]", "air"),
          cylinder("[-0.2, 0.1, 0.3]", "1.1", "0.7", "air"), cylinder("[0.1, -1.5, 0.6]", "0.7", "1.3", "air")}) {
        const auto with = colors_of(prepared(with_camera(air + object + behind)), all_effects);
        for (std::size_t i = 0; i < with.size(); ++i) expect_near(with[i], without[i], 1e-9);
    }
}

/// A mirror at z = -4 shows the ball that stands behind the camera's window.
TEST(Mirrors, ShowTheMirroredScene) {
    const std::string mirror =
        material("mirror", "reflectivity = 1") + triangle("[[-99, -99, -4], [99, -99, -4], [0, 99, -4]]", "mirror");
    const auto in_mirror = colors_of(prepared(with_camera(mirror + sphere("[0.5, 3, 0.25]", "1.5"))), all_effects);
    const auto mirrored = colors_of(prepared(with_camera(sphere("[0.5, 3, -8.25]", "1.5"))), {});
    const auto direct = colors_of(prepared(with_camera(sphere("[0.5, 3, 0.25]", "1.5"))), {});
    int seen = 0;
    for (std::size_t i = 0; i < in_mirror.size(); ++i) {
        SCOPED_TRACE(i);
        if (direct[i] != Color(0, 0, 0)) continue;
        if (mirrored[i] == Color(0, 0, 0)) {
            EXPECT_EQ(in_mirror[i], Color(0, 0, 0));
            continue;
        }
        ++seen;
        expect_near(in_mirror[i], Color(mirrored[i].x, mirrored[i].y, 1 - mirrored[i].z), 1e-9);
    }
    EXPECT_GT(seen, 10);
}

/// A point is dark if the ball hides the sun or the lamp: if the line there passes the ball's center within its radius.
TEST(Shadows, FallWhereABallHidesTheLight) {
    const Point lamp(3, 2.5, 1);
    const auto to_lamp = [&](const Point& P) { return Point(lamp - P); };
    const auto to_sun = [](const Point&) { return Point(-1, 0.5, 2); };
    struct Case {
        std::string light;
        std::function<Point(const Point&)> way;
        Point middle;
    };
    for (const auto& [light, way_from, middle] : {Case{"direction = [1, -0.5, -2]", to_sun, {0.3, 0.2, -2}},
                                                  Case{"position = [3, 2.5, 1]", to_lamp, {0.6, 0.5, -2}}}) {
        const PreparedScene scene = prepared(
            with_camera("[[light]]\n" + light + "\ncolor = [1, 1, 1]\n" + material("clay", "diffuse = [1, 1, 1]") +
                        sphere(fmt::format("[{}, {}, {}]", middle.x, middle.y, middle.z), "0.75", "clay") +
                        triangle("[[-99, -99, -4], [99, -99, -4], [0, 99, -4]]", "clay")));
        int dark = 0;
        for_each_pixel(colors_of(scene, with_shadows), [&](const Point& start, const Color& color) {
            const Point V = start - Point(0, 0, 4);
            if (length(cross(Point(middle - Point(0, 0, 4)), V)) / length(V) < 0.75) return;  // the ball itself
            const Point P(start.x * 4, start.y * 4, -4);
            const Point way = way_from(P);
            const bool is_dark = length(cross(Point(middle - P), way)) / length(way) < 0.75;
            dark += is_dark ? 1 : 0;
            const double lambert = way.z / length(way);
            expect_near(color, is_dark ? Color(0, 0, 0) : Color(lambert, lambert, lambert), 1e-12);
        });
        EXPECT_GT(dark, 5) << light;
    }
}

/// Phong's sum for a whole wall, computed by hand: with light from above the camera at an angle whose sine is 0.6, and
/// with light so low that the lower part of the wall reflects it away from the camera.
TEST(Illumination, FollowsPhongsFormula) {
    for (const auto& [direction, sine, cosine] :
         {std::tuple("[0, -3, -4]", 0.6, 0.8), std::tuple("[0, -24, -7]", 0.96, 0.28)}) {
        const PreparedScene scene = prepared(with_camera(
            fmt::format("[render]\nambient_light = [0.5, 0.25, 0]\n[[light]]\ndirection = {}\ncolor = [1, 0.5, 1]\n",
                        direction) +
            material("m", "ambient = [0.2, 0.4, 1]\ndiffuse = [0.5, 1, 0]\nspecular = [0.25, 1, 1]\nshininess = 3") +
            triangle("[[-99, -99, 0], [99, -99, 0], [0, 99, 0]]", "m")));
        int away = 0;
        for_each_pixel(colors_of(scene, {true, false, false, false, false}), [&](const Point& start,
                                                                                 const Color& color) {
            const Point V = scaled(start - Point(0, 0, 4), 1 / length(Point(start - Point(0, 0, 4))));
            const Point R(V.x, V.y, -V.z);
            const double along = R.y * sine + R.z * cosine;
            away += along < 0 ? 1 : 0;
            const double towards = along > 0 ? along * along * along : 0;
            expect_near(
                color, Color(0.5 * 0.2 + 0.5 * cosine + 0.25 * towards, 0.25 * 0.4 + 0.5 * (cosine + towards), towards),
                1e-12);
        });
        EXPECT_EQ(away > 0, sine > 0.9);
    }
}

/// With white light from all directions, an object that passes on all light looks white too.
TEST(Energy, IsConserved) {
    for (const std::string& properties :
         {std::string("reflectivity = 1"), std::string("transparency = 1\nrefractive_index = 1.5"),
          std::string("reflectivity = 0.5\ntransparency = 0.5\nrefractive_index = 2")}) {
        const PreparedScene scene = prepared(with_camera("[render]\nbackground = [1, 1, 1]\n" +
                                                         material("m", properties) + sphere("[0.2, 0, 0]", "1", "m")));
        for (const Color& color : colors_of(scene, all_effects)) {
            EXPECT_LE(color.x, 1 + 1e-12);
            // The most light is cut off where it grazes glass.
            EXPECT_GE(color.x, 0.99);
        }
    }
}

TEST(Supersampling, IsTheMeanOfALargerPicture) {
    Assignment assignment = parse_assignment(scenes::room({true, true, true, false}), "scene.toml");
    const auto coarse = colors_of(prepare_scene(assignment, {}), all_effects);
    const auto fine = colors_of(prepare_scene(assignment, PictureSize{120, 90}), all_effects);
    assignment.appearance.samples_per_pixel = 9;
    const auto means = colors_of(prepare_scene(assignment, {}), all_effects);
    int differing = 0;
    for (std::size_t y = 0; y < 30; ++y) {
        for (std::size_t x = 0; x < 40; ++x) {
            Color sum(0, 0, 0);
            for (std::size_t i = 0; i < 9; ++i) sum += fine[(3 * y + i / 3) * 120 + 3 * x + i % 3];
            expect_near(means[y * 40 + x], scaled(sum, 1.0 / 9), 1e-12);
            differing += means[y * 40 + x] == coarse[y * 40 + x] ? 0 : 1;
        }
    }
    EXPECT_GT(differing, 0);
}

}  // namespace
