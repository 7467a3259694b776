// Marks for Classroom 50: the result.json of an autograder.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "harness/record/graded.h"
#include "harness/record/marking.h"

namespace harness::report {

/// Appears in the first 1,000 bytes of each result.json.
inline constexpr std::string_view classroom50_schema = "classroom50/result/v1";

/// The environment variables with which Classroom 50's runner describes the submission.
struct Classroom50Submission {
    std::string classroom;        ///< CLASSROOM
    std::string assignment;       ///< ASSIGNMENT, its name in the classroom
    std::string tag;              ///< SUBMISSION_TAG, "submit/…"
    std::string commit;           ///< COMMIT_URL
    std::string release;          ///< RELEASE_URL
    std::string review;           ///< REVIEW_URL
    std::string owner;            ///< OWNER, else USERNAME; if empty, the runner fills it in
    std::string assignment_type;  ///< ASSIGNMENT_TYPE; if empty, the runner fills it in
    std::string datetime;         ///< now in UTC, as 2026-11-22T09:30:00Z
};

/// The format classroom50/result/v1: one test per question. Its points are whole numbers: the total is rounded, halves
/// up, and never above the maximum; the questions' points add up to the total before a late deduction. "points" and
/// "output" have a question's exact points and its answers in words. Precondition: there is a final mark.
std::string classroom50_result(const Graded& graded, const Marking& marking, const Classroom50Submission& submission);

}  // namespace harness::report
