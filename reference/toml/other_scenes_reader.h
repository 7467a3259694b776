// Other scenes for the same program, from the tables [[variant]].
#pragma once

#include "reference/toml/assignment.h"
#include "reference/toml/toml_table.h"

namespace reference {

/// Each table [[variant]] holds tables named like the scene's, with those keys that differ from `scene`: camera.eye,
/// camera.lookat, camera.vup, window.pixel, sphere.center, sphere.radius, triangle.vertices (of the first sphere and
/// the first triangle), and may have a name. Throws AssignmentError for anything else, for a variant that changes
/// nothing, and for a scene that can't be marked. `path` names the file.
std::vector<OtherScene> read_other_scenes(const TomlTable& root, const Scene<Decimal>& scene,
                                          const std::filesystem::path& path);

}  // namespace reference
