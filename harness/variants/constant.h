// Numbers as a source writes them: what a constant expression is worth, and how another number is written in its place.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "harness/variants/words.h"

namespace harness::variants {

/// A literal, or an expression of nothing but literals: "-2", "1.0f / 2", "float(3)".
struct Constant {
    double value = 0;
    bool is_integer = false;  ///< of an integer type, so that / would divide with remainder
    std::string suffix{};     ///< of its first floating literal, such as "f"; empty for integers
};

/// What a number literal is worth: decimal, octal, hexadecimal or binary, with digit separators and the language's own
/// suffixes. Empty for anything else, such as a suffix of the program's own.
std::optional<Constant> read_literal(std::string_view literal);

/// What the words are worth together, with + - * / and brackets; empty when they are not such an expression or more
/// than 40 words. Integers are divided as C++ does.
std::optional<Constant> evaluate(std::span<const Word> words);

/// `value` as a literal of the same type: "3", "-0.5f". Empty where an integer is written and `value` is not whole.
std::optional<std::string> spell(double value, const Constant& like);

}  // namespace harness::variants
