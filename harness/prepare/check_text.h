// What an instructor should know about an assignment before students see it, as text for a terminal.
#pragma once

#include <string>
#include <vector>

#include "harness/prepare/proposal.h"
#include "reference/accuracy/measure/assignment_accuracy.h"

namespace harness::prepare {

/// What the ray meets, object by object, and which object no question asks about.
std::string objects_text(const reference::AnswerKey& key);

/// Which mistakes the scene cannot show and cannot tell apart, item by item.
std::string mistakes_text(const ShownMistakes& mistakes, const reference::AnswerKey& key);

/// The decisions that are boundary cases or hang on rounding, a line each; empty if there are none.
std::string decisions_text(const std::vector<reference::accuracy::Decision>& decisions);

/// What a proposal changes, and what it shows beside what the assignment shows.
std::string proposal_text(const Proposal& proposal);

}  // namespace harness::prepare
