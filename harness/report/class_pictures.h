// The class report's pictures, as inline <svg>: their colours are the page's.
#pragma once

#include <string>

#include "harness/report/class_statistics.h"

namespace harness::report {

/// How many have how many points.
std::string distribution_picture(const ClassStatistics& statistics);

/// A bar of right, following, wrong and missing. For the eye alone: the numbers stand beside it.
std::string tally_bar(const ItemTally& tally);

}  // namespace harness::report
