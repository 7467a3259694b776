// Returns students' pages through the LMS that their submissions came from.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "harness/record/graded.h"
#include "harness/record/marking.h"

namespace harness::report {

/// The path of a submission's page in the zip. From it, the LMS knows which student gets the page:
///   Canvas: "doejane_LATE_1001_5001_feedback.html". Canvas reads the first two fields of digits between '_' as its
///     numbers of the student and of a file in the submission, so the name before them contains no '_'.
///   Moodle: "Jane Doe_123_assignsubmission_file/feedback.html". Moodle reads the second field as the participant's
///     number (mod/assign/feedback/file/importziplib.php), so this name contains no '_' either.
/// Empty if the page can't be returned: the submission is not from Canvas or Moodle, or Canvas has no file to attach
/// the page to.
std::optional<std::string> way_back(const Submission& submission);

struct FeedbackZip {
    std::size_t pages = 0;
    std::vector<std::string> left_out;  ///< "id: why": submissions from Canvas and Moodle whose page is not in the zip
};

/// Writes a zip with the student_page of each submission that has a way_back, in order. The same submissions give the
/// same bytes at any time on any machine. Two submissions with the same student number are both left out, because
/// either may be the student's. Throws HarnessError.
FeedbackZip write_feedback_zip(std::ostream& out, const std::vector<Graded>& graded, const Marking& marking);

/// Whether any submission came from Canvas or Moodle.
bool is_from_lms(const std::vector<Graded>& graded);

}  // namespace harness::report
