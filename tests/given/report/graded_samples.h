// Graded submissions for the tests of the reports. Nothing is run to make them.
#pragma once

#include <string>
#include <vector>

#include "harness/grade/graded.h"
#include "harness/grade/marking.h"

namespace report_samples {

/// The off-axis scene.
const harness::Marking& marking();

/// The output of a program with one mistake, from which further wrong answers follow.
std::string output_with_a_mistake();

/// The grading of a program with this output.
harness::Graded graded(const std::string& id, const std::string& output);

/// The program with a mistake, with 6 of 10 points for other scenes: 104.33 of 110 in all.
harness::Graded graded_on_other_scenes(const std::string& id);

/// A submission with hostile ids, outputs, explanations, messages and notes: backticks, pipes, ESC, invalid UTF-8,
/// spreadsheet formulas, HTML.
harness::Graded hostile();

/// Markup that would become an element if it were not escaped, even inside an attribute. Each n gives different markup.
std::string markup(int n);

/// Every text that the submission, the learning management system, the compiler or the instructor brings into a page is
/// one of markup(1) to markup(last_markup). From `first_for_instructor` on, only the instructor may see the text.
harness::Graded markup_everywhere();
constexpr int first_for_instructor = 18;
constexpr int last_markup = 19;

/// The finding of --variants for a program that prints `after` instead of `before` for 6.t on another scene.
harness::scenes::OtherScenesReport broken_on_another_scene(const std::string& before, const std::string& after);

/// A submission that could not be graded.
harness::Graded not_graded(const std::string& id);

/// Three submissions that together show most of what a report has: one with points for other scenes that was handed in
/// late and changed by the instructor, one that crashed, and one that could not be graded.
std::vector<harness::Graded> telling_class();

/// The first three decimals of each number of the key that is not a short decimal. Any printout of the number has them.
std::vector<std::string> traces_of_key();

/// The output of a program that has every answer wrong, so no number of the key may occur in its feedback.
std::string wrong_everywhere();

}  // namespace report_samples
