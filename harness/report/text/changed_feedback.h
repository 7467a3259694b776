// What a regrade changes apart from the marks, for an instructor to read before applying it.
#pragma once

#include <string>

#include "harness/gradebook/changed_feedback.h"

namespace harness::report {

/// "Apart from the marks, by number of submissions: hard scenes new in 3; answers changed in 5." Ends in a newline;
/// empty if nothing changed.
std::string feedback_changes_text(const FeedbackChanges& changes);

}  // namespace harness::report
