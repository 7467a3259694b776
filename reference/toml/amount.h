// Points and shares in an assignment file.
#pragma once

#include <string_view>

#include "reference/toml/toml_table.h"

namespace reference {

constexpr double most_points = 1e6;

/// A finite number in [least, most]. Throws AssignmentError for any other.
double read_amount(const TomlTable& table, std::string_view key, double least, double most);

}  // namespace reference
