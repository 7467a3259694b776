// A student's own page: the same marking as feedback_markdown, for a browser.
#pragma once

#include <string>

#include "harness/record/graded.h"
#include "harness/record/marking.h"

namespace harness::report {

/// Self-contained: no script, no request, safe under a strict Content-Security-Policy, well-formed as XML too. Tells as
/// much as the rubric lets be told now: no expected values unless it shows them (Feedback::expected).
std::string student_page(const Graded& graded, const Marking& marking);

}  // namespace harness::report
