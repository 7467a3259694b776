// The marking in words, for the reports that hold one text per question or answer. Control bytes are escaped.
#pragma once

#include <string>
#include <vector>

#include "harness/record/graded.h"
#include "harness/record/marking.h"

namespace harness::report {

/// Whether it has all its points or, if it is worth none, is right or follows.
bool is_passed(double points, double max_points, ItemVerdict verdict);

/// One line with the instructor's override; empty if there is none.
std::string override_text(const Override* override_);

/// Complete lines about one answer: its verdict, what was printed, what is wrong with it, and an override. Tells what
/// the rubric lets students know now, such as the right value, but no more than `most`. `said` is the last sentence
/// about a consistent answer of the same question, which is not repeated.
std::string item_text(const Graded& graded, const QuestionScore& question, const ItemScore& item,
                      const Marking& marking, reference::Feedback most = reference::Feedback::expected,
                      std::string* said = nullptr);

/// A question or the other scenes, as a test of another system.
struct TestText {
    std::string name;  ///< "Question 6: ray and sphere"
    int number = 0;    ///< the question's; of the other scenes, one after the last question's
    double points = 0, max_points = 0;
    bool is_passed = false;
    std::string text;  ///< complete lines
};
/// By question, then the other scenes if the rubric gives points for them.
std::vector<TestText> test_texts(const Graded& graded, const Marking& marking,
                                 reference::Feedback most = reference::Feedback::expected);
/// Complete lines about other scenes: what the program did on them, and an override.
std::string scenes_text(const Graded& graded);

/// The points of the whole, or that there are none, a late submission, and what the instructor says.
std::string mark_text(const Graded& graded);
/// How the program was built and how it ran: how it ended, notes, flags, the compiler's messages.
std::string run_text(const Graded& graded);
/// Both.
std::string submission_text(const Graded& graded);

/// At most `longest` bytes, cut between characters; a cut text ends in a line that says so.
std::string bounded(std::string text, std::size_t longest);

}  // namespace harness::report
