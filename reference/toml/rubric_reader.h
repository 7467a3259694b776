// Reads the marking rules from the table [rubric].
#pragma once

#include "reference/toml/questions_reader.h"
#include "reference/toml/rubric.h"
#include "reference/toml/toml_table.h"

namespace reference {

/// The questions' points and the settings of [rubric], if the file has one. Throws AssignmentError for an unknown key,
/// a question that is not asked or a value out of its range.
Rubric read_rubric(const TomlTable& root, const ReadQuestions& asked);

}  // namespace reference
