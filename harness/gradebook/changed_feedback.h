// Finds the changes of a regrade apart from the marks: feedback on other and hard scenes, sanitizer findings, flags,
// and everything else a report shows. Pure.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "harness/record/graded.h"

namespace harness {

/// A part of the feedback, and in how many submissions it is new (`fresh`), gone or different (`other`).
struct PartChange {
    std::string part;    ///< "hard scenes", "flag hard_coded"
    std::string option;  ///< the option that adds this part: "--stress"; empty if none does
    std::size_t fresh = 0;
    std::size_t gone = 0;
    std::size_t other = 0;
};

struct FeedbackChanges {
    std::vector<PartChange> parts;  ///< those that changed
    std::size_t differing = 0;      ///< submissions with the same marks but different feedback
    std::size_t remeasured = 0;     ///< submissions in which only time and memory differ
};

/// Whether the marks of a submission changed.
enum class Marks { same, moved };

/// Compares two gradings of one submission whose records differ, and adds the differences. If its marks changed, only
/// new and removed parts count, because the other parts are then expected to differ.
void add_feedback(FeedbackChanges& changes, const Graded& before, const Graded& after, Marks marks);

}  // namespace harness
