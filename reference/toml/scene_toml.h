// A scene as the tables that an assignment's file states it by, and a scene that was changed put to the same tests as
// one that was read.
#pragma once

#include <filesystem>
#include <string>

#include "reference/assignment.h"

namespace reference {

/// The tables [camera], [window], [[sphere]] and [[triangle]].
std::string scene_toml(const Scene<Decimal>& scene);

/// The scene itself, if read_scene takes it. Throws AssignmentError, in which `path` names the scene.
Scene<Decimal> check_scene(const Scene<Decimal>& scene, const std::filesystem::path& path);

}  // namespace reference
