#include "harness/read/number_in_sentence.h"

#include <re2/re2.h>

#include <algorithm>
#include <cmath>

#include "harness/read/words/hit_words.h"
#include "harness/text/lower_case.h"
#include "harness/text/plain_word.h"

namespace harness {
namespace {

using Kind = Token::Kind;

bool matches(std::string_view words, const RE2& pattern) {
    return RE2::FullMatch(re2::StringPiece(words.data(), words.size()), pattern);
}

/// Whether the token stands between a name and its value.
bool is_said(const LineTokens& tokens, std::size_t i) {
    static const RE2 word("(?i)is|equals?");
    return tokens.is(i, Kind::equals) || (i < tokens.size() && matches(tokens.text(i), word));
}

/// Whether a verb stands before the number and a name before the verb: "d is 8 so there are two roots". The word behind
/// the number makes it a count only where nothing is named, as in "there is 1 root".
bool is_told_of_a_name(const LineTokens& tokens, const NumberGroup& found) {
    static const RE2 verb("(?i)is|was|equals");
    static const RE2 nameless("(?i)there|here|it|this|that|which|what|number|count");
    return found.first >= 2 && tokens.is(found.first - 2, Kind::word) && matches(tokens.text(found.first - 1), verb) &&
           !matches(tokens.text(found.first - 2), nameless);
}

bool is_digit_alone(const LineTokens& tokens, std::size_t i) {
    return tokens.is(i, Kind::number) && tokens.text(i).size() == 1;
}

}  // namespace

bool is_reason_word(const LineTokens& tokens, std::size_t i) {
    return tokens.is(i, Kind::word) && meaning_of(lower_case(tokens.text(i))) == Meaning::reason;
}

bool is_in_sentence(const LineTokens& tokens, const NumberGroup& found, std::string_view label) {
    if (found.numbers.size() != 1 || found.numbers[0].decimals != 0 || found.first == 0) return false;
    static const RE2 counted("(?i)of|to|by|than|for|from|step|part");
    static const RE2 numbered("(?i)question|exercise|problem|aufgabe|frage");
    const std::string_view before = tokens.text(found.first - 1);
    if (matches(before, numbered)) return true;
    if (std::ranges::count(label, ' ') >= 4 && matches(before, counted)) return true;
    if (!tokens.is(found.first - 1, Kind::word) || !tokens.is(found.last, Kind::word)) return false;
    if (is_said(tokens, found.last + 1) || is_told_of_a_name(tokens, found)) return false;  // "a is 1 b is -4"
    const std::size_t gap = tokens[found.first].begin - tokens[found.first - 1].end;
    return gap <= 1 && label.find(' ') != std::string_view::npos;
}

bool is_compared(const LineTokens& tokens, const NumberGroup& found) {
    if (found.first == 0) return false;
    const std::size_t before = found.first - 1;
    return (tokens.is(found.last, Kind::compare) && is_reason_word(tokens, before)) ||
           (tokens.is(before, Kind::word) && lower_case(tokens.text(before)) == "than");
}

bool counts_roots(const LineTokens& tokens, std::size_t i) {
    static const RE2 kind("(?i)real|distinct|different|separate|positive|reelle|verschiedene");
    constexpr double most = 2;
    if (!tokens.is(i, Kind::number) || tokens[i].number.decimals != 0 || std::abs(tokens[i].number.value) > most)
        return false;
    std::size_t word = i + 1;
    if (!tokens.is(word, Kind::word)) return false;
    if (matches(tokens.text(word), kind)) ++word;
    return tokens.is(word, Kind::word) && meaning_of(lower_case(tokens.text(word))) == Meaning::hit;
}

bool is_index_of_row(const LineTokens& tokens, std::size_t open) {
    const auto is = [&](std::size_t i, Kind kind) { return tokens.is(i, kind); };
    if (!is(open, Kind::open)) return false;
    if (open == 0) {
        return tokens.text(open) == "[" && is(open + 2, Kind::close) && is_digit_alone(tokens, open + 1) &&
               (is(open + 3, Kind::number) || is(open + 3, Kind::open) || tokens.is_type(open + 3));
    }
    if (!is(open - 1, Kind::word) || !is(open + 2, Kind::comma) || !is(open + 4, Kind::close)) return false;
    const auto is_all = [&](std::size_t i) { return is(i, Kind::equals) && tokens.text(i) == ":"; };
    return (is(open + 1, Kind::number) && is_all(open + 3)) || (is_all(open + 1) && is(open + 3, Kind::number));
}

bool is_zero_of_equation(const PrintedValue& value, std::string_view before) {
    const bool zero = value.numbers.size() == 1 && value.numbers[0].value == 0 && value.numbers[0].decimals == 0;
    if (!zero) return false;
    const std::size_t colon = before.find(':');
    const bool has_unknowns = colon != std::string_view::npos && std::ranges::any_of(before.substr(colon), is_letter);
    return value.label.find('+') != std::string::npos ||
           (has_unknowns && before.find('+', colon) != std::string_view::npos);
}

bool is_truth_of_comparison(const PrintedValue& value, std::string_view before) {
    if (value.numbers.size() != 1 || value.numbers[0].decimals != 0) return false;
    static const RE2 comparison(R"(.*\w\s*[<>]=?\s*[-\w.].*)");
    return (value.numbers[0].value == 0 || value.numbers[0].value == 1) && matches(before, comparison);
}

}  // namespace harness
