#include "reference/render/scene/mesh_reader.h"

#include <fmt/format.h>
#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include <cmath>
#include <fstream>

#include "reference/toml/assignment.h"

namespace reference::render {
namespace {

constexpr double largest_coordinate = 1e30;

/// What the parser reports, line by line. The first mistake is kept and the rest of the file is ignored, because
/// exceptions must not pass through the parser.
struct Reading {
    std::vector<Vec3<double>> vertices;
    std::vector<Triangle<double>> triangles;
    std::size_t faces = 0;
    std::string mistake;

    void add_vertex(double x, double y, double z) {
        if (!mistake.empty()) return;
        for (const double coordinate : {x, y, z}) {
            if (std::abs(coordinate) <= largest_coordinate) continue;  // false for NaN
            mistake = fmt::format("vertex {} has a coordinate beyond 1e30; scale the mesh", vertices.size() + 1);
        }
        vertices.emplace_back(x, y, z);
    }

    /// OBJ counts vertices from 1, or from -1 backwards from the last one so far.
    const Vec3<double>* vertex(int index) const {
        const auto count = static_cast<long>(vertices.size());
        const long place = index < 0 ? count + index : long{index} - 1;
        return 0 <= place && place < count ? &vertices[static_cast<std::size_t>(place)] : nullptr;
    }

    void add_face(const tinyobj::index_t* indices, int count) {
        if (!mistake.empty()) return;
        ++faces;
        if (count < 3) mistake = fmt::format("face {} has {} vertices; a face has three or more", faces, count);
        for (int i = 0; i < count && mistake.empty(); ++i) {
            if (vertex(indices[i].vertex_index) != nullptr) continue;
            mistake = fmt::format("face {} names vertex {}, and {} vertices come before it", faces,
                                  indices[i].vertex_index, vertices.size());
        }
        for (int i = 1; i + 1 < count && mistake.empty(); ++i) {
            triangles.push_back({*vertex(indices[0].vertex_index), *vertex(indices[i].vertex_index),
                                 *vertex(indices[i + 1].vertex_index)});
            if (triangles.size() > most_triangles) {
                mistake = fmt::format("holds more than {} triangles; simplify the mesh", most_triangles);
            }
        }
    }
};

}  // namespace

std::vector<Triangle<double>> read_mesh(std::istream& obj, const std::string& name) {
    Reading reading;
    tinyobj::callback_t callback;
    callback.vertex_cb = [](void* user, double x, double y, double z, double /*w*/) {
        static_cast<Reading*>(user)->add_vertex(x, y, z);
    };
    callback.index_cb = [](void* user, tinyobj::index_t* indices, int count) {
        static_cast<Reading*>(user)->add_face(indices, count);
    };
    std::string warning;
    std::string error;
    const bool is_read = tinyobj::LoadObjWithCallback(obj, callback, &reading, nullptr, &warning, &error);
    if (!reading.mistake.empty()) throw AssignmentError(fmt::format("{}: {}", name, reading.mistake));
    if (!is_read) throw AssignmentError(fmt::format("{}: is no OBJ file: {}", name, error));
    if (reading.triangles.empty()) {
        throw AssignmentError(fmt::format("{}: holds no faces; is it a Wavefront OBJ file?", name));
    }
    return std::move(reading.triangles);
}

std::vector<Triangle<double>> load_mesh(const MeshFile& mesh) {
    const std::string name = fmt::format("{}: {}", mesh.place, mesh.path.string());
    std::error_code error;
    if (!std::filesystem::is_regular_file(mesh.path, error)) {
        throw AssignmentError(fmt::format("{}: no such file; a mesh is named from its scene's folder", name));
    }
    if (std::filesystem::file_size(mesh.path, error) > largest_mesh_file_bytes) {
        throw AssignmentError(
            fmt::format("{}: larger than {} MiB; simplify the mesh", name, largest_mesh_file_bytes >> 20U));
    }
    std::ifstream file(mesh.path, std::ios::binary);
    if (!file) throw AssignmentError(fmt::format("{}: can't be read; check its permissions", name));
    return read_mesh(file, name);
}

}  // namespace reference::render
