// Returns students' pages through the learning management system that their submissions came from.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "harness/record/graded.h"
#include "harness/record/marking.h"

namespace harness::report {

/// The path of a submission's page in the zip, by which the system gives the page to its student and nobody else:
///   Canvas: "doejane_LATE_1001_5001_feedback.html". Canvas takes the first two fields of digits between '_' for its
///     numbers of the student and of a file in the student's submission, so the name before them contains no '_'.
///   Moodle: "Jane Doe_123_assignsubmission_file/feedback.html". Moodle takes the second field for the participant's
///     number (mod/assign/feedback/file/importziplib.php), so the name contains no '_' here either.
/// Empty if the page can't be returned: the submission is not from such a system, or Canvas has no file to attach to.
std::optional<std::string> way_back(const Submission& submission);

struct FeedbackZip {
    std::size_t pages = 0;
    std::vector<std::string> left_out;  ///< "id: why": submissions from Canvas and Moodle whose page is not in the zip
};

/// Writes a zip with the student_page of each submission that has a way back, in their order. The same submissions give
/// the same bytes at any time and on any machine. Two submissions with the same student's number are both left out,
/// because nobody can tell which is that student's. Throws HarnessError.
FeedbackZip write_feedback_zip(std::ostream& out, const std::vector<Graded>& graded, const Marking& marking);

/// Whether any submission came from Canvas or Moodle.
bool is_from_lms(const std::vector<Graded>& graded);

}  // namespace harness::report
