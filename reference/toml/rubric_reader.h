// How an assignment is marked, from the table [rubric].
#pragma once

#include "reference/assignment.h"
#include "reference/toml_table.h"

namespace reference {

/// Throws AssignmentError for a key that is not one and a value out of its range.
Rubric read_rubric(const TomlTable& table);

}  // namespace reference
