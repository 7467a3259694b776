// A graded submission as it is kept in the gradebook: everything that the reports show of it, so that they can be
// written again without compiling, running or marking anything.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "harness/grade.h"

namespace harness {

/// CBOR: a map whose keys are the fields' names, an item an array of its fields. What is at its default is left out of
/// a map, so that an older record reads well where fields were added. The overrides are not in it, nor what a finished
/// run has no more: source, output, program, and how an answer was read beside what it says. The same submission always
/// gives the same bytes.
std::vector<std::uint8_t> to_record(const Graded& graded);

/// The submission again, without overrides; empty when these bytes are no record.
std::optional<Graded> from_record(const std::vector<std::uint8_t>& record);

}  // namespace harness
