// The marking in words, for the reports that hold one text a question or an answer. Control bytes are escaped.
#pragma once

#include <string>

#include "harness/grade.h"

namespace harness::report {

/// Whether it has all its points, or where there are none to have, is right.
bool is_passed(double points, double max_points, ItemVerdict verdict);

/// What the instructor says in place of an automatic mark, a line; empty for none.
std::string override_text(const Override* override_);

/// One answer: its verdict, what was printed, what is wrong with it, what the instructor says; lines, each ended. The
/// right value only where the rubric says that students may see it.
std::string item_text(const Graded& graded, const QuestionScore& question, const ItemScore& item,
                      const Marking& marking);

/// What the program did on other scenes and what the instructor says of it, lines, each ended.
std::string scenes_text(const Graded& graded);

/// What concerns the submission as a whole: points, a late hand-in, how it ended, notes, the compiler's messages.
std::string submission_text(const Graded& graded);

/// At most `longest` bytes, the characters whole, and a last line that says where something was left out.
std::string bounded(std::string text, std::size_t longest);

}  // namespace harness::report
