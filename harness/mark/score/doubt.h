// Finds answers that may have been misread. The key may raise a doubt, but it never decides the reading.
#pragma once

#include <vector>

#include "harness/mark/score/score.h"
#include "harness/match/matched_item.h"
#include "harness/read/transcript.h"
#include "reference/key/answer_key.h"

namespace harness {

/// Notes a doubt on each item that is not right and has no doubt yet if the output contains something else that the
/// student may have meant. If the item follows and has full points, only the right value elsewhere raises a doubt.
/// Takes time linear in the length of the output.
void doubt_readings(Score& score, const Transcript& transcript, const std::vector<MatchedItem>& matched,
                    const reference::AnswerKey& key, const reference::Assignment& assignment);

}  // namespace harness
