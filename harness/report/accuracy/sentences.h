// What the text and the page say alike of an assignment.
#pragma once

#include <string>

#include "reference/accuracy/assignment_accuracy.h"

namespace harness::report {

/// "6 t": question and item.
std::string item_name(const reference::accuracy::ItemAccuracy& item);

/// "triangle: t is exactly 0: it asks whether … In any arithmetic that rounds, … On this machine's run …".
std::string decision_sentence(const reference::accuracy::Decision& decision);

/// How many decisions there are and how many of them are beyond doubt in float.
std::string decisions_summary(const std::vector<reference::accuracy::Decision>& decisions);

/// "0.4 ULP", "decided otherwise".
std::string error_cell(const reference::accuracy::ItemError& error);

}  // namespace harness::report
