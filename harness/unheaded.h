// Values printed without a heading, divided among the questions they may answer.
#pragma once

#include <span>
#include <vector>

#include "harness/question_match.h"

namespace harness {

/// `questions` holds the items of each question, in the handout's order. The values are cut into one run a question, in
/// that order, so that the sum of the gains is largest; values between the runs belong to none. Where labels out of
/// that order say more, or where the values are too many to try all cuts, labels alone decide. One result a question.
std::vector<Answers> answer_unheaded(std::span<const std::vector<reference::ItemSpec>> questions,
                                     const std::vector<PrintedValue>& values, Fits& fits);

}  // namespace harness
