// The results of the hard scenes as JSON, for reports and for the gradebook.
#pragma once

#include <nlohmann/json.hpp>

#include "harness/grade/hard_scenes.h"

namespace harness::scenes {

/// {"survived": 9, "tried": 12, "not_found": ["vup"], "scenes": [...]}, each scene with the fields of HardResult.
/// `verdict` is survives, breaks or skipped.
nlohmann::ordered_json hard_scenes_json(const HardScenesReport& report);

/// Reads what hard_scenes_json wrote. Throws nlohmann::json::exception or std::invalid_argument for anything else.
HardScenesReport hard_scenes_from_json(const nlohmann::json& json);

}  // namespace harness::scenes
