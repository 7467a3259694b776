// Vectors that were printed number by number.
#pragma once

#include <vector>

#include "harness/read/printed_value.h"

namespace harness {

/// Joins the components of vectors, "x = 0, y = 0, z = -2", on one line or on several, into one value each.
std::vector<PrintedValue> join_values(std::vector<PrintedValue> values);

}  // namespace harness
