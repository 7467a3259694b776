// Marks for Classroom 50: the result.json of an autograder.
#pragma once

#include <stdexcept>
#include <string>

#include "harness/grade.h"

namespace harness::report {

/// What the runner of Classroom 50 says of the submission, by its environment variables.
struct Classroom50Submission {
    std::string classroom;        ///< CLASSROOM
    std::string assignment;       ///< ASSIGNMENT, the classroom's name of it
    std::string tag;              ///< SUBMISSION_TAG, "submit/…"
    std::string commit;           ///< COMMIT_URL
    std::string release;          ///< RELEASE_URL
    std::string review;           ///< REVIEW_URL
    std::string owner;            ///< OWNER, else USERNAME; may be empty, the runner then says
    std::string assignment_type;  ///< ASSIGNMENT_TYPE; may be empty, the runner then says
    std::string datetime;         ///< now in UTC, as 2026-11-22T09:30:00Z
};

/// The format classroom50/result/v1: a test for each question. Its points are whole numbers: the total rounded, halves
/// up, and never above the maximum; the questions' so that they sum up to the total before a late deduction. The exact
/// points of a question and its answers in words stand beside them as "points" and "output". Precondition: there is a
/// final mark.
std::string classroom50_result(const Graded& graded, const Marking& marking, const Classroom50Submission& submission);

}  // namespace harness::report
