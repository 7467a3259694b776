// What values around the triangle's system are called by what stands elsewhere.
#pragma once

#include <string_view>
#include <vector>

#include "harness/read/printed_value.h"

namespace harness {

/// Names a solution, "x = 0.25 0.5 2", by the order in which the lines of its section list its unknowns, "x = (u, v,
/// t)", its columns, "B - A, C - A, -V", or its terms, "u(B - A) + v(C - A) - tV": "(u, v, t)".
void name_unknowns(std::vector<PrintedValue>& values, const std::vector<PrintedLine>& lines);

/// Stands before the names of corners; no answer has it in its name.
inline constexpr std::string_view corner_of_scene = "trianglecorner";

/// Calls three vectors A, B and C that are printed one behind the other the triangle's corners: that B is no right-hand
/// side.
void name_corners(std::vector<PrintedValue>& values);

}  // namespace harness
