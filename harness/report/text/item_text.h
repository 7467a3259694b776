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

/// Complete lines about one answer: its verdict, what was printed, what is wrong with it, and an override. Tells what
/// the rubric lets students know now, such as the right value, but no more than `most`.
std::string item_text(const Graded& graded, const QuestionScore& question, const ItemScore& item,
                      const Marking& marking, reference::Feedback most = reference::Feedback::expected);

/// Complete lines about other scenes: what the program did on them, and an override.
std::string scenes_text(const Graded& graded);

/// The points of the whole, or that there are none, and a late hand-in.
std::string mark_text(const Graded& graded);
/// How the program was built and how it ran: how it ended, notes, flags, the compiler's messages.
std::string run_text(const Graded& graded);
/// The instructor's comments.
std::string comments_text(const Graded& graded);
/// All of these, and an override of the whole.
std::string submission_text(const Graded& graded);

/// At most `longest` bytes, cut between characters; a cut text ends in a line that says so.
std::string bounded(std::string text, std::size_t longest);

}  // namespace harness::report
