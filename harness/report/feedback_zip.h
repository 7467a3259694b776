// Students' pages on their way back through the learning management system that their hand-ins came from.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "harness/grade.h"

namespace harness::report {

/// What the page of a submission is called in the zip, so that the system gives it to its student and nobody else:
///   Canvas: "doejane_LATE_1001_5001_feedback.html". It takes the first two fields between '_' that are digits for its
///     numbers of the student and of a file in the student's hand-in, so the name before them has no '_' of its own.
///   Moodle: "Jane Doe_123_assignsubmission_file/feedback.html". It takes the second field for the participant
///     (mod/assign/feedback/file/importziplib.php), so again.
/// Empty where there is no way back: not from such a system, or nothing in Canvas to attach it to.
std::optional<std::string> way_back(const Submission& submission);

struct FeedbackZip {
    std::size_t pages = 0;
    std::vector<std::string> left_out;  ///< "id: why": those of Canvas and Moodle whose page is not in it
};

/// Writes the zip with student_page of each submission that has a way back, in their order. The same submissions make
/// the same bytes at any time and anywhere. Two submissions with one student's number are both left out: which of them
/// is that student's nobody can tell. Throws HarnessError.
FeedbackZip write_feedback_zip(std::ostream& out, const std::vector<Graded>& graded, const Marking& marking);

/// Whether any of them came from Canvas or Moodle, so that there is something to return.
bool is_from_lms(const std::vector<Graded>& graded);

}  // namespace harness::report
