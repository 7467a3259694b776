// What the hard scenes showed, as JSON: for reports, and for the gradebook to keep.
#pragma once

#include <nlohmann/json.hpp>

#include "harness/stress/stress_report.h"

namespace harness::stress {

/// {"survived": 9, "tried": 12, "not_found": ["vup"], "scenes": [...]}, each scene with what HardResult has; `verdict`
/// is survives, breaks or skipped.
nlohmann::ordered_json stress_json(const StressReport& report);

/// What stress_json wrote. Throws nlohmann::json::exception or std::invalid_argument for anything else.
StressReport stress_from_json(const nlohmann::json& json);

}  // namespace harness::stress
