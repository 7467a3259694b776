#include "harness/read/tokens/line_numbers.h"

namespace harness {
namespace {

/// The lone minus sign before this byte, with at most a blank, a quote or a letter between.
MinusBefore minus_before(std::string_view text, std::size_t begin) {
    constexpr std::size_t most_between = 2;
    bool is_apart = false;
    for (std::size_t back = 1; back <= most_between + 1 && back <= begin; ++back) {
        const char c = text[begin - back];
        if (c == '-') {
            const char before = back == begin ? ' ' : text[begin - back - 1];
            if (before == '-' || before == '<') return MinusBefore::none;
            return is_apart ? MinusBefore::apart : MinusBefore::glued;
        }
        if (is_digit(c) || c == '+' || c == '=' || c == ':' || c == ',' || c == '>') return MinusBefore::none;
        is_apart = is_apart || c == ' ' || c == '\t';
    }
    return MinusBefore::none;
}

}  // namespace

std::vector<NumberOfLine> numbers_of_line(std::string_view line, int number) {
    std::vector<NumberOfLine> numbers;
    bool is_behind_equals = false;
    for (const Token& token : tokenize(line)) {
        if (token.kind == Token::Kind::number && token.number.index != 0) {
            numbers.push_back(
                {token.number, minus_before(line, token.begin), token.begin, token.end, is_behind_equals});
            numbers.back().number.line = number;
        }
        is_behind_equals = token.kind == Token::Kind::equals;
    }
    return numbers;
}

}  // namespace harness
