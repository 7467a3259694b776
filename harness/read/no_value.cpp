#include "harness/read/no_value.h"

#include <re2/re2.h>

#include <string>

namespace harness {

std::optional<PrintedValue> read_no_value(std::string_view line) {
    constexpr std::size_t longest = 300;
    static const RE2 pattern(
        R"((?i)^\s*(.{0,80}?)\s*(?:[:=]|->|\s-\s|\.{3,}|\s{2,}|\t|\|)\s*[(<"'\[]*\s*(?:the )?((?:none|no |not |non-?existent|n/?a\b|nil\b|null\b|undefined|does not|doesn't|miss|imaginary|complex|-+\s*$|invalid|there is no|ray (?:misses|does not|doesn't|never)).*)$)");
    static const RE2 unlabelled(
        R"((?i)^\s*[(<"'\[*]*\s*((?:none|no (?:(?:real|positive|valid|such|true) )*(?:hit|intersection|solution|root|normal|t\b)|not? hit|n/a\b|(?:the )?ray (?:misses|does not hit|doesn't hit)|there is no (?:hit|intersection)|miss(?:es|ed)?\b).*)$)");
    re2::StringPiece label;
    re2::StringPiece words;
    const std::string_view start = line.substr(0, longest);
    const re2::StringPiece piece(start.data(), start.size());
    static const RE2 sentence(
        R"((?i)(\b(?:no (?:real|positive) (?:root|solution|value)s?\b|(?:ray|it) (?:misses|does not hit|doesn't hit|never hits)|no (?:hit|intersection)\b).*)$)");
    static const RE2 conditional(R"((?i)\bif\b|\?|\bwhether\b|\bwhen\b)");
    if (!RE2::PartialMatch(piece, pattern, &label, &words) && !RE2::PartialMatch(piece, unlabelled, &words)) {
        if (RE2::PartialMatch(piece, conditional) || !RE2::PartialMatch(piece, sentence, &words)) return std::nullopt;
    }
    PrintedValue value;
    value.label = std::string(label);
    value.printed = std::string(words.substr(0, 200));
    return value;
}

bool says_what_its_number_means(std::string_view line) {
    static const RE2 pattern(
        R"((?i)\(\s*-?[\d.]+\s*(?:means|stands for|is|=|->|:|for)\s*(?:that )?(?:there (?:is|was) |the ray )?(?:no\b|none|miss|not? hit))");
    return RE2::PartialMatch(re2::StringPiece(line.data(), line.size()), pattern);
}

}  // namespace harness
