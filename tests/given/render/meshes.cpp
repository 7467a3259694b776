#include "tests/given/render/meshes.h"

#include <cmath>
#include <numbers>

namespace meshes {

using namespace reference;
using accuracy::Random;

namespace {

Point rounded(const Vec3<double>& p) {
    return Point(p);
}

void aim(Mesh& mesh, const Vec3<double>& from, const Point& at) {
    const Point origin = rounded(from);
    mesh.aimed.push_back({origin, at - origin});
}

/// A point of the edge, but for rounding. It is not near the ends, where a sliver is as thin as rounding.
Point on_edge(const Mesh& mesh, unsigned a, unsigned b, Random& random) {
    const Point along = mesh.vertices[b] - mesh.vertices[a];
    return mesh.vertices[a] + along * static_cast<float>(random.between(0.2, 0.8));
}

/// Rings of vertices between two poles.
void add_ball(Mesh& mesh, const Vec3<double>& middle, double radius, unsigned rings, unsigned columns, Random& random) {
    const auto first = static_cast<unsigned>(mesh.vertices.size());
    const auto add = [&](double height, double turn) {
        const double size = radius * random.between(0.97, 1);
        const double around = std::sqrt(1 - height * height) * size;
        mesh.vertices.push_back(
            rounded(middle + Vec3<double>(around * std::cos(turn), size * height, around * std::sin(turn))));
    };
    add(1, 0);
    for (unsigned ring = 0; ring < rings; ++ring) {
        for (unsigned column = 0; column < columns; ++column) {
            add(std::cos(std::numbers::pi * (ring + 1) / (rings + 1)), 2 * std::numbers::pi * column / columns);
        }
    }
    add(-1, 0);
    const auto vertex = [&](unsigned ring, unsigned column) { return first + 1 + ring * columns + column % columns; };
    const auto last = static_cast<unsigned>(mesh.vertices.size() - 1);
    for (unsigned column = 0; column < columns; ++column) {
        mesh.faces.push_back({first, vertex(0, column), vertex(0, column + 1)});
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
}

/// Rays from near `middle` at each vertex and at a point of an edge of each face, from the given ones on.
void aim_from(Mesh& mesh, const Vec3<double>& middle, double reach, std::size_t vertex, std::size_t face,
              Random& random) {
    for (; vertex < mesh.vertices.size(); ++vertex) aim(mesh, middle + random.point(reach), mesh.vertices[vertex]);
    for (; face < mesh.faces.size(); ++face) {
        const auto [a, b, c] = mesh.faces[face];
        aim(mesh, middle + random.point(reach), on_edge(mesh, a, b, random));
    }
}

unsigned side_for(double faces) {
    return static_cast<unsigned>(std::lround(std::sqrt(faces / 2)));
}

}  // namespace

Mesh dented_ball(unsigned size, Random& random) {
    Mesh mesh{"ball", {}, {}, {}};
    const unsigned side = side_for(size);
    add_ball(mesh, {0, 0, 0}, 1, side, side, random);
    aim_from(mesh, {0, 0, 0}, 0.3, 0, 0, random);
    return mesh;
}

Mesh terrain(unsigned size, Random& random) {
    Mesh mesh{"terrain", {}, {}, {}};
    const unsigned side = side_for(size);
    const auto place = [&](unsigned i) { return -1 + 2.0 * i / side; };
    for (unsigned i = 0; i <= side; ++i) {
        for (unsigned j = 0; j <= side; ++j) {
            const double x = place(i);
            const double z = place(j);
            const double hills = 0.2 * std::sin(5 * x + 1) * std::cos(4 * z) + 0.05 * std::sin(23 * x * z);
            mesh.vertices.push_back(rounded({x, hills + random.number() / (4 * side), z}));
        }
    }
    const auto vertex = [&](unsigned i, unsigned j) { return i * (side + 1) + j; };
    for (unsigned i = 0; i < side; ++i) {
        for (unsigned j = 0; j < side; ++j) {
            mesh.faces.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i + 1, j)});
            mesh.faces.push_back({vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1)});
            const auto aim_from_above = [&](const Point& at) {
                aim(mesh, Vec3<double>(at) + Vec3<double>(random.number(), 5, random.number()), at);
            };
            aim_from_above(on_edge(mesh, vertex(i, j), vertex(i + 1, j + 1), random));
            if (i > 0 && j > 0) aim_from_above(mesh.vertices[vertex(i, j)]);
        }
    }
    return mesh;
}

