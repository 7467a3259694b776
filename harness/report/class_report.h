// The instructor's page about a class.
#pragma once

#include <iosfwd>
#include <vector>

#include "harness/grade.h"

namespace harness::report {

/// A whole page, self-contained: it asks for nothing, its one script and its style are let through by their hashes, and
/// without the script everything can still be read. It holds the right answers. Written student by student, so that a
/// thousand take no more memory than one.
void write_class_report(std::ostream& out, const std::vector<Graded>& graded, const Marking& marking, Tier tier);

}  // namespace harness::report
