// Lines that say that there is no value.
#pragma once

#include <optional>
#include <string_view>

#include "harness/read/printed_value.h"

namespace harness {

/// Reads a label and words that say that there is no value: "t: none", "hit point = no hit", "N -> (not defined)".
std::optional<PrintedValue> read_no_value(std::string_view line);

/// Whether the line says that its number stands for "no value": "t = -1 (-1 means no hit)".
bool says_what_its_number_means(std::string_view line);

}  // namespace harness
