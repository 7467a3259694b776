// Feedback for students: as Markdown, and the self-check on a terminal. Text from submissions is escaped. Points are
// the final ones (final_mark.h), with the automatic points next to them where they differ. A class graded without a
// sandbox is marked as such.
#pragma once

#include <string>

#include "harness/record/graded.h"
#include "harness/record/marking.h"
#include "harness/text/color.h"

namespace harness::report {

/// A student's feedback as Markdown: points and, for each lost mark, question, line, printed value and mistake. Never
/// an expected value.
std::string feedback_markdown(const Graded& graded, const Marking& marking);

/// The same for a student's self-check on a terminal: a verdict for every item, with the reason as far as `feedback`
/// allows. Never an expected value.
std::string check_text(const Graded& graded, reference::Feedback feedback = reference::Feedback::mistake,
                       Colors colors = Colors::none);

}  // namespace harness::report
