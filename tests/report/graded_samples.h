// Graded submissions for the tests of the reports, without running anything.
#pragma once

#include <string>
#include <vector>

#include "harness/report/report.h"

namespace report_samples {

/// The off-axis scene.
const harness::Marking& marking();

/// The output of a program with one mistake that others follow from.
std::string output_with_a_mistake();

/// What grading a program with this output gives.
harness::Graded graded(const std::string& id, const std::string& output);

/// The program with a mistake, of whose 10 points for other scenes it has 6: 104.33 of 110.
harness::Graded graded_on_other_scenes(const std::string& id);

/// Ids, outputs, explanations, messages and notes as hostile as they get: backticks, pipes, ESC, invalid UTF-8,
/// formulas, HTML.
harness::Graded hostile();

/// Markup that would be an element of its own, even out of an attribute; another for each n.
std::string markup(int n);

/// Whatever a submission, its system, its compiler or an instructor's word brings into a page is markup(1) to
/// markup(last_markup): what nobody but the instructor is shown from `first_for_instructor` on.
harness::Graded markup_everywhere();
constexpr int first_for_instructor = 18;
constexpr int last_markup = 19;

/// What --variants finds where, on another scene, 6.t is `after` in place of `before`.
harness::variants::VariantReport broken_on_another_scene(const std::string& before, const std::string& after);

/// A submission that could not be graded.
harness::Graded not_graded(const std::string& id);

/// How each number of the key that is not a short decimal begins, however it is printed: its first three decimals.
std::vector<std::string> traces_of_key();

/// The output of a program that answers nothing rightly, for which no number of the key is an excuse.
std::string wrong_everywhere();

}  // namespace report_samples
