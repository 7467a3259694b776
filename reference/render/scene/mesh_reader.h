// Meshes from Wavefront OBJ files: vertices and faces. Everything else in them is ignored, including materials.
#pragma once

#include <istream>
#include <string>
#include <vector>

#include "reference/stages/scene.h"
#include "reference/toml/appearance.h"

namespace reference::render {

constexpr std::size_t largest_mesh_file_bytes = std::size_t{1} << 28U;
constexpr std::size_t most_triangles = std::size_t{1} << 22U;

/// A coordinate is the double nearest to its text. A face of more than three vertices becomes a fan of triangles around
/// its first. Throws AssignmentError, which begins with `name` and says how to fix it, for a vertex without three
/// numbers, for a face with fewer than three vertices or with a vertex that does not exist, for a coordinate beyond
/// 1e30 in size, and for more than most_triangles or no faces at all.
std::vector<Triangle<double>> read_mesh(std::istream& obj, const std::string& name);

/// From a file of at most largest_mesh_file_bytes.
std::vector<Triangle<double>> load_mesh(const MeshFile& mesh);

}  // namespace reference::render
