// The lines that say which question follows: "Question 1:", "Q1)", "=== QUESTION #1 - title ===", "1.", "Part 1".
#pragma once

#include <optional>
#include <string_view>

namespace harness {

struct Heading {
    /// How the number is introduced. A program uses one style for its headings. A number in another style is something
    /// else, such as "Step 2" within question 6.
    enum class Style {
        question,  ///< "Question", "Q", "Exercise", "Problem", …
        part,      ///< "Part", "Answer", "Step", "No.", …, which may also number steps within a question
        bare,      ///< the number alone: "1.", "2)", "--- 3 ---", "6a)"
        dotted,    ///< with the number of a part, before words: "2.1 t: 1.5"
        column,  ///< at the beginning of lines in other ways: "| 6 | t | 0.59 |", "VI.", "[6/10]", "HW6.2", or alone on
                 ///< a line: "6.2"
    };
    int question;     ///< 1 to 99
    std::size_t end;  ///< byte offset in the line after the number and its punctuation
    Style style;
};

/// Reads the heading at the start of a line; empty if there is none. Linear in the line's length.
std::optional<Heading> read_heading(std::string_view line, int last_question);

}  // namespace harness
