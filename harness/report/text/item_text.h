// The marking in words, for reports with one text per question or answer. Control bytes are escaped.
#pragma once

#include <string>
#include <vector>

#include "harness/record/graded.h"
#include "harness/record/marking.h"

namespace harness::report {

/// Whether it has full points or, if it is worth no points, is right or follows.
bool is_passed(double points, double max_points, ItemVerdict verdict);

/// One line with the instructor's override; empty if there is none.
std::string override_text(const Override* override_);

/// Complete lines about one answer: its verdict, the printed value, the mistake, and an override. Shows as much as the
/// rubric lets students know now, such as the right value, but no more than `most`. `said` is the last sentence about a
/// consistent answer in the same question; the function does not repeat it.
std::string item_text(const Graded& graded, const QuestionScore& question, const ItemScore& item,
                      const Marking& marking, reference::Feedback most = reference::Feedback::expected,
                      std::string* said = nullptr);

/// A question, or the other scenes, in the form of a test for another system.
struct TestText {
    std::string name;  ///< "Question 6: ray and sphere"
    int number = 0;    ///< the question's number; for the other scenes, the last question's number plus one
    double points = 0, max_points = 0;
    bool is_passed = false;
    std::string text;  ///< complete lines
};
/// One per question, then the other scenes if the rubric gives points for them.
std::vector<TestText> test_texts(const Graded& graded, const Marking& marking,
                                 reference::Feedback most = reference::Feedback::expected);
/// Complete lines about the other scenes: the program's results on them, and an override.
std::string scenes_text(const Graded& graded);

/// The total points, or that there are none; lateness; and the instructor's comments.
std::string mark_text(const Graded& graded);
/// How the program was built and run: how it ended, notes, flags, compiler messages.
std::string run_text(const Graded& graded);
/// mark_text and run_text together.
std::string submission_text(const Graded& graded);

/// At most `longest` bytes, cut between characters. If the text is cut, its last line says so.
std::string bounded(std::string text, std::size_t longest);

}  // namespace harness::report
