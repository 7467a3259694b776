#include "harness/read/quadratic_line.h"

#include <re2/re2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace harness {
namespace {

/// The number in `text`, which is a part of the line, with its sign, "- (-4)"; 1 for "" and "+".
PrintedNumber coefficient(const re2::StringPiece& sign, const re2::StringPiece& text, std::string_view line,
                          const std::vector<Token>& tokens) {
    PrintedNumber number{1, 0, 1, true};
    const auto end = static_cast<std::size_t>(text.data() - line.data()) + text.size();
    const auto token = std::ranges::find(tokens, end, &Token::end);
    if (!text.empty() && token != tokens.end()) number = token->number;
    const bool is_negative = (sign == "-") != (text.starts_with("-"));
    number.value = is_negative ? -std::abs(number.value) : std::abs(number.value);
    return number;
}

}  // namespace

std::optional<QuadraticLine> read_quadratic(std::string_view line) {
    constexpr std::size_t longest = 1000;
    static const RE2 pattern = [] {
        const std::string number = R"(\(?\s*([-+]?\s*(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*\)?\s*\*?\s*)";
        return R"((?:^|[^\w.])(([-+]?)\s*(?:)" + number + R"()?t\s*(?:\^\s*2|\*\s*t|2|t)\s*([-+])\s*(?:)" + number +
               R"()?t\s*([-+])\s*)" + number + R"(=\s*0(?:\.0*)?))";
    }();
    std::array<re2::StringPiece, 8> groups;
    const re2::StringPiece text(line.data(), line.size());
    if (line.size() > longest || line.find('t') == std::string_view::npos ||
        !pattern.Match(text, 0, line.size(), RE2::UNANCHORED, groups.data(), 8))
        return std::nullopt;
    const std::vector<Token> tokens = tokenize(line);
    QuadraticLine found;
    for (std::size_t k = 0; k < 3; ++k) {
        PrintedValue value;
        value.numbers = {coefficient(groups.at(2 + 2 * k), groups.at(3 + 2 * k), line, tokens)};
        value.label = std::string(1, "abc"[k]);
        value.printed = std::string(groups[1].substr(0, longest_printed));
        found.values.push_back(std::move(value));
    }
    found.end = static_cast<std::size_t>(groups[1].data() - line.data()) + groups[1].size();
    return found;
}

}  // namespace harness
