#include "harness/read/quadratic_line.h"

#include <re2/re2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "harness/text/letters.h"

namespace harness {
namespace {

/// The number in `text`, which is a part of the line, with its sign, "- (-4)"; 1 for "" and "+".
PrintedNumber coefficient(const re2::StringPiece& sign, const re2::StringPiece& text, std::string_view line,
                          const std::vector<Token>& tokens) {
    PrintedNumber number{1, 0, 1, true};
    if (!text.empty()) {
        number = tokenize(std::string_view(text.data(), text.size())).back().number;
        const auto end = static_cast<std::size_t>(text.data() - line.data()) + text.size();
        const auto token = std::ranges::find(tokens, end, &Token::end);
        number.index = token == tokens.end() ? 0 : token->number.index;  // "4t" is a word
    }
    const bool is_negative = (sign == "-") != text.starts_with("-");
    number.value = is_negative ? -std::abs(number.value) : std::abs(number.value);
    return number;
}

}  // namespace

std::optional<QuadraticLine> read_quadratic(std::string_view line) {
    constexpr std::size_t longest = 1000;
    static const RE2 pattern = [] {
        const std::string number = R"(\(?\s*([-+]?\s*(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*\)?\s*\*?\s*)";
        return R"((?:^|[^\w.])\s*(([-+]?)\s*(?:)" + number + R"()?t\s*(?:\^\s*2|\*\s*t|2|t)\s*([-+])\s*(?:)" + number +
               R"()?t\s*([-+])\s*)" + number + R"((?:=\s*0(?:\.0*)?|$)))";
    }();
    std::array<re2::StringPiece, 8> groups;
    const re2::StringPiece text(line.data(), line.size());
    if (line.size() > longest || line.find('t') == std::string_view::npos ||
        !pattern.Match(text, 0, line.size(), RE2::UNANCHORED, groups.data(), 8))
        return std::nullopt;
    const auto begin = static_cast<std::size_t>(groups[1].data() - line.data()), end = begin + groups[1].size();
    const std::size_t behind = std::min(line.find_first_not_of(" \t", end), line.size());
    const bool goes_on =
        behind < line.size() && (std::string_view("+*/^").find(line[behind]) != std::string_view::npos ||
                                 (behind == end && (is_letter(line[end]) || is_digit(line[end]))));
    if (goes_on) return std::nullopt;
    // "- 1 t^2 - 4 t + 2 = 0" begins with the mark of a list.
    if (line.find_first_not_of(" \t") == begin && groups[1].starts_with("- ")) groups[2] = re2::StringPiece();
    const std::vector<Token> tokens = tokenize(line);
    QuadraticLine found;
    for (std::size_t k = 0; k < 3; ++k) {
        PrintedValue value;
        value.numbers = {coefficient(groups.at(2 + 2 * k), groups.at(3 + 2 * k), line, tokens)};
        value.label = std::string(1, "abc"[k]);
        value.printed = std::string(groups[1].substr(0, longest_printed));
        found.values.push_back(std::move(value));
    }
    found.end = end;
    return found;
}

}  // namespace harness
