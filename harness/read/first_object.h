// Finds the sentence about the first hit: "ray hits triangle first", in students' words.
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

/// Whether the lines are under the heading of the question about the first hit. Elsewhere, only a sentence with "first"
/// counts.
enum class FirstObjectPlace { own_section, elsewhere };

/// The object that the lines say is hit first. A line with "first" or "nearest" ranks above a line about a hit, which
/// ranks above an object's name alone or with numbers. Empty if lines of the same rank differ.
std::optional<PrintedFirstObject> read_first_object(const std::vector<PrintedLine>& lines, FirstObjectPlace place);

}  // namespace harness
