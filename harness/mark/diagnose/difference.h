// What differs between a wrong answer and the right one, said without the right one.
#pragma once

#include <string>

#include "harness/mark/diagnose/evidence.h"

namespace harness {

/// Compares a wrong answer with what follows from the student's own earlier answers, or with the key where none of
/// these is wrong. Says which numbers, columns or rows differ, or that only a sign, length, order or scale does: "Only
/// its y is wrong." Every sentence is a fact about the printed numbers and names no cause. Empty if there is no fact.
std::string difference(const MatchedItem& printed, const Evidence& evidence, double allowance);

}  // namespace harness
