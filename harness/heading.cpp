#include "harness/heading.h"

#include <re2/re2.h>

#include <algorithm>
#include <set>
#include <string>

#include "harness/token.h"

namespace harness {
namespace {

/// What may stand before a heading's first word: blanks and decoration.
constexpr const char* decoration = R"(^[\s*=\-_#~+|/\\<>.:!\[({"'`]*)";
/// What may close its number.
constexpr const char* closing = R"((?:\s*[a-h]\b)?[\s*=_#~+|\\\])}"'`]*(?:[:.)\]\-,;>=]+|\s|$))";

constexpr const char* keywords =
    R"((?i:questions?|quest|ques|q|exercises?|ex|exo|parts?|problems?|prob|answers?|ans|a(?:nswer)? to question|tasks?|items?|steps?|nr|no|number|aufgabe|frage|pregunta|ejercicio))";

const RE2& keyword_heading() {
    static const RE2 pattern(std::string("(") + decoration + "(?:" + "(?i:assignment 6,? |a6,? |answer (?:to|for) )?" + keywords +
                             R"()[.\s]*[#:.\-_(\[]*\s*(?:no\.?\s*|nr\.?\s*)?#?(\d{1,2}))" + closing + ")");
    return pattern;
}

const RE2& spelled_heading() {
    static const RE2 pattern(std::string("(") + decoration + "(?:" + keywords +
                             R"()\s+(?i:(one|two|three|four|five|six|seven|eight|nine|ten))\b[\s:.)\-*=]*))");
    return pattern;
}

const RE2& bare_heading() {
    static const RE2 pattern(R"((^[\s*=\-_#~+|/\[(]*(\d{1,2})\s*(?:[.):\]][\s.)\]:*=\-_#~|]*|[\s*=\-_#~|]*$)))");
    return pattern;
}

int spelled_number(std::string word) {
    std::transform(word.begin(), word.end(), word.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    constexpr std::string_view names[] = {"one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten"};
    return static_cast<int>(std::find(std::begin(names), std::end(names), word) - std::begin(names)) + 1;
}

std::optional<Heading> match_number(std::string_view line, const RE2& pattern, bool has_keyword) {
    re2::StringPiece whole;
    int question = 0;
    if (!RE2::PartialMatch(re2::StringPiece(line.data(), line.size()), pattern, &whole, &question)) return std::nullopt;
    if (question < 1) return std::nullopt;
    return Heading{question, whole.size(), has_keyword};
}

/// Whether a bare number starts a list of numbers, such as a matrix row "1. 0. 0. 4.", or stands alone as an answer.
bool is_row_of_numbers(std::string_view line) {
    constexpr std::size_t row_tokens = 64;
    std::size_t numbers = 0;
    std::size_t words = 0;
    for (const Token& token : tokenize(line.substr(0, 512))) {
        if (token.kind == Token::Kind::number) ++numbers;
        if (token.kind == Token::Kind::word) ++words;
        if (numbers + words > row_tokens) break;
    }
    return words == 0 && numbers != 1;
}

/// Bare numbers are headings when they count the questions: at least three different ones.
bool counts_questions(const std::vector<std::optional<Heading>>& headings) {
    std::set<int> numbers;
    for (const auto& heading : headings) {
        if (heading && heading->question <= 10) numbers.insert(heading->question);
    }
    return numbers.size() >= 3;
}

}  // namespace

std::optional<Heading> read_heading(std::string_view line) {
    constexpr std::size_t longest_heading = 200;
    const std::string_view start = line.substr(0, longest_heading);
    if (auto heading = match_number(start, keyword_heading(), true)) return heading;
    re2::StringPiece whole;
    std::string word;
    if (RE2::PartialMatch(re2::StringPiece(start.data(), start.size()), spelled_heading(), &whole, &word)) {
        return Heading{spelled_number(word), whole.size(), true};
    }
    auto heading = match_number(start, bare_heading(), false);
    if (!heading || heading->question > 10) return std::nullopt;
    const bool decorated = start.find_first_of("*=-_#~+|/[(") < start.find_first_of("0123456789");
    const bool alone = start.find_first_not_of(" \t", heading->end) == std::string_view::npos;
    const std::string_view number_end = start.substr(0, heading->end);
    if (number_end.find_first_of(".):]") == std::string_view::npos && !decorated) return std::nullopt;  // a lone number
    if (!alone && is_row_of_numbers(start) && number_end.find_first_of("):]") == std::string_view::npos) return std::nullopt;
    return heading;
}

std::vector<std::optional<Heading>> find_headings(const std::vector<std::string_view>& lines) {
    std::vector<std::optional<Heading>> headings;
    headings.reserve(lines.size());
    bool any_keyword = false;
    for (const std::string_view line : lines) {
        headings.push_back(read_heading(line));
        any_keyword = any_keyword || (headings.back() && headings.back()->has_keyword);
    }
    if (any_keyword || !counts_questions(headings)) {
        for (auto& heading : headings) {
            if (heading && !heading->has_keyword) heading.reset();
        }
    }
    return headings;
}

}  // namespace harness
