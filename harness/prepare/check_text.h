// The output of `assignment check` and `assignment propose`.
#pragma once

#include <string>
#include <vector>

#include "harness/prepare/proposal.h"
#include "reference/accuracy/measure/assignment_accuracy.h"

namespace harness::prepare {

/// The objects that the ray hits, and the objects that no question asks about.
std::string objects_text(const reference::AnswerKey& key);

/// The mistakes that the scene does not reveal, and those that give the same answer, by item.
std::string mistakes_text(const ShownMistakes& mistakes, const reference::AnswerKey& key);

/// The borderline hits, a line each: decisions that rounding may change. Empty if there are none.
std::string decisions_text(const std::vector<reference::accuracy::Decision>& decisions);

/// The changes of a proposal, and how many mistakes the scene reveals before and after.
std::string proposal_text(const Proposal& proposal);

}  // namespace harness::prepare
