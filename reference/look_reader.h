// The optional tables of a scene: light, material, mesh, render.
#pragma once

#include "reference/look.h"
#include "reference/toml_table.h"

namespace reference {

/// `path` is the scene file's, for the meshes beside it, which are not opened here. Throws AssignmentError, which names
/// file, line and key and says the cure, for a number out of its range in look.h or beyond 1e30 in size, a direction
/// that is zero, a material that is not there or there twice.
Look read_look(const TomlTable& root, const std::filesystem::path& path);

}  // namespace reference