Mesh slivers(unsigned size, Random& random) {
    Mesh mesh{"slivers", {}, {}, {}};
    while (mesh.faces.size() < size) {
        const Vec3<double> middle = random.point(1);
        const Vec3<double> along = scaled(random.direction(), 0.1);
        const Vec3<double> across = scaled(random.direction(), 1e-4);
        const auto first = static_cast<unsigned>(mesh.vertices.size());
        for (const Vec3<double>& p : {middle - along, middle + along, middle + across, middle - across}) {
            mesh.vertices.push_back(rounded(p));
        }
        mesh.faces.push_back({first, first + 1, first + 2});
        mesh.faces.push_back({first + 1, first, first + 3});
        const Vec3<double> normal = normalized(cross(along, across));
        aim(mesh, middle + scaled(normal, 2.0) + random.point(0.5), on_edge(mesh, first, first + 1, random));
    }
    return mesh;
}

Mesh large_and_tiny(unsigned size, Random& random) {
    Mesh mesh{"large and tiny", {}, {}, {}};
    for (unsigned corner = 0; corner < 8; ++corner) {
        const auto side = [&](unsigned bit) { return (corner >> bit & 1U) != 0 ? 1.5F : -1.5F; };
        mesh.vertices.emplace_back(side(0), side(1), side(2));
    }
    for (const auto& [a, b, c, d] :
         {std::array{0U, 1U, 3U, 2U}, std::array{4U, 6U, 7U, 5U}, std::array{0U, 4U, 5U, 1U},
          std::array{2U, 3U, 7U, 6U}, std::array{0U, 2U, 6U, 4U}, std::array{1U, 5U, 7U, 3U}}) {
        mesh.faces.push_back({a, b, c});
        mesh.faces.push_back({a, c, d});
    }
    constexpr unsigned balls = 8;
    const unsigned side = side_for(static_cast<double>(size) / balls);
    for (unsigned i = 0; i < balls; ++i) {
        const Vec3<double> middle = random.point(0.9);
        const std::size_t vertex = mesh.vertices.size();
        const std::size_t face = mesh.faces.size();
        const double radius = 1.5e-4 * side;
        add_ball(mesh, middle, radius, side, side, random);
        aim_from(mesh, middle, radius / 4, vertex, face, random);
    }
    return mesh;
}

std::vector<Mesh> all_kinds(unsigned size, Random& random) {
    return {dented_ball(size, random), terrain(size, random), slivers(size, random), large_and_tiny(size, random)};
}

Rays camera_rays(int side) {
    Rays rays;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const auto place = [&](int i) { return static_cast<float>(-1.0 + 2.0 * (i + 0.5) / side); };
            rays.push_back({Point(0, 1, 3), Point(place(x), place(y) - 1, -2.5F)});
        }
    }
    return rays;
}

Rays scattered_rays(std::size_t count, Random& random) {
    Rays rays;
    for (std::size_t i = 0; i < count; ++i) rays.push_back({rounded(random.point(1.2)), rounded(random.direction())});
    return rays;
}

render::PreparedScene scene_of(const Mesh& mesh, double scale, const Vec3<double>& by) {
    std::vector<Triangle<double>> triangles;
    const auto placed = [&](unsigned vertex) { return scaled(Vec3<double>(mesh.vertices[vertex]), scale) + by; };
    for (const auto& [a, b, c] : mesh.faces) triangles.push_back({placed(a), placed(b), placed(c)});
    return render::prepare_triangles(triangles);
}

}  // namespace meshes
