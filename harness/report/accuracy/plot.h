// A plot of numbered methods with a legend: time on benign rays against wrong decisions on hard ones, both logarithmic.
#pragma once

#include <string>

#include "harness/report/accuracy/summary.h"

namespace harness::report {

/// A whole <svg> element. Methods whose numbers would overlap share one label, "2, 3".
std::string plot(const PrimitiveSummary& summary);

}  // namespace harness::report
