// What a regrade changes, for an instructor to read before applying it.
#pragma once

#include <string>

#include "harness/gradebook/changed_feedback.h"
#include "harness/gradebook/changed_marks.h"

namespace harness::report {

/// A line with the reasons for each submission that rises, falls, is new, is gone, or has the same mark for other
/// reasons; empty if there is none. What changes for most of the class, as by a changed rubric, appears once, before
/// whoever differs from it.
std::string changes_text(const ClassChanges& changes);

/// "2 rise, 1 falls, 26 stay as they are." and what else changed; always says how many rise, fall and stay.
std::string changes_summary(const ClassChanges& changes);

/// "Apart from the marks, by number of submissions: hard scenes new in 3; answers changed in 5." Ends in a newline;
/// empty if nothing changed.
std::string feedback_changes_text(const FeedbackChanges& changes);

}  // namespace harness::report
