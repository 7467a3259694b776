// The lines that say which question follows: "Question 1:", "=== Q1 - title ===", "Part 1", "1.", "| 6 | t | 0.59 |".
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace harness {

struct Heading {
    int question;     ///< from 1 on
    std::size_t end;  ///< byte offset in the line behind the number and its punctuation
};

/// For each line its heading; empty for a line that has none. A program numbers its questions in one style: a number in
/// another one is something else, such as "Step 2" within question 6. Linear in the number of bytes.
std::vector<std::optional<Heading>> find_headings(const std::vector<std::string_view>& lines, int last_question);

}  // namespace harness
