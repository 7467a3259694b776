// Sentences about an assignment that the text and the page share, and how they break into lines.
#pragma once

#include <string>

#include "reference/accuracy/measure/assignment_accuracy.h"

namespace harness::report {

/// "6 t": question and item.
std::string item_name(const reference::accuracy::ItemAccuracy& item);

/// "triangle: t is exactly 0. It decides … A single rounding on the way to it … Decided wrongly here by float."
std::string decision_sentence(const reference::accuracy::Decision& decision);

/// How many decisions depend on rounding, and how many are certain even in float.
std::string decisions_summary(const std::vector<reference::accuracy::Decision>& decisions);

/// Breaks into lines of at most 110 characters, except for longer words; indents all lines but the first.
std::string wrapped(const std::string& sentence);

}  // namespace harness::report
