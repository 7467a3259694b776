// What a regrade changes, for an instructor to read before it is applied.
#pragma once

#include <string>

#include "harness/class_changes.h"

namespace harness::report {

/// A line for each submission that rises, falls, is new or gone, or has the same mark for other reasons, each with its
/// reasons; empty when there is none.
std::string changes_text(const ClassChanges& changes);

/// "2 rise, 1 falls, 26 stay as they are." with whatever else there is, always with how many fall.
std::string changes_summary(const ClassChanges& changes);

}  // namespace harness::report
