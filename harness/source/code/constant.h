// Numbers in a source: evaluates constant expressions and writes other numbers in their place.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "harness/source/code/words.h"

namespace harness::source {

/// A literal, or an expression that contains only literals: "-2", "1.0f / 2", "float(3)".
struct Constant {
    double value = 0;
    bool is_integer = false;  ///< of an integer type, so that / would truncate
    std::string suffix{};     ///< of its first floating-point literal, such as "f"; empty for integers
};

/// The value of a number literal: decimal, octal, hexadecimal or binary, with digit separators and standard suffixes.
/// Empty for anything else, such as a user-defined suffix.
std::optional<Constant> read_literal(std::string_view literal);

/// The value of the words as an expression of + - * / and brackets. Empty if they are not such an expression or if
/// there are more than 40 words. Integers are divided as in C++.
std::optional<Constant> evaluate(std::span<const Word> words);

/// `value` as a literal of the same type: "3", "-0.5f". Empty if `like` is an integer and `value` is not whole or too
/// large.
std::optional<std::string> spell(double value, const Constant& like);

}  // namespace harness::source
