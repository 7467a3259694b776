// The words, numbers and signs of one line of output.
#pragma once

#include <string_view>
#include <vector>

#include "harness/text/letters.h"

namespace harness {

/// A number as a program printed it.
struct PrintedNumber {
    double value = 0;     ///< may be infinite or not a number
    int decimals = 0;     ///< decimal places of the last digit: 1.50 has 2, 1.5e-3 has 4, 1.5e+03 has -2
    int significant = 0;  ///< significant digits, counted from the first nonzero digit
    bool exact = false;   ///< a fraction such as 5/3, which has no last digit
    int line = 0;         ///< of the output, 1-based
    int index = 0;        ///< among the numbers of its line, 1-based; 0 if it is not one of them
};

struct Token {
    enum class Kind {
        word,  ///< letters, digits and '_' that begin with a letter; "P_VCS", "t1", "b'", "P.x", "M[0]", "glm::vec3"
        number,
        open,     ///< ( [ { or < before a number
        close,    ///< ) ] } or the > that closes a list opened by <
        comma,    ///< , or ;
        equals,   ///< = : -> => := or == between a label and its value
        compare,  ///< < > <= >= !=
        op,       ///< + - * / ^ between terms
        bar,      ///< |
        other,    ///< any other sign, and runs of decoration such as "----"
    };
    Kind kind;
    std::size_t begin;  ///< byte offset in the line
    std::size_t end;
    PrintedNumber number;  ///< when kind is number
};

/// The tokens of a line of clean text, in order. The index in "[0] = 1.5" does not count as a number. Linear in its
/// length.
std::vector<Token> tokenize(std::string_view line);

/// A minus sign before a number that is not part of the number as read.
enum class MinusBefore {
    none,
    apart,  ///< "- 6.7": its sign, or a dash after a label
    glued,  ///< "-'6.7'": its sign
};

struct NumberOfLine {
    PrintedNumber number;
    MinusBefore minus = MinusBefore::none;
    std::size_t begin = 0;  ///< byte offset in the line
    std::size_t end = 0;
    bool is_behind_equals = false;  ///< "=" or ":" is directly before it
};

/// Returns the numbers of a line of clean text, in order, without indices such as the 0 in "[0] = 1". `number` is the
/// line's number in the output.
std::vector<NumberOfLine> numbers_of_line(std::string_view line, int number);

}  // namespace harness
