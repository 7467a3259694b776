#include "harness/read/no_value.h"

#include <re2/re2.h>

#include <string>

#include "reference/stages/items.h"

namespace harness {
namespace {

constexpr std::size_t longest = 300;

// After a label and a separator, anything that begins like this says that there is no value.
constexpr const char* after_separator =
    R"((?i)^\s*(.{0,80}?)\s*(?:[:=]|->|\s-\s|\.{3,}|\s{2,}|\t|\|)\s*[(<"'\[]*\s*(?:the )?((?:none|no |not |non-?existent|n/?a\b|nil\b|null\b|undefined|does not|doesn't|miss|imaginary|complex|-+\s*$|\{\s*\}|invalid|there is no|ray (?:misses|does not|doesn't|never)).*)$)";

// After a label alone, or "is", only words that end the line or a part of it: "t is none", "[t] none", "t,none".
constexpr const char* after_label =
    R"((?i)^\s*[(<"'\[{*]*(\S(?:.{0,40}?\S)??)[)>"'\]}*]*(?:\s+|\s*,\s*)(?:(?:is|are|was|were|has|have)\s+)?[(<"'\[]*((?:none|n/?a|nil|null|undefined|imaginary|invalid|non-?existent|missed|not (?:defined|applicable|hit|real|existent)|no (?:real |positive |valid |such )?(?:value|hit|hit point|intersection|solution|root|point|normal)s?|does(?: not|n't) exist|do(?: not|n't) exist|does(?: not|n't) apply)[)>"'\]]*\s*(?:[.!;,].*)?)$)";

constexpr const char* without_label =
    R"((?i)^\s*[(<"'\[*]*\s*((?:none|no (?:(?:real|positive|valid|such|true) )*(?:hit|intersection|solution|root|normal|t\b)|not? hit|n/a\b|(?:the )?ray (?:misses|does not hit|doesn't hit)|there is no (?:hit|intersection)|miss(?:es|ed)?\b).*)$)";

std::string within_sentence() {
    std::string names;
    for (const reference::Subject object : reference::objects)
        names += (names.empty() ? "" : "|") + std::string(to_string(object));
    return R"((?i)(\b(?:no (?:real|positive) (?:root|solution|value)s?\b|(?:ray|it) (?:misses|does not (?:hit|intersect|meet)|doesn't (?:hit|intersect|meet)|never (?:hits|intersects|meets))|no (?:hit|intersection)\b|(?:not|never) (?:hit|intersected|met)\b|(?:passes|goes) (?:by |past |over |above |below |under |beside )?(?:the )?(?:)" +
           names + R"()|(?:hits?|intersects?|intersection)\s*[:=?]\s*(?:false|no)\b).*)$)";
}

// The discriminant and what it says: "d = -91 < 0, so no intersection".
constexpr const char* after_discriminant =
    R"((?i)^\s*(?:d|disc|discriminant|delta|b\^?2 ?- ?4 ?ac)\b.*-[\d.]+.*?[\s,;(]((?:there (?:is|are) )?no (?:real |positive )?(?:hit|intersection|solution|root)s?\b.*)$)";

bool finds(std::string_view text, const RE2& pattern, re2::StringPiece& words) {
    return RE2::PartialMatch(re2::StringPiece(text.data(), text.size()), pattern, &words);
}

PrintedValue no_value(re2::StringPiece label, re2::StringPiece words) {
    PrintedValue value;
    value.label = std::string(label);
    value.printed = std::string(words.substr(0, longest_printed));
    return value;
}

}  // namespace

std::optional<PrintedValue> read_no_value(std::string_view line) {
    static const RE2 separated(after_separator), alone(after_label), unlabelled(without_label),
        sentence(within_sentence());
    static const RE2 conditional(R"((?i)\bif\b|\?|\bwhether\b|\bwhen\b)");
    const std::string_view start = line.substr(0, longest);
    const re2::StringPiece piece(start.data(), start.size());
    re2::StringPiece label;
    re2::StringPiece words;
    if (RE2::PartialMatch(piece, separated, &label, &words)) return no_value(label, words);
    if (finds(start, unlabelled, words)) return no_value({}, words);
    if (RE2::PartialMatch(piece, conditional)) return std::nullopt;
    if (RE2::PartialMatch(piece, alone, &label, &words)) return no_value(label, words);
    if (finds(start, sentence, words)) return no_value({}, words);
    return std::nullopt;
}

std::optional<PrintedValue> read_no_value_after_discriminant(std::string_view line) {
    static const RE2 pattern(after_discriminant);
    re2::StringPiece words;
    // Every line with a number comes here, and hardly any has such words.
    if (line.find("no ") == std::string_view::npos && line.find("No ") == std::string_view::npos) return std::nullopt;
    if (!finds(line.substr(0, longest), pattern, words)) return std::nullopt;
    return no_value({}, words);
}

bool says_what_its_number_means(std::string_view line) {
    static const RE2 pattern(
        R"((?i)\(\s*-?[\d.]+\s*(?:means|stands for|is|=|->|:|for)\s*(?:that )?(?:there (?:is|was) |the ray )?(?:no\b|none|miss|not? hit))");
    return RE2::PartialMatch(re2::StringPiece(line.data(), line.size()), pattern);
}

}  // namespace harness
