// The reasons to review a submission, and which of them somebody has accepted.
#pragma once

#include <string>
#include <vector>

#include "harness/record/graded.h"

namespace harness {

/// The submission's flags by urgency. A submission that was not graded gets a flag for that.
std::vector<Flag> concerns_of(const Graded& graded);

/// The evidence that a person accepts with a concern. It is equal only for equal concerns: for a doubtful reading, it
/// includes the values read.
std::string seen_in(const Graded& graded, const Flag& concern);

/// The decision by which a person accepted exactly this concern; null if nobody did.
const Decision* acceptance_of(const Graded& graded, const Flag& concern);

/// The concerns that nobody has accepted.
std::vector<Flag> open_concerns(const Graded& graded);

/// The flags that nobody has accepted, in the order of the submission.
std::vector<Flag> open_flags(const Graded& graded);

/// The open flags that the student sees. Leaves out suspicions, which an instructor may confirm with a comment, and
/// doubtful readings that cost no points or depend on the key.
std::vector<Flag> flags_for_student(const Graded& graded);

/// The comments for the student, oldest first.
std::vector<Decision> comments_of(const Graded& graded);

/// Gives each submission its decisions. Ignores decisions on submissions that are not in the class.
void attach(const std::vector<KeptDecision>& decisions, std::vector<Graded>& graded);

}  // namespace harness
