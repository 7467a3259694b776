// What `assignment check` and `assignment propose` print.
#pragma once

#include <string>
#include <vector>

#include "harness/prepare/proposal.h"
#include "reference/accuracy/measure/assignment_accuracy.h"

namespace harness::prepare {

/// Which objects the ray hits, and which object no question asks about.
std::string objects_text(const reference::AnswerKey& key);

/// Which mistakes the scene does not reveal, and which ones give the same answer, by item.
std::string mistakes_text(const ShownMistakes& mistakes, const reference::AnswerKey& key);

/// The borderline hits, a line each: decisions that rounding may change. Empty if there are none.
std::string decisions_text(const std::vector<reference::accuracy::Decision>& decisions);

/// What a proposal changes, and how many mistakes it reveals before and after.
std::string proposal_text(const Proposal& proposal);

}  // namespace harness::prepare
