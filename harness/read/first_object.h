// The sentence about the first hit: "ray hits triangle first", in the words students use.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/read/transcript.h"
#include "reference/stages/first_hit.h"

namespace harness {

struct PrintedFirstObject {
    reference::FirstObject object;
    std::string printed;  ///< the line, at most 200 bytes
    int line;             ///< 1-based, in the program's output
};

/// Whether the lines stand under the heading of the question that asks what is hit first. Elsewhere, only a sentence
/// with "first" counts.
enum class FirstObjectPlace { own_section, elsewhere };

/// The first object that the lines state. A line that says "first" or "nearest" outdoes one that tells of a hit, and
/// that one an object's name alone or with numbers. Empty if lines of the same rank differ.
std::optional<PrintedFirstObject> read_first_object(const std::vector<PrintedLine>& lines, FirstObjectPlace place);

}  // namespace harness
