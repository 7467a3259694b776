// How a student's program prints its answers: headings, labels, layout, digits, order and noise, drawn from a seed.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "tests/student/program.h"

namespace student {

enum class NumberFormat { fixed, stream, scientific };
enum class VectorLayout { to_string, bracketed, spaced, components, component_lines, vec4 };
enum class MatrixLayout { to_string, rows, labelled_rows, labelled_columns };

struct Layout {
    std::uint64_t seed = 0;  ///< of what is drawn while printing, such as noise
    NumberFormat format = NumberFormat::fixed;
    int digits = 6;  ///< decimals of fixed and scientific
    VectorLayout vectors = VectorLayout::to_string;
    MatrixLayout matrices = MatrixLayout::to_string;
    std::string open = "(", close = ")";
    int heading = 0;  ///< index into the styles of printout.cpp; likewise
    int labels = 0;
    std::string separator = ": ";
    bool shuffled = false;     ///< the questions in another order
    bool debug_lines = false;  ///< numbers printed for the student's own use
    bool blank_lines = false;
    bool question_text = false;  ///< the handout's text echoed, with its numbers
    bool colours = false;
    bool crlf = false;

    std::string describe() const;
};

/// Fixed formats with `least_decimals` to 8 decimals, scientific ones with at least 6 significant digits.
Layout random_layout(std::uint64_t seed, int least_decimals);

/// The output of a program with these answers.
std::string print(const Program& program, const Layout& layout);

/// The same without some questions or items: what `keep` refuses is not printed.
std::string print(const Program& program, const Layout& layout, const std::function<bool(const ItemId&)>& keep);

/// The handout's own layout.
std::string print(const Program& program);

/// An output in the handout's layout with another value on one line. The line must be there.
std::string with_line(std::string output, int question, const std::string& label, const std::string& value);

}  // namespace student
