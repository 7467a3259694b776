// A student's own page: the same content as feedback_markdown, for a browser.
#pragma once

#include <string>

#include "harness/record/graded.h"
#include "harness/record/marking.h"

namespace harness::report {

/// Self-contained: no script, no requests, safe under a strict Content-Security-Policy, and well-formed XML. Shows as
/// much as the rubric allows now, and expected values only with Feedback::expected.
std::string student_page(const Graded& graded, const Marking& marking);

}  // namespace harness::report
