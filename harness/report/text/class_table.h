// The class as a table for a terminal, and the list of submissions to review. Text from submissions is escaped.
// Points are the final ones (final_mark.h), with the automatic points next to them where they differ. A class graded
// without a sandbox is marked as such.
#pragma once

#include <string>
#include <vector>

#include "harness/record/graded.h"
#include "harness/text/color.h"

namespace harness::report {

/// The class table with the open flags, and the summary by question. Ends in a newline; empty for an empty class.
std::string class_table(const std::vector<Graded>& graded, Colors colors = Colors::none);

/// Which submissions a person should review and why, and which were not graded. `way` is the command that starts the
/// review. Ends in a newline; empty if there is nothing to review.
std::string needs_a_person(const std::vector<Graded>& graded, const std::string& way, Colors colors = Colors::none);

}  // namespace harness::report
