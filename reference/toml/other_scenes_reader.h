// Other scenes for the same program, from the tables [[variant]].
#pragma once

#include "reference/assignment.h"
#include "reference/toml_table.h"

namespace reference {

/// Each table [[variant]] holds tables named like the scene's, with those keys that differ from `scene`: camera.eye,
/// camera.lookat, camera.vup, window.pixel, sphere.center, sphere.radius, triangle.vertices (of the first sphere and
/// the first triangle), and may have a name. Throws AssignmentError for anything else, for a variant that changes
/// nothing, and for a scene that can't be marked. `path` names the file.
std::vector<SceneVariant> read_variants(const TomlTable& root, const Scene<Decimal>& scene,
                                        const std::filesystem::path& path);

}  // namespace reference
