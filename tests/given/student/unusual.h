// Printouts in layouts that nobody could foresee.
#pragma once

#include <cstdint>
#include <string>

#include "tests/given/student/program.h"
#include "tests/given/student/writing.h"

namespace student {

/// The printout with something in it that nobody could foresee: other signs between the numbers of a line, headings or
/// labels that mean nothing, a word that is glued to each number, lines that are joined. The same seed garbles the
/// program's printouts for several scenes alike.
std::string garbled(const Writing& writing, std::uint64_t seed);

/// Prints a program's answers in a layout of its own, drawn from a second grammar: invented labels or none, odd signs
/// between label and value, several values side by side, columns, values that go on over lines, intermediate results,
/// odd headings or none.
Writing write_unusual(const Program& program, std::uint64_t seed);

}  // namespace student
