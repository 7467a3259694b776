// Marks as a test report: for continuous integration and editors.
#pragma once

#include <string>
#include <string_view>

#include "harness/record/graded.h"
#include "harness/record/marking.h"

namespace harness::report {

/// Appears in the first 1,000 bytes of each report, whatever students write into it. Needed because other programs
/// write JUnit XML too.
inline constexpr std::string_view junit_mark = "<!-- JUnit XML of raygrade -->";

/// JUnit XML: a test suite with the properties points, max_points, outcome and, if known, late. It has a test case for
/// whether the program compiles, one for whether it runs to its end, and one per answer, named like its item, in the
/// class "<id>.question 6". An answer with less than full points fails. If the program does not compile, the other test
/// cases are skipped. A submission that was not graded has a single test case, with an error unless it was marked by
/// hand. No expected values unless the rubric shows them. Characters that XML does not allow are made visible.
std::string junit(const Graded& graded, const Marking& marking);

}  // namespace harness::report
