// Finds the lines that begin a question: "Question 1:", "=== Q1 - title ===", "Part 1", "1.", "| 6 | t | 0.59 |".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace harness {

struct Heading {
    int question;          ///< from 1 on
    std::size_t end;       ///< byte offset in the line after the number and its punctuation
    std::string before{};  ///< what stands before the number, without blanks and repeats: "HW6.", "="
};

/// Returns each line's heading; empty for a line without one. A program numbers its questions in one style. A number in
/// another style is something else, such as "Step 2" within question 6. Linear in the number of bytes.
std::vector<std::optional<Heading>> find_headings(const std::vector<std::string_view>& lines, int last_question);

}  // namespace harness
