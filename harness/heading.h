// The lines that say which question follows: "Question 1:", "Q1)", "=== QUESTION #1 - title ===", "1.", "Part 1".
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace harness {

struct Heading {
    /// How the number is introduced. A program keeps to one of these; a number introduced otherwise is something else,
    /// such as "Step 2" within question 6.
    enum class Style {
        question,  ///< "Question", "Q", "Exercise", "Problem", …
        part,      ///< "Part", "Answer", "Step", "No.", …, which may also count within a question
        bare,      ///< the number alone: "1.", "2)", "--- 3 ---", "6a)"
    };
    int question;  ///< 1 to 99
    std::size_t
        end;  ///< byte offset in the line behind the number and its punctuation: a title or an answer may follow
    Style style;
};

/// The heading a line begins with, if it does. Linear in the line's length.
std::optional<Heading> read_heading(std::string_view line);

/// Which of `lines` are headings: those of the style that names the most of the questions 1 to 10; bare numbers only if
/// they name at least three. Result: one entry a line, empty where the line is no heading.
std::vector<std::optional<Heading>> find_headings(const std::vector<std::string_view>& lines);

}  // namespace harness
