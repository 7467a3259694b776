// grades.json: the public format raygrade/grades/1. Text from submissions is escaped. Points are the final ones
// (final_mark.h), with the automatic points next to them where they differ. A class graded without a sandbox is marked
// as such.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "harness/record/graded.h"
#include "harness/record/marking.h"

namespace harness::report {

/// The format raygrade/grades/1, indented, with a final newline. `tier` is the sandbox that the programs ran in.
void write_grades_json(std::ostream& out, const std::vector<Graded>& graded, const Marking& marking, Tier tier);
std::string grades_json(const std::vector<Graded>& graded, const Marking& marking, Tier tier);

}  // namespace harness::report
