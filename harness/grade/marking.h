// What every submission of a class is held to.
#pragma once

#include "reference/key/answer_key.h"

namespace harness {

struct Marking {
    reference::Assignment assignment;
    reference::AnswerKey key;  ///< the assignment's certified key
};

/// Makes the certified key of `assignment`. Throws what reference::make_key throws, and AssignmentError if the rubric
/// prices a mistake that does not exist.
Marking make_marking(reference::Assignment assignment);

}  // namespace harness
