// The optional tables of a scene: light, material, render.
#pragma once

#include "reference/toml/appearance.h"
#include "reference/toml/toml_table.h"

namespace reference {

/// Throws AssignmentError, which names file, line and key and says how to fix it, for a number outside its range in
/// appearance.h or beyond 1e30 in size, a zero direction, or a material that is missing or defined twice.
Appearance read_appearance(const TomlTable& root);

}  // namespace reference
