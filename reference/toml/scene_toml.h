// Writes a scene as the TOML tables of an assignment file, and checks a changed scene like one that was read.
#pragma once

#include <filesystem>
#include <string>

#include "reference/numbers/decimal.h"
#include "reference/numbers/vector.h"
#include "reference/stages/scene.h"

namespace reference {

/// A field of a scene as written in a file: "2", "[0, 1, 0]", or three such points.
std::string toml_value(const Decimal& x);
std::string toml_value(const Vec3<Decimal>& p);
std::string toml_value(const Vertices<const Vec3<Decimal>>& vertices);

/// The tables [camera], [window], and one for each object.
std::string scene_toml(const Scene<Decimal>& scene);

/// Returns the scene if read_scene accepts it. Throws AssignmentError, in which `path` names the scene.
Scene<Decimal> check_scene(const Scene<Decimal>& scene, const std::filesystem::path& path);

}  // namespace reference
