// Meshes of any size for benchmarks and tests, with float coordinates, and rays that must hit them.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "reference/accuracy/rays/random_numbers.h"
#include "reference/kernel/ray.h"
#include "reference/render/scene/prepared_scene.h"

namespace meshes {

using Point = reference::Vec3<float>;
using Rays = std::vector<reference::kernel::Ray<float>>;

struct Mesh {
    std::string name;
    std::vector<Point> vertices;
    std::vector<std::array<unsigned, 3>> faces;
    /// Rays from places that see the whole mesh, or the inside of it, at points where faces meet. No ray misses.
    Rays aimed;
};

/// A ball around the origin with a dent at each vertex, of about `size` faces. Rays come from near its middle.
Mesh dented_ball(unsigned size, reference::accuracy::Random& random);
/// Hills above the square from -1 to 1. Rays come from above.
Mesh terrain(unsigned size, reference::accuracy::Random& random);
/// Pairs of triangles, each a thousand times as long as it is wide, which share a long side. Rays come
/// from in front of them.
Mesh slivers(unsigned size, reference::accuracy::Random& random);
/// Twelve large triangles, the walls of a cube, and in it balls of triangles that are ten thousand times smaller.
/// Rays go to the edges of the balls, from their middles.
Mesh large_and_tiny(unsigned size, reference::accuracy::Random& random);

std::vector<Mesh> all_kinds(unsigned size, reference::accuracy::Random& random);

/// Rays of a camera that sees the mesh, `side` rows of `side` rays.
Rays camera_rays(int side);
/// Rays from anywhere near the mesh in any direction.
Rays scattered_rays(std::size_t count, reference::accuracy::Random& random);

/// The mesh with its coordinates multiplied by `scale` and then moved, as a scene with a tree.
reference::render::PreparedScene scene_of(const Mesh& mesh, double scale = 1, const reference::Vec3<double>& by = {});

}  // namespace meshes
