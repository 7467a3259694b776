// What marking a class anew changes beside the marks: what is told of other and hard scenes, sanitizers' findings,
// flags, and whatever else a report shows. Pure.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "harness/grade.h"

namespace harness {

/// A part of the feedback, and in how many submissions it is not as before.
struct PartChange {
    std::string part;    ///< "hard scenes", "flag hard_coded"
    std::string option;  ///< that gives it: "--stress"; empty for what each submission has
    std::size_t fresh = 0;
    std::size_t gone = 0;
    std::size_t other = 0;
};

struct FeedbackChanges {
    std::vector<PartChange> parts;  ///< those that changed
    std::size_t differing = 0;      ///< submissions whose marks are as before, but not their feedback
    std::size_t remeasured = 0;     ///< those of which nothing is another but time and memory
};

/// What became of the marks of a submission.
enum class Marks { same, moved };

/// Compares two gradings of one submission that are not alike. Where its marks moved, only what is new or gone counts:
/// that the rest is another goes without saying.
void add_feedback(FeedbackChanges& changes, const Graded& before, const Graded& after, Marks marks);

/// Adds those of other submissions.
void add(FeedbackChanges& changes, const FeedbackChanges& others);

}  // namespace harness
