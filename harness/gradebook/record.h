// The form in which the gradebook keeps a graded submission: everything that the reports show, so that they can be
// written again without compiling, running or marking anything.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "harness/record/graded.h"

namespace harness {

/// Writes a submission as CBOR: a map from field names to values, in which an item is an array of its fields. A map
/// leaves out fields at their defaults, so that older records stay readable when fields are added. A record contains no
/// overrides, no source and no output, which the gradebook stores separately, and not how an answer was read. The same
/// submission always gives the same bytes.
std::vector<std::uint8_t> to_record(const Graded& graded);

/// Reads a submission back, without overrides. Empty if the bytes are not a record.
std::optional<Graded> from_record(const std::vector<std::uint8_t>& record);

}  // namespace harness
