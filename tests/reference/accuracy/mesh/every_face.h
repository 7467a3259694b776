// Small meshes, and what rays hit in them: every face is tried, in rationals.
#pragma once

#include <map>

#include "reference/accuracy/mesh/mesh.h"
#include "reference/accuracy/rays/truth.h"
#include "tests/given/render/meshes.h"

namespace {

using reference::accuracy::truth::Rational;

inline reference::accuracy::Mesh as_mesh(const meshes::Mesh& mesh) {
    std::vector<reference::Triangle<double>> triangles;
    for (const auto& [a, b, c] : mesh.faces) {
        const auto vertex = [&](unsigned i) { return reference::Vec3<double>(mesh.vertices[i]); };
        triangles.push_back({vertex(a), vertex(b), vertex(c)});
    }
    return reference::accuracy::mesh_of(triangles, mesh.name);
}

/// From -1 to 1. Faces 0 and 1 are at z = 1 and share the diagonal x = y, faces 2 and 3 are at z = -1.
inline std::vector<reference::Triangle<double>> cube() {
    const auto corner = [](unsigned i) {
        return reference::Vec3<double>((i & 1U) != 0 ? 1 : -1, (i & 2U) != 0 ? 1 : -1, (i & 4U) != 0 ? 1 : -1);
    };
    std::vector<reference::Triangle<double>> triangles;
    for (const auto& [a, b, c, d] :
         {std::array{4U, 5U, 7U, 6U}, std::array{0U, 2U, 3U, 1U}, std::array{0U, 1U, 5U, 4U},
          std::array{2U, 6U, 7U, 3U}, std::array{0U, 4U, 6U, 2U}, std::array{1U, 3U, 7U, 5U}}) {
        triangles.push_back({corner(a), corner(b), corner(c)});
        triangles.push_back({corner(a), corner(c), corner(d)});
    }
    return triangles;
}

/// t by face, of every face that the ray hits.
inline std::map<std::uint32_t, Rational> hits_by_trying(const reference::accuracy::Mesh& mesh,
                                                        const reference::kernel::Ray<double>& ray) {
    std::map<std::uint32_t, Rational> hits;
    for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
        const auto found = reference::accuracy::truth::triangle(ray, mesh.triangle<double>(face));
        if (found.result == reference::kernel::TriangleResult::hit) hits.emplace(face, found.t);
    }
    return hits;
}

/// The least t of the hits, of which there is one.
inline Rational first_of(const std::map<std::uint32_t, Rational>& hits) {
    Rational least = hits.begin()->second;
    for (const auto& [face, t] : hits) {
        if (t < least) least = t;
    }
    return least;
}

}  // namespace
