// The instructor's page about a class.
#pragma once

#include <iosfwd>
#include <vector>

#include "harness/grade/graded.h"
#include "harness/grade/marking.h"

namespace harness::report {

/// Writes a self-contained page: it loads nothing, its policy allows its script and style by their hashes, and
/// everything can be read without the script. The page holds the right answers. It is written student by student, so
/// that a thousand students take no more memory than one.
void write_class_report(std::ostream& out, const std::vector<Graded>& graded, const Marking& marking, Tier tier);

}  // namespace harness::report
