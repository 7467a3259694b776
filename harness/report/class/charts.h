// The class report's picture, as inline <svg>. The page's style gives its colours.
#pragma once

#include <string>

#include "harness/report/class/statistics.h"

namespace harness::report {

/// A histogram of the final points.
std::string distribution_picture(const ClassStatistics& statistics);

}  // namespace harness::report
