// A student's own page: the same marking as feedback_markdown, for a browser.
#pragma once

#include <string>

#include "harness/grade.h"

namespace harness::report {

/// A whole page, self-contained: no script, no request, safe under a strict Content-Security-Policy. Never an expected
/// value unless the rubric says so (Rubric::show_expected).
std::string student_page(const Graded& graded, const Marking& marking);

}  // namespace harness::report
