// The outputs that take longest to read.
#pragma once

#include <ostream>
#include <string>
#include <vector>

struct NastyPattern {
    std::string name;      ///< letters and '_'
    std::string head;      ///< printed once
    std::string repeated;  ///< printed over and over
    friend std::ostream& operator<<(std::ostream& out, const NastyPattern& p) { return out << p.name; }
};

inline std::vector<NastyPattern> nasty_patterns() {
    const std::string q6 = "Question 6:\n";
    return {{"digits", "", "7"},
            {"open_brackets", "", "("},
            {"bracket_pairs", "", "()"},
            {"deeper_and_deeper", "", "[1,"},
            {"less_than", "", "<"},
            {"angles_with_numbers", "", "<1 "},
            {"ones", q6, "1 "},
            {"ones_on_lines", q6, "1\n"},
            {"two_components", "", "x=1,y=2,"},
            {"three_components", "", "x=1,y=2,z=3,"},
            {"headings", "", "Question 6:\n"},
            {"headings_with_answers", "", "Q6:(1,2,3)\n"},
            {"headings_within_a_line", "", "Question 6: 1  "},
            {"bare_headings", "", "1.\n2.\n3.\n"},
            {"rows_of_three", q6, "1 2 3\n"},
            {"rows_of_four_without_heading", "", "1 2 3 4\n"},
            {"framed_numbers", q6, "| 1 |\n"},
            {"escapes", "", "\x1b"},
            {"escapes_cut_off", "", "\x1b["},
            {"titles_cut_off", "", "\x1b]"},
            {"not_utf8", "", "\xff"},
            {"utf8_cut_off", "", "\xe2\x88"},
            {"nuls", "", std::string(1, '\0')},
            {"one_word", "", "a"},
            {"equals_signs", "", "="},
            {"formula", "", "t^2 + t "},
            {"formulas_on_lines", "", "t^2 + t\n"},
            {"same_label", q6, "a = 1\n"},
            {"glued_labels", "", "a=1b=2"},
            {"fractions", "", "1/2 "},
            {"slashes", "", "1/2/"},
            {"slashes_between_rows", "", "1 2 3 / "},
            {"slashes_after_columns", "", "1 2 3 4 5 6 7 8 9 "},
            {"chain_of_results", "", "1 = "},
            {"remarks", "", "(= 1) "},
            {"remarks_cut_off", "", "1 (a b c d "},
            {"no_values", q6, "t: none\n"},
            {"verdicts", "", "ray hits sphere first\n"},
            {"types", "", "mat4x4(("},
            {"scopes", "", "::a"},
            {"line_ends", "", "\n"},
            {"exponents", "", "1e"}};
}

inline std::string nasty_output(const NastyPattern& pattern, std::size_t bytes) {
    std::string output = pattern.head;
    output.reserve(bytes + pattern.repeated.size());
    while (output.size() < bytes) output += pattern.repeated;
    return output;
}
