// The options of `raygrade grade`.
#pragma once

#include "harness/commands.h"

namespace harness {

void add_grade_options(CLI::App& command, GradeOptions& options);

}  // namespace harness
