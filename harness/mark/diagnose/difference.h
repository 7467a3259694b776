// Describes how a wrong answer differs from the right one, without revealing the right one.
#pragma once

#include <string>

#include "harness/mark/diagnose/evidence.h"

namespace harness {

/// Compares a wrong answer with the value that follows from the student's own earlier answers, or with the key if none
/// of those is wrong. Says which numbers, columns or rows differ, or that only a sign, length, order or scale differs:
/// "Only its y is wrong." Every sentence is a fact about the printed numbers and names no cause. Empty if there is no
/// fact.
std::string difference(const MatchedItem& printed, const Evidence& evidence, double allowance);

}  // namespace harness
