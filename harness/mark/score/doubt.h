// Where the reading of an answer may be wrong. The key may raise a doubt here, but it never chooses what is read.
#pragma once

#include <vector>

#include "harness/mark/score/score.h"
#include "harness/match/matched_item.h"
#include "harness/read/transcript.h"
#include "reference/key/answer_key.h"

namespace harness {

/// Notes a doubt on each item that is not right and for which the printout holds something that may have been meant;
/// on one that follows and has all its points only if that is the right value. On one that is right, if another answer
/// is offered beside it.
/// Linear in the length of the printout.
void doubt_readings(Score& score, const Transcript& transcript, const std::vector<MatchedItem>& matched,
                    const reference::AnswerKey& key, const reference::Assignment& assignment);

}  // namespace harness
