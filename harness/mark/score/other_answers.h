// What a printout offers beside an answer that is read from it: "0.58 or 3.41", "+-4", "0.58 (wrong, should be 3.41)".
#pragma once

#include "harness/mark/score/score.h"
#include "harness/read/transcript.h"

namespace harness {

/// The line where another answer is offered for the item, or where what was read for it is withdrawn; 0 if there is
/// none. Only the words and signs beside the value count, not whether it is right.
int line_of_another_answer(const Transcript& transcript, const ItemScore& item);

}  // namespace harness
