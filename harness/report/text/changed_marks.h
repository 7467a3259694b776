// The changes that a regrade makes, for an instructor to read before applying them.
#pragma once

#include <string>

#include "harness/gradebook/changed_feedback.h"
#include "harness/gradebook/changed_marks.h"

namespace harness::report {

/// One line, with reasons, for each submission whose mark rises or falls, that is new or gone, or that has the same
/// mark for other reasons; empty if there is none. A change to most of the class, for example by a new rubric, appears
/// once, before the submissions that differ from it.
std::string changes_text(const ClassChanges& changes);

/// "2 rise, 1 falls, 26 stay as they are." and any other changes. Always says how many rise, fall and stay.
std::string changes_summary(const ClassChanges& changes);

/// "Apart from the marks, by number of submissions: hard scenes new in 3; answers changed in 5." Ends in a newline;
/// empty if nothing changed.
std::string feedback_changes_text(const FeedbackChanges& changes);

}  // namespace harness::report
