// How an assignment is marked, from the table [rubric].
#pragma once

#include "reference/toml/assignment.h"
#include "reference/toml/toml_table.h"

namespace reference {

/// Throws AssignmentError for an unknown key or a value out of its range.
Rubric read_rubric(const TomlTable& table);

}  // namespace reference
