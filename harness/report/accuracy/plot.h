// Time against wrong decisions as an SVG.
#pragma once

#include <string>
#include <vector>

#include "harness/report/accuracy/summary.h"

namespace harness::report {

/// Two plots a row, both axes logarithmic: every method is a labeled point, and the frontier is drawn.
std::string plots(const std::vector<PrimitiveSummary>& summaries);

}  // namespace harness::report
