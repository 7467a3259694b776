// The lines that say which question follows: "Question 1:", "Q1)", "=== QUESTION #1 - title ===", "1.", "Part 1".
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace harness {

struct Heading {
    int question;      ///< 1 to 99
    std::size_t end;   ///< byte offset in the line behind the number and its punctuation: a title or an answer may follow
    bool has_keyword;  ///< "Question", "Q", …; without one the number stands alone, as in "1." or "--- 1 ---"
};

/// The heading a line begins with, if it does. Linear in the line's length.
std::optional<Heading> read_heading(std::string_view line);

/// Which of `lines` are headings. A transcript that names its questions with a keyword is divided by these only, since a bare
/// "1." may then be a number. Result: one entry a line, empty where the line is no heading.
std::vector<std::optional<Heading>> find_headings(const std::vector<std::string_view>& lines);

}  // namespace harness
