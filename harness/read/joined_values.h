// Vectors and matrices that were printed number by number.
#pragma once

#include <string_view>
#include <vector>

#include "harness/read/printed_value.h"

namespace harness {

/// Joins the elements of matrices ("M(1,1) = 0", "M(1,2) = 1", …), the components of vectors ("x = 0, y = 0, z = -2",
/// on one line or on several) and numbers stacked below their label ("N", then a number a line) into one value each.
std::vector<PrintedValue> join_values(std::vector<PrintedValue> values);

/// Joins the matrix' row and the right-hand side where the line writes a system out, "| 0 2 -2 | * | t | = | 1.5 |":
/// four numbers with a bar after three. `values` are the line's.
void join_system_row(std::vector<PrintedValue>& values, std::string_view line);

}  // namespace harness
