// The assignment's part of the reports.
#pragma once

#include <string>

#include "reference/accuracy/measure/assignment_accuracy.h"

namespace harness::report {

/// For a terminal, and for the page.
std::string assignment_text(const reference::accuracy::AssignmentAccuracy& assignment);

}  // namespace harness::report
