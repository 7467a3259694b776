// The results of the hard scenes as JSON, for reports and for the gradebook.
#pragma once

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "harness/record/hard_scenes.h"

namespace harness {

/// The exact number. Throws std::invalid_argument if it is not a whole number or does not fit the type; get() would
/// convert it to some other number.
template <class Whole>
Whole whole_number(const nlohmann::json& number) {
    if (number.is_number_unsigned()) {
        const auto value = number.get<std::uint64_t>();
        if (std::in_range<Whole>(value)) return static_cast<Whole>(value);
    } else if (number.is_number_integer()) {
        const auto value = number.get<std::int64_t>();
        if (std::in_range<Whole>(value)) return static_cast<Whole>(value);
    }
    throw std::invalid_argument("a number beyond its type");
}

/// {"survived": 9, "tried": 12, "not_found": ["vup"], "scenes": [...]}, each scene with the fields of HardResult.
/// `verdict` is survives, breaks or skipped.
nlohmann::ordered_json hard_scenes_json(const HardScenesReport& report);

/// Reads the output of hard_scenes_json. Throws nlohmann::json::exception or std::invalid_argument for anything else.
HardScenesReport hard_scenes_from_json(const nlohmann::json& json);

}  // namespace harness
