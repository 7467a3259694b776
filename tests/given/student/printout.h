// How a student's program prints its answers: headings, labels, layout, digits, order and noise, drawn from a seed.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "tests/given/student/program.h"

namespace student {

enum class NumberFormat { fixed, stream, scientific };
enum class VectorLayout { to_string, bracketed, spaced, components, component_lines, vec4 };
enum class MatrixLayout { to_string, rows, labelled_rows, labelled_columns };

struct Layout {
    std::uint64_t seed = 0;  ///< for random choices while printing, such as noise
    NumberFormat format = NumberFormat::fixed;
    int digits = 6;  ///< decimals of the fixed and scientific formats
    VectorLayout vectors = VectorLayout::to_string;
    MatrixLayout matrices = MatrixLayout::to_string;
    std::string open = "(", close = ")";
    int heading = 0;  ///< index into the heading styles of printout.cpp
    int labels = 0;   ///< index into the label styles of printout.cpp
    std::string separator = ": ";
    bool shuffled = false;     ///< the questions are printed in a random order
    bool debug_lines = false;  ///< extra lines with numbers for the student's own use
    bool blank_lines = false;
    bool question_text = false;  ///< the handout's text is repeated, with its numbers
    bool colours = false;
    bool crlf = false;

    std::string describe() const;
};

/// Fixed formats have `least_decimals` to 8 decimals, scientific formats at least 6 significant digits.
Layout random_layout(std::uint64_t seed, int least_decimals);

/// The output of a program with these answers.
std::string print(const Program& program, const Layout& layout);

/// The same, but only with the questions and items that `keep` accepts.
std::string print(const Program& program, const Layout& layout, const std::function<bool(const ItemId&)>& keep);

/// The output in the handout's own layout.
std::string print(const Program& program);

/// Replaces the value on one line of an output in the handout's layout. The line must exist.
std::string with_line(std::string output, int question, const std::string& label, const std::string& value);

}  // namespace student
