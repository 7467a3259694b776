// Marks as a test report: what continuous integration and editors show.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "harness/grade.h"

namespace harness::report {

/// JUnit XML: a testsuite for each submission, in their order, with points, max_points, outcome and, from Canvas,
/// late as its properties, and in it a testcase for whether it compiles, one for whether it runs to its end, and one
/// for each answer, called as its item and of the class "<id>.question 6". An answer fails that lacks points; where the
/// program does not compile, the others are skipped. A submission that was not graded has one testcase with an error.
/// No expected values, unless the rubric shows them. What XML can't hold is made visible.
void write_junit(std::ostream& out, const std::vector<Graded>& graded, const Marking& marking);
std::string junit(const std::vector<Graded>& graded, const Marking& marking);

}  // namespace harness::report
