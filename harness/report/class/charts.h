// The class report's pictures, as inline <svg>. The page's style gives their colours.
#pragma once

#include <string>

#include "harness/report/class/statistics.h"

namespace harness::report {

/// A histogram of the final points.
std::string distribution_picture(const ClassStatistics& statistics);

/// A bar with the shares of right, following, wrong and missing answers. Hidden from screen readers, because the
/// numbers stand beside it.
std::string tally_bar(const ItemTally& tally);

}  // namespace harness::report
