// Joins vectors that were printed number by number.
#pragma once

#include <vector>

#include "harness/read/printed_value.h"

namespace harness {

/// Joins the components of each vector, "x = 0, y = 0, z = -2", on one line or several, into one value.
std::vector<PrintedValue> join_values(std::vector<PrintedValue> values);

}  // namespace harness
