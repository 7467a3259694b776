// The answers under one reading of the handout, before they are gathered into a key.
#pragma once

#include <map>

#include "reference/key/answer_key.h"

namespace reference {

struct ReadingAnswers {
    Decisions decisions;  ///< without policy
    std::map<ItemId, Answer> answers;
};

/// Exact decisions, proven enclosures and allowances. Throws std::domain_error for a number that to_rational refuses
/// and for a degenerate camera or triangle; parse_assignment rejects both.
ReadingAnswers certified_answers(CorrectPrograms& programs, const Reading& reading);

}  // namespace reference
