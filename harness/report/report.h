// What instructors and students get to read. All text from a submission is escaped here: control bytes, invalid UTF-8,
// Markdown.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "harness/grade.h"

namespace harness::report {

// Marks that were made without a sandbox say so in every one of them.

// Their points are those that count (final_mark.h), with the automatic ones beside them where they differ.

/// The class table and the summary by question, for a terminal. Ends in a newline.
std::string class_table(const std::vector<Graded>& graded);

/// The format raygrade/grades/1, indented, with a final newline. `tier` is what the programs ran under.
void write_grades_json(std::ostream& out, const std::vector<Graded>& graded, const Marking& marking, Tier tier);
std::string grades_json(const std::vector<Graded>& graded, const Marking& marking, Tier tier);

/// One row a submission, RFC 4180 with a header: id, outcome, points, max_points, the points by question, the
/// explanation, the sandbox, the automatic points, what is taken off for lateness and where marks are overridden, and
/// what other scenes give where the rubric gives points for them. A cell that a spreadsheet would take for a formula
/// begins with an apostrophe.
std::string grades_csv(const std::vector<Graded>& graded);

/// A student's feedback as Markdown: points and, for each lost mark, question, line, what was printed and what is wrong
/// with it. Never an expected value.
std::string feedback_markdown(const Graded& graded, const Marking& marking);

/// The same marking for a student's own check, on a terminal: a verdict for every item, with the reason. Never an
/// expected value.
std::string check_text(const Graded& graded);

/// Points as people write them: at most two decimals, no trailing zeros.
std::string points_text(double points);

/// Why an item lost its mark or was accepted in another form, as sentences; empty for a plainly right one.
std::string item_sentence(const ItemScore& item, Outcome outcome);

/// What the rubric gives for answers on other scenes: "Other scenes: 4 of 5 points." It must give some.
std::string scenes_sentence(const Graded& graded);

/// That the rubric's cap on follow-through, in points, has cut some.
std::string cap_sentence(double cap);

/// Why a submission has no marks, for its student, whom neither the machine's troubles nor its folders concern; the
/// instructor has both in the class table. May hold the student's own file names.
std::string reason_for_student(const Submission& submission);

/// What a flag says, for a person.
std::string flag_title(const Flag& flag);

}  // namespace harness::report
