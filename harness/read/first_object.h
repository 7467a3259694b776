// The sentence about the first hit: "ray hits triangle first", in the words students use.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/read/transcript.h"
#include "reference/stages/first_hit.h"

namespace harness {

struct PrintedVerdict {
    reference::Verdict verdict;
    std::string printed;  ///< the line, at most 200 bytes
    int line;             ///< 1-based, in the program's output
};

/// Whether the lines stand under the heading of the question that asks what is hit first. Elsewhere, only a sentence
/// with "first" is a verdict.
enum class VerdictPlace { own_section, elsewhere };

/// The last verdict that the lines state. A line with digits counts only if no line without digits states a verdict. A
/// line that only reports an object's t states none.
std::optional<PrintedVerdict> read_verdict(const std::vector<PrintedLine>& lines, VerdictPlace place);

}  // namespace harness
