// Finds the changes of a regrade in the marks: who gains, who loses, and why. Pure. Both gradings include the
// instructor's overrides.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "harness/record/graded.h"
#include "harness/record/marking.h"

namespace harness {

/// How the mark of one submission changed. `before` and `after` are the points that count; empty if it has no mark.
struct MarkChange {
    std::string id;
    std::string label;  ///< the submission's name for people; its id if nothing else is known
    std::optional<double> before, after;
    std::vector<std::string> reasons;  ///< "another source", "6.t wrong -> right (+1.67)"; none when nothing changed
    double most_before = 0, most_after = 0;  ///< the maximum points
};

struct ClassChanges {
    std::vector<MarkChange> rising;          ///< in the order of the class, like the other lists
    std::vector<MarkChange> falling;         ///< also submissions that lost their mark
    std::vector<MarkChange> level;           ///< the same mark, but something else changed
    std::vector<MarkChange> fresh;           ///< not graded before
    std::vector<MarkChange> gone;            ///< no longer among the submissions
    std::size_t untouched = 0;               ///< number of unchanged submissions
    double most_before = 0, most_after = 0;  ///< the maximum points; equal if nothing was compared
};

/// Whether two marks are the same to within a millionth of a point.
bool is_same_mark(const std::optional<double>& one, const std::optional<double>& other);

/// Compares two gradings of one submission.
MarkChange change_between(const Graded& before, const Graded& after);

/// Adds the change to the list for its effect on the mark.
void add(ClassChanges& changes, MarkChange change);

/// An assignment at the time when a class was graded.
struct AssignmentText {
    std::string name;
    std::string toml;
};

/// The changes in the assignment since `before`, as a sentence; empty if its text is the same.
std::string assignment_change(const AssignmentText& before, const AssignmentText& after, const Marking& marking);

}  // namespace harness
