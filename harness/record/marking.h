// The assignment and the key that a class is marked with.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "harness/intake/submission.h"
#include "reference/key/answer_key.h"

namespace harness {

struct Marking {
    reference::Assignment assignment;
    reference::AnswerKey key;  ///< the assignment's certified key
    /// If each student has a scene of their own: each student's marking, by the student's id.
    std::map<std::string, std::shared_ptr<const Marking>> of_student = {};
};

/// Throws AssignmentError if the rubric prices a mistake that does not exist.
void require_mistakes(const reference::Rubric& rubric);

/// Makes the certified key of `assignment`. Throws the exceptions of reference::make_key, and AssignmentError if the
/// rubric prices a mistake that does not exist or the assignment deals scenes to students.
Marking make_marking(reference::Assignment assignment);

/// The same for a class, in which each student may have a scene of their own.
Marking make_class_marking(reference::Assignment assignment);

/// How much students may see now. Pages made after the deadline may show more.
reference::Feedback feedback_now(const reference::Rubric& rubric);

/// The marking of this submission. If students have their own scenes and this one has none, the class's marking; the
/// submission then can't be graded.
const Marking& own_marking(const Marking& marking, const Submission& submission);

}  // namespace harness
