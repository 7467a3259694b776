// A closed mesh has no holes: every ray from inside hits it, whether aimed at a face, an edge or a vertex.
#include <gtest/gtest.h>

#include <array>
#include <map>

#include "reference/accuracy/rays/random_numbers.h"
#include "reference/kernel/triangle.h"

namespace {

using reference::Triangle;
using reference::accuracy::P;
using reference::accuracy::Random;
using namespace reference::kernel;

/// Vertices, and faces as vertex numbers. Every edge belongs to two faces.
struct Mesh {
    std::vector<P> vertices;
    std::vector<std::array<std::size_t, 3>> faces;
};

Mesh octahedron() {
    return {{P(1, 0, 0), P(-1, 0, 0), P(0, 1, 0), P(0, -1, 0), P(0, 0, 1), P(0, 0, -1)},
            {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

/// Splits each face into four. The new vertices lie on the unit sphere, up to a random dent, and are rounded to T.
template <class T>
Mesh refined(const Mesh& mesh, Random& random) {
    Mesh result{mesh.vertices, {}};
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
    const auto middle = [&](std::size_t a, std::size_t b) {
        const auto [entry, is_new] = middles.try_emplace(std::minmax(a, b), result.vertices.size());
        if (is_new) {
            const P sum = mesh.vertices[a] + mesh.vertices[b];
            const P p = reference::scaled(sum, random.between(0.9, 1) / std::sqrt(dot(sum, sum)));
            result.vertices.emplace_back(static_cast<double>(static_cast<T>(p.x)),
                                         static_cast<double>(static_cast<T>(p.y)),
                                         static_cast<double>(static_cast<T>(p.z)));
        }
        return entry->second;
    };
    for (const auto& [a, b, c] : mesh.faces) {
        const std::size_t ab = middle(a, b);
        const std::size_t bc = middle(b, c);
        const std::size_t ca = middle(c, a);
        result.faces.insert(result.faces.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    return result;
}

template <class T>
Mesh dented_ball(Random& random) {
    Mesh mesh = octahedron();
    for (int level = 0; level < 3; ++level) mesh = refined<T>(mesh, random);
    return mesh;
}

int hits(const Mesh& mesh, const Ray<double>& ray) {
    int count = 0;
    for (const auto& [a, b, c] : mesh.faces) {
        const Triangle<double> face{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
        if (decide(ray, face) == TriangleResult::hit) ++count;
    }
    return count;
}

/// Shoots rays in T's precision from near the middle at every vertex and at points of every edge. Returns how many
/// miss.
template <class T>
int holes_of(const Mesh& mesh, Random& random) {
    int holes = 0;
    const auto round = [](double x) { return static_cast<double>(static_cast<T>(x)); };
    const auto shoot_at = [&](const P& target) {
        const P from = random.point(0.3);
        const P origin(round(from.x), round(from.y), round(from.z));
        const P d = target - origin;
        if (hits(mesh, {origin, P(round(d.x), round(d.y), round(d.z))}) == 0) ++holes;
    };
    for (const P& vertex : mesh.vertices) shoot_at(vertex);
    for (const auto& [a, b, c] : mesh.faces) {
        for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
            shoot_at(mesh.vertices[from] +
                     reference::scaled(P(mesh.vertices[to] - mesh.vertices[from]), random.between(0, 1)));
        }
    }
    return holes;
}

constexpr std::uint64_t mesh_seed = 20211101;

TEST(Watertight, NoRayInFloatsLeavesAClosedMesh) {
    Random random(mesh_seed);
    for (int round = 0; round < 5; ++round) EXPECT_EQ(holes_of<float>(dented_ball<float>(random), random), 0);
}

TEST(Watertight, NoRayInDoublesLeavesAClosedMesh) {
    Random random(mesh_seed + 1);
    for (int round = 0; round < 5; ++round) EXPECT_EQ(holes_of<double>(dented_ball<double>(random), random), 0);
}

TEST(Watertight, TheTestDetectsAHole) {
    Random random(mesh_seed + 2);
    Mesh mesh = dented_ball<float>(random);
    mesh.faces.pop_back();
    EXPECT_GT(holes_of<float>(mesh, random), 0);
}

}  // namespace
