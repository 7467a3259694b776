// The marking in words, for the reports that hold one text per question or answer. Control bytes are escaped.
#pragma once

#include <string>

#include "harness/record/graded.h"
#include "harness/record/marking.h"

namespace harness::report {

/// Whether it has all its points or, if it is worth none, is right or follows.
bool is_passed(double points, double max_points, ItemVerdict verdict);

/// One line with the instructor's override; empty if there is none.
std::string override_text(const Override* override_);

/// Complete lines about one answer: its verdict, what was printed, what is wrong with it, and an override. The right
/// value only if the rubric lets students see it.
std::string item_text(const Graded& graded, const QuestionScore& question, const ItemScore& item,
                      const Marking& marking);

/// Complete lines about other scenes: what the program did on them, and an override.
std::string scenes_text(const Graded& graded);

/// What concerns the submission as a whole: points, a late hand-in, how it ended, notes, the compiler's messages.
std::string submission_text(const Graded& graded);

/// At most `longest` bytes, cut between characters; a cut text ends in a line that says so.
std::string bounded(std::string text, std::size_t longest);

}  // namespace harness::report
