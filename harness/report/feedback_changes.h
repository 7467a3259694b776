// What a regrade changes beside the marks, for an instructor to read before it is applied.
#pragma once

#include <string>

#include "harness/feedback_changes.h"

namespace harness::report {

/// "Beside the marks: hard scenes new in 3; flag hard_coded gone from 1 (see --variants)." Ends in a newline;
/// empty where nothing is another.
std::string feedback_changes_text(const FeedbackChanges& changes);

}  // namespace harness::report
