// A mesh for the study: triangles with float coordinates, since every method is to get the very same problem.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "reference/kernel/ray.h"

namespace reference::accuracy {

struct Mesh {
    using Face = std::array<std::uint32_t, 3>;  ///< indices of three different vertices

    std::string name;
    std::vector<Vec3<float>> vertices;  ///< no two are equal
    std::vector<Face> faces;            ///< at least one

    template <class S>
    Triangle<S> triangle(std::size_t face) const {
        const auto& [a, b, c] = faces[face];
        return {Vec3<S>(vertices[a]), Vec3<S>(vertices[b]), Vec3<S>(vertices[c])};
    }
};

/// Rounds to floats. Corners that are equal then are one vertex, and a triangle with two equal corners is left out.
/// Throws std::invalid_argument if none is left.
Mesh mesh_of(std::span<const Triangle<double>> triangles, const std::string& name);

/// Of a Wavefront OBJ file, called by the file's name. Throws AssignmentError as render::load_mesh does, and
/// std::invalid_argument as mesh_of does.
Mesh load_mesh(const std::filesystem::path& obj);

/// A directed edge and the face that runs through it.
struct EdgeOfFace {
    std::uint32_t from;
    std::uint32_t to;
    std::uint32_t face;

    friend auto operator<=>(const EdgeOfFace&, const EdgeOfFace&) = default;
};
/// Three for each face, sorted.
std::vector<EdgeOfFace> edges_of(const Mesh& mesh);

/// How many directed edges are not met by exactly one face that runs through them the other way. A mesh is closed if
/// there are none: no ray that meets the surface where faces meet may slip through.
std::size_t open_edges(const Mesh& mesh);

}  // namespace reference::accuracy
