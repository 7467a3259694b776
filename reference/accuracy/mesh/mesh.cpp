#include "reference/accuracy/mesh/mesh.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <tuple>

#include "reference/render/scene/mesh_reader.h"

namespace reference::accuracy {

Mesh mesh_of(std::span<const Triangle<double>> triangles, const std::string& name) {
    const auto before = [](const Vec3<float>& one, const Vec3<float>& other) {
        return std::tie(one.x, one.y, one.z) < std::tie(other.x, other.y, other.z);
    };
    Mesh mesh{name, {}, {}};
    std::map<Vec3<float>, std::uint32_t, decltype(before)> known(before);
    const auto vertex = [&](const Vec3<double>& p) {
        const auto [place, is_new] = known.try_emplace(Vec3<float>(p), static_cast<std::uint32_t>(known.size()));
        if (is_new) mesh.vertices.push_back(place->first);
        return place->second;
    };
    for (const Triangle<double>& triangle : triangles) {
        const Mesh::Face face{vertex(triangle.A), vertex(triangle.B), vertex(triangle.C)};
        if (face[0] != face[1] && face[1] != face[2] && face[2] != face[0]) mesh.faces.push_back(face);
    }
    if (mesh.faces.empty()) {
        throw std::invalid_argument(name + ": in floats no triangle has three different corners; move the mesh to 0");
    }
    return mesh;
}

Mesh load_mesh(const std::filesystem::path& obj) {
    return mesh_of(render::load_mesh({obj, {}, "--mesh"}), obj.filename().string());
}

std::vector<EdgeOfFace> edges_of(const Mesh& mesh) {
    std::vector<EdgeOfFace> edges;
    edges.reserve(3 * mesh.faces.size());
    for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
        const auto& [a, b, c] = mesh.faces[face];
        for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
            edges.push_back({from, to, face});
        }
    }
    std::sort(edges.begin(), edges.end());
    return edges;
}

std::size_t open_edges(const Mesh& mesh) {
    const std::vector<EdgeOfFace> edges = edges_of(mesh);
    const auto count = [&](std::uint32_t from, std::uint32_t to) {
        const auto first = std::lower_bound(edges.begin(), edges.end(), EdgeOfFace{from, to, 0});
        return std::upper_bound(first, edges.end(), EdgeOfFace{from, to, ~0U}) - first;
    };
    return static_cast<std::size_t>(std::count_if(
        edges.begin(), edges.end(), [&](const EdgeOfFace& edge) { return count(edge.to, edge.from) != 1; }));
}

}  // namespace reference::accuracy
