// Writes a scene as the TOML tables of an assignment file, and puts a changed scene to the same checks as a scene that
// was read.
#pragma once

#include <filesystem>
#include <string>

#include "reference/toml/assignment.h"

namespace reference {

/// The tables [camera], [window], [[sphere]] and [[triangle]].
std::string scene_toml(const Scene<Decimal>& scene);

/// Returns the scene if read_scene accepts it. Throws AssignmentError, in which `path` names the scene.
Scene<Decimal> check_scene(const Scene<Decimal>& scene, const std::filesystem::path& path);

}  // namespace reference
