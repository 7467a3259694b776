// Divides values printed without a heading among the questions that they may answer.
#pragma once

#include <span>
#include <vector>

#include "harness/match/question_match.h"
#include "harness/read/transcript.h"

namespace harness {

/// `questions` holds the items of each question, in the handout's order. Cuts the values into one run per question, in
/// that order, so that the sum of the gains is largest. Values between the runs belong to no question. Labels alone
/// decide if they name more answers in another order, or if there are too many values to try all cuts. Returns one
/// result per question.
std::vector<Answers> answer_unheaded(std::span<const std::vector<reference::ItemSpec>> questions,
                                     const std::vector<PrintedValue>& values, Fits& fits);

}  // namespace harness
