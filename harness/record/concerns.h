// The reasons to review a submission, and those that somebody has accepted.
#pragma once

#include <string>
#include <vector>

#include "harness/record/graded.h"

namespace harness {

/// The submission's flags and, as a flag, that it was not graded, by their urgency.
std::vector<Flag> concerns_of(const Graded& graded);

/// What is accepted with a concern. It is equal for equal concerns only: for a doubtful reading it includes what was
/// read.
std::string seen_in(const Graded& graded, const Flag& concern);

/// The decision by which a person accepted exactly this concern; null if nobody did.
const Decision* acceptance_of(const Graded& graded, const Flag& concern);

/// The concerns that nobody has accepted.
std::vector<Flag> open_concerns(const Graded& graded);

/// The flags that nobody has accepted, in the order of the submission.
std::vector<Flag> open_flags(const Graded& graded);

/// Those of them that the student gets: no suspicion, which an instructor may confirm with a comment, and no
/// doubtful reading that costs no points or of which only the key knows.
std::vector<Flag> flags_for_student(const Graded& graded);

/// The comments for the student, the oldest first.
std::vector<Decision> comments_of(const Graded& graded);

/// Gives each submission its decisions. Those of others are left out.
void attach(const std::vector<KeptDecision>& decisions, std::vector<Graded>& graded);

}  // namespace harness
