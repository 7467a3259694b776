// Reads scenes other than the assignment's: for the same program, from the tables [[variant]], and for single students,
// from the tables [[student]].
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "reference/numbers/decimal.h"
#include "reference/stages/scene.h"
#include "reference/toml/toml_table.h"
#include "reference/toml/variant.h"

namespace reference {

/// Each table [[variant]] contains tables named like the scene's, with those keys that differ from `scene`: camera.eye,
/// camera.lookat, camera.vup, window.pixel and the fields of the first object of each kind (sphere.center, …), and may
/// have a name. Throws AssignmentError for anything else, for a variant that changes nothing, and for a scene that
/// can't be marked. `path` names the file.
std::vector<Variant> read_variants(const TomlTable& root, const Scene<Decimal>& scene,
                                   const std::filesystem::path& path);

/// Each table [[student]] contains an id and the same tables as a [[variant]]; it may change nothing. Throws
/// AssignmentError for the same errors, and for a repeated id.
std::map<std::string, Scene<Decimal>> read_dealt_scenes(const TomlTable& root, const Scene<Decimal>& scene,
                                                        const std::filesystem::path& path);

}  // namespace reference
