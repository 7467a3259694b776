// grades.csv: one row per submission. Text from submissions is escaped. Points are the final ones (final_mark.h), with
// the automatic points next to them where they differ. A class graded without a sandbox is marked as such.
#pragma once

#include <string>
#include <vector>

#include "harness/record/graded.h"

namespace harness::report {

/// One row per submission, as RFC 4180 with a header: id, outcome, points, max_points, points by question, explanation,
/// sandbox, automatic points, late deduction, the places of overrides and, if the rubric gives any, the points for
/// other scenes. A cell that a spreadsheet would read as a formula begins with an apostrophe.
std::string grades_csv(const std::vector<Graded>& graded);

}  // namespace harness::report
