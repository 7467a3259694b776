// Shadows have no acne and no light leaks.
#include "reference/render/visibility.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "reference/accuracy/rays/random_numbers.h"
#include "tests/given/render/scenes.h"
#include "tests/reference/render/scene_parts.h"

namespace {

using namespace reference;
using namespace reference::render;
using accuracy::Random;
using scenes::clay;
using scenes::colors_of;
using scenes::with_shadows;
using Point = Vec3<double>;

constexpr std::uint64_t mesh_seed = 20211101;
constexpr Effects without_shadows{true, false, false, false, false};

struct Mesh {
    std::vector<Point> vertices;
    std::vector<std::array<std::size_t, 3>> faces;
};

/// The surface of the cube from -1 to 1. Each side is split into `parts` times `parts` squares of two triangles.
Mesh cube(int parts) {
    Mesh mesh;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            const auto corner = [&](int i, int j) {
                Point p;
                p[axis] = side;
                p[(axis + 1) % 3] = -1 + 2.0 * i / parts;
                p[(axis + 2) % 3] = -1 + 2.0 * j / parts;
                mesh.vertices.push_back(p);
                return mesh.vertices.size() - 1;
            };
            for (int i = 0; i < parts; ++i) {
                for (int j = 0; j < parts; ++j) {
                    const std::size_t a = corner(i, j);
                    const std::size_t b = corner(i + 1, j);
                    const std::size_t c = corner(i + 1, j + 1);
                    const std::size_t d = corner(i, j + 1);
                    mesh.faces.insert(mesh.faces.end(), {{a, b, c}, {a, c, d}});
                }
            }
        }
    }
    return mesh;
}

/// Rotates, scales and moves a mesh, with rounding.
Mesh moved(Mesh mesh, const Point& by, double scale, Random& random) {
    const Point z = normalized(random.point(1));
    const Point x = normalized(cross(random.point(1), z));
    const Point y = cross(z, x);
    for (Point& p : mesh.vertices) p = by + scaled(Point(scaled(x, p.x) + scaled(y, p.y) + scaled(z, p.z)), scale);
    return mesh;
}

std::string text_of(const Point& p) {
    return fmt::format("[{:.17g}, {:.17g}, {:.17g}]", p.x, p.y, p.z);
}

std::string text_of(const Mesh& mesh) {
    std::string text;
    for (const auto& [a, b, c] : mesh.faces) {
        text += scenes::triangle(fmt::format("[{}, {}, {}]", text_of(mesh.vertices[a]), text_of(mesh.vertices[b]),
                                             text_of(mesh.vertices[c])),
                                 "clay");
    }
    return text;
}

const std::string lights =
    "[[light]]\nposition = [3, 2, 5]\ncolor = [0.5, 0.5, 0.5]\n"
    "[[light]]\ndirection = [-1, -0.125, -0.25]\ncolor = [0.5, 0.5, 0.5]\n";

PreparedScene scene_of(const Mesh& mesh, const std::string& with_lights = lights) {
    return scenes::prepared(scenes::with_camera(with_lights + clay + text_of(mesh)));
}

/// A convex body shades none of its own points that face the light, so its picture is exactly the same with and without
/// shadows. The cube's sides consist of many triangles, exact or rounded; the light grazes some of them.
TEST(Shadows, NeverFallOnTheLitSideOfAConvexBody) {
    Random random(mesh_seed);
    std::vector<Mesh> bodies{cube(4), moved(cube(4), {0.3, -0.2, 0}, 1, random),
                             moved(cube(4), {0, 0, -1e6}, 3e5, random)};
    for (int i = 0; i < 3; ++i) bodies.push_back(moved(cube(3), random.point(0.5), random.between(0.1, 1), random));
    for (const Mesh& body : bodies) {
        const PreparedScene scene = scene_of(body);
        const auto lit = colors_of(scene, without_shadows);
        EXPECT_EQ(colors_of(scene, with_shadows), lit);
        EXPECT_TRUE(std::any_of(lit.begin(), lit.end(), [](const Color& color) { return color.x > 0; }));
    }
}

/// The same for balls, near and far, small and huge. A second ball far away makes the scene need shadows.
TEST(Shadows, NeverFallOnTheLitSideOfABall) {
    for (const auto& [middle, radius] :
         {std::pair(Point(0, 0, 0), 1.0), std::pair(Point(0.1, 0.7, 0.3), 1.1), std::pair(Point(0, 0, -1e9), 4e8),
          std::pair(Point(0, 0, 1.9), 1e-3), std::pair(Point(0, -10000005, 0), 1e7)}) {
        const PreparedScene scene = scenes::prepared(scenes::with_camera(
            lights + clay + scenes::sphere(text_of(middle), fmt::format("{:.17g}", radius), "clay") +
            scenes::sphere("[0, 9e12, -9e12]", "1")));
        const auto lit = colors_of(scene, without_shadows);
        EXPECT_EQ(colors_of(scene, with_shadows), lit);
    }
}

/// A lamp inside closed walls lights nothing outside, not even through an edge or a corner.
TEST(Shadows, HaveNoLeaksAtClosedWalls) {
    Random random(mesh_seed);
    for (const Mesh& walls : {cube(3), moved(cube(3), {0.1, 0.1, 0}, 1, random)}) {
        const PreparedScene scene = scenes::prepared(scenes::with_camera(
            "[[light]]\nposition = [0.125, 0.0625, 0.25]\ncolor = [1, 1, 1]\n" + clay + text_of(walls) +
            scenes::triangle("[[-99, -99, -4], [99, -99, -4], [0, 99, -4]]", "clay")));
        for (const Color& color : colors_of(scene, with_shadows)) EXPECT_EQ(color, Color(0, 0, 0));
    }
}

}  // namespace
