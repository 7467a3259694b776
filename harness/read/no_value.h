// Lines that say that there is no value.
#pragma once

#include <optional>
#include <string_view>

#include "harness/read/printed_value.h"

namespace harness {

/// Reads words that say that there is no value, and the label before them if there is one: "t: none", "t is none",
/// "N -> (not defined)", "it is not hit".
std::optional<PrintedValue> read_no_value(std::string_view line);

/// Reads what a line with a discriminant says of the hit: "d = -91 < 0, so no intersection".
std::optional<PrintedValue> read_no_value_after_discriminant(std::string_view line);

/// Whether the line says that its number stands for "no value": "t = -1 (-1 means no hit)".
bool says_what_its_number_means(std::string_view line);

}  // namespace harness
