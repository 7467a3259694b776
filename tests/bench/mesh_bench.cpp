// mesh_bench [ROUNDS]: compares primary visibility of a closed mesh of 100,000 triangles on one core with Embree (Wald
// and others, 2014), fast and robust, one ray at a time, with the same float rays for all. Also counts the rays from
// inside, aimed at edges and vertices, that miss the closed mesh.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numbers>

#include "reference/accuracy/rays/random_numbers.h"
#include "reference/render/trace/visibility.h"
#include "reference/toml/assignment.h"
#include "tests/bench/contest.h"
#include "tests/bench/embree.h"

using namespace reference;
using namespace reference::render;
using Point = Vec3<float>;
using accuracy::Random;

namespace {

struct Mesh {
    std::vector<Point> vertices;
    std::vector<std::array<unsigned, 3>> faces;
};

/// A dented ball around the origin: rings of vertices between two poles.
Mesh dented_ball(unsigned rings, unsigned columns, Random& random) {
    Mesh mesh;
    const auto add = [&](double height, double turn) {
        const double size = random.between(0.97, 1);
        const double around = std::sqrt(1 - height * height) * size;
        mesh.vertices.emplace_back(static_cast<float>(around * std::cos(turn)), static_cast<float>(size * height),
                                   static_cast<float>(around * std::sin(turn)));
    };
    add(1, 0);
    for (unsigned ring = 0; ring < rings; ++ring) {
        for (unsigned column = 0; column < columns; ++column) {
            add(std::cos(std::numbers::pi * (ring + 1) / (rings + 1)), 2 * std::numbers::pi * column / columns);
        }
    }
    add(-1, 0);
    const auto vertex = [&](unsigned ring, unsigned column) { return 1 + ring * columns + column % columns; };
    const auto last = static_cast<unsigned>(mesh.vertices.size() - 1);
    for (unsigned column = 0; column < columns; ++column) {
        mesh.faces.push_back({0, vertex(0, column), vertex(0, column + 1)});
        mesh.faces.push_back({last, vertex(rings - 1, column + 1), vertex(rings - 1, column)});
        for (unsigned ring = 0; ring + 1 < rings; ++ring) {
            const unsigned a = vertex(ring, column);
            const unsigned b = vertex(ring, column + 1);
            const unsigned c = vertex(ring + 1, column + 1);
            const unsigned d = vertex(ring + 1, column);
            mesh.faces.push_back({a, d, c});
            mesh.faces.push_back({a, c, b});
        }
    }
    return mesh;
}

using Rays = std::vector<kernel::Ray<float>>;

/// The rays of a camera in front of the ball, row by row.
Rays camera_rays(int side) {
    Rays rays;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const auto place = [&](int i) { return static_cast<float>(-1.0 + 2.0 * (i + 0.5) / side); };
            rays.push_back({Point(0, 0, 3), Point(place(x), place(y), -2.5F)});
        }
    }
    return rays;
}

/// Rays from near the middle at each vertex and at a point of each edge.
Rays aimed_rays(const Mesh& mesh, Random& random) {
    Rays rays;
    const auto aim_at = [&](const Point& target) {
        const Point origin(random.point(0.3));
        rays.push_back({origin, target - origin});
    };
    for (const Point& vertex : mesh.vertices) aim_at(vertex);
    for (const auto& [a, b, c] : mesh.faces) {
        const Point along = mesh.vertices[b] - mesh.vertices[a];
        aim_at(mesh.vertices[a] + along * static_cast<float>(random.between(0, 1)));
    }
    return rays;
}

std::size_t certified_hits(const PreparedScene& scene, const Rays& rays) {
    std::size_t count = 0;
    for (const auto& ray : rays) {
        count += ObjectTree::first_hit(scene, CameraRay{kernel::as_double(ray)}).is_hit() ? 1 : 0;
    }
    return count;
}

PreparedScene scene_of(const Mesh& mesh) {
    PreparedScene scene{};
    scene.boundary = Boundary::nonnegative;
    std::vector<Box> boxes;
    for (const auto& [a, b, c] : mesh.faces) {
        const Triangle<double> triangle{Vec3<double>(mesh.vertices[a]), Vec3<double>(mesh.vertices[b]),
                                        Vec3<double>(mesh.vertices[c])};
        scene.triangles.emplace_back(triangle);
        boxes.push_back(box_of(triangle));
    }
    scene.object_count = static_cast<std::uint32_t>(mesh.faces.size());
    scene.first_cylinder = scene.object_count;
    scene.tree = build_tree(boxes);
    return scene;
}

}  // namespace

int main(int argc, char** argv) {
    const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 9;
    Random random(20211101);
    const Mesh mesh = dented_ball(223, 224, random);
    const Rays rays = camera_rays(1000);
    const Rays aimed = aimed_rays(mesh, random);
    const PreparedScene scene = scene_of(mesh);
    const Embree fast(mesh.vertices, mesh.faces, RTC_SCENE_FLAG_NONE);
    const Embree robust(mesh.vertices, mesh.faces, RTC_SCENE_FLAG_ROBUST);
    std::vector<Contestant> ways{{"certified", [&] { return certified_hits(scene, rays); }},
                                 {"Embree, fast", [&] { return fast.hits(rays); }},
                                 {"Embree, robust", [&] { return robust.hits(rays); }}};
    contest(ways, rounds);
    fmt::print("| {} triangles, one core | million rays/s | quartiles | misses of {} at edges and vertices |\n",
               mesh.faces.size(), aimed.size());
    fmt::print("|---|---:|---:|---:|\n");
    const std::array aimed_hits{certified_hits(scene, aimed), fast.hits(aimed), robust.hits(aimed)};
    for (std::size_t i = 0; i < ways.size(); ++i) {
        const auto rate = [&](int quartile) {
            return static_cast<double>(rays.size()) / ways[i].quartile(quartile) / 1e6;
        };
        fmt::print("| {} | {:.2f} | {:.2f}–{:.2f} | {} |\n", ways[i].name, rate(2), rate(3), rate(1),
                   aimed.size() - aimed_hits[i]);
    }
}
