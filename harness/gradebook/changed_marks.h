// What marking a class anew changes: who rises, who falls, and why. Pure; both sides with the instructor's overrides.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "harness/grade.h"

namespace harness {

/// What became of one submission. The points are those that count, empty where there are none.
struct MarkChange {
    std::string id;
    std::optional<double> before, after;
    std::vector<std::string> reasons;  ///< "another source", "6.t wrong -> right (+1.67)"; none when nothing changed
    double most_before = 0, most_after = 0;  ///< the points there are in all
};

struct ClassChanges {
    std::vector<MarkChange> rising;          ///< in the order of the class, as all of these
    std::vector<MarkChange> falling;         ///< also what had a mark and has none any more
    std::vector<MarkChange> level;           ///< the same mark, but something of it changed
    std::vector<MarkChange> fresh;           ///< without anything before
    std::vector<MarkChange> gone;            ///< no longer among the submissions
    std::size_t untouched = 0;               ///< how many are as they were
    double most_before = 0, most_after = 0;  ///< the points there are in all; the same where nothing is to be compared
};

/// Whether two marks are the same, as far as a millionth of a point.
bool is_same_mark(const std::optional<double>& one, const std::optional<double>& other);

/// Compares two gradings of one submission.
MarkChange change_between(const Graded& before, const Graded& after);

/// Files it under what it does to the mark.
void add(ClassChanges& changes, MarkChange change);

/// An assignment as it was when a class was graded.
struct AssignmentText {
    std::string name;
    std::string toml;
};

/// What has changed in the assignment since `before`, as a sentence; empty when its text is the same.
std::string assignment_change(const AssignmentText& before, const AssignmentText& after, const Marking& marking);

}  // namespace harness
