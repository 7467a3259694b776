#include "harness/mark/score/other_answers.h"

#include <re2/re2.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

#include "harness/read/first_object.h"
#include "harness/text/letters.h"

namespace harness {
namespace {

constexpr std::size_t longest = 400;
constexpr int nearby = 40;  // lines

bool has(std::string_view text, const RE2& pattern) {
    return RE2::PartialMatch(re2::StringPiece(text.data(), std::min(text.size(), longest)), pattern);
}

/// Whether a line of an answer offers another one, and does not choose between them.
bool offers_another(std::string_view line) {
    static const RE2 alternative(
        R"((?i)[\d)\]}>]\s*,?\s*\bor\b\s*(?:[-+]?\s*[\d.(\[{<]|[dui]?vec\d|mat\d|minus\b|(?:its|the)\s+(?:negative|opposite)))");
    static const RE2 both_signs(R"((?i)[:=]\s*(?:\+/-|\+-|±|-/\+|-\+)\s*(?:[\d.(\[{<]|[dui]?vec\d))");
    static const RE2 withdrawn(
        R"((?i)[\d)\]}>][\s.?]*[(,;\-]*\s*(?:(?:is|was)\s+)?(?:wrong\b|incorrect\b|no\s*[,:]\s*[-+\d(v]))");
    static const RE2 chosen(R"((?i)->|=>|\b(?:so|take|taking|choos\w+|us(?:e|ing)|pick\w*|select\w*|therefore)\b)");
    const std::size_t last_or = line.rfind(" or ");  // a choice is made behind it: not by the arrow of "t ==> 1 or 3"
    const std::string_view behind = line.substr(last_or == std::string_view::npos ? 0 : last_or);
    return (has(line, alternative) && !has(behind, chosen)) || has(line, both_signs) || has(line, withdrawn);
}

/// Whether a line takes its answer back or is not sure of it: "~~t = 2~~", "probably the sphere", "sphere (or the
/// triangle)".
bool is_unsure(std::string_view line) {
    static const RE2 pattern(
        R"((?i)~~|<(?:del|s|strike)>|<[^>]*\shidden\b|\[ \]|\b(?:maybe|perhaps|probably|possibly|not\s+sure|guess(?:ing)?|i\s+think|todo|fixme|vielleicht)\b)");
    static const RE2 or_another(R"((?i)\bor\s+(?:the\s+)?(?:sphere|triangle|cylinder)\b)");
    static const RE2 denied(
        R"((?i)\b(?:not|neither|no|none|nothing|miss\w*|doesn't)\b)");  // "hits no sphere or triangle"
    return has(line, pattern) || (has(line, or_another) && !has(line, denied));
}

/// Whether a line gives two numbers under one name, "b: -4 and 4".
bool gives_two_numbers(std::string_view line) {
    static const RE2 pattern(
        R"((?i)^([^:=]*)[:=]\s*[-+]?[\d.]+(?:e[-+]?\d+)?\s*(?:and|&)\s*[-+]?[\d.]+(?:e[-+]?\d+)?\W*$)");
    static const RE2 several_names(R"((?i),|&|/|\band\b)");
    re2::StringPiece names;
    return RE2::FullMatch(re2::StringPiece(line.data(), std::min(line.size(), longest)), pattern, &names) &&
           !RE2::PartialMatch(names, several_names);
}

/// Whether the item is a number that is one, as a t is not: an equation has two roots.
bool is_one_number(const reference::ItemSpec& item) {
    return item.shape == reference::Shape::scalar && item.id.name != "t";
}

/// Whether a line says that it is another answer than that above.
bool is_alternative(std::string_view line) {
    static const RE2 pattern(R"((?i)^\W*or\b\W*(?:[-+]?\s*[\d.(\[{<]|[dui]?vec\d|mat\d))");
    return has(line, pattern);
}

/// Whether a line chooses the other of two roots, or another number by its name: "using the larger root", "t = t2".
bool chooses_other(std::string_view line) {
    static const RE2 larger(
        R"((?i)\b(?:us(?:e|ed|ing)|tak(?:e|en|ing)|took|choos(?:e|ing)|chosen?|pick(?:ed|ing)?|select(?:ed|ing)?)\b.*\b(?:larger|larg?est|bigger|second|far(?:ther|thest)?|t_?(?:2|max|far|plus))\b)");
    static const RE2 by_name(
        R"((?i)\W*t\w*\s*(?:=|is|:|->)\s*(?:t_?(?:\d|near|far|min|max|minus|plus|small\w*|large\w*)|root\w*|x_?\d)\W*)");
    return has(line, larger) || RE2::FullMatch(re2::StringPiece(line.data(), std::min(line.size(), longest)), by_name);
}

bool has_digit(std::string_view text) {
    return std::ranges::any_of(text, is_digit);
}

/// Whether the line is an object's name alone, as above what is printed of it: "--- The sphere ---".
bool is_title(std::string_view line) {
    static const RE2 pattern(
        R"((?i)\W*(?:for\s+|with\s+|about\s+)?(?:the\s+)?(?:ray\W+)?\w+(?:\s+(?:intersection|test|hit|part))?\W*)");
    return RE2::FullMatch(re2::StringPiece(line.data(), std::min(line.size(), longest)), pattern);
}

/// Whether the line is about a part of an object or its normal: "top cap: none", "Sphere normal".
bool is_about_a_part(std::string_view line) {
    static const RE2 pattern(
        R"((?i)\b(?:normal\w*|caps?|tube|body|side|dis[ck]|plane|top|bottom|deckel|boden|mantel)\b)");
    return has(line, pattern);
}

/// A line nearby in the same section that names another object as the first.
int line_of_another_object(const Section& section, const PrintedLine& own) {
    const auto own_object = read_first_object({own}, FirstObjectPlace::own_section);
    if (!own_object || has_digit(own.text)) return 0;
    for (const PrintedLine& line : section.lines) {
        const bool is_nearby = std::abs(line.number - own.number) <= nearby;
        if (line.number == own.number || !is_nearby || has_digit(line.text) || is_about_a_part(line.text)) continue;
        if (is_title(line.text) && !is_title(own.text)) continue;
        const auto other = read_first_object({line}, FirstObjectPlace::own_section);
        if (other && other->object != own_object->object) return line.number;
    }
    return 0;
}

}  // namespace

int line_of_another_answer(const Transcript& transcript, const ItemScore& item) {
    if (item.line == 0) return 0;
    for (const Section& section : transcript.sections) {
        for (const PrintedLine& line : section.lines) {
            const bool is_own = item.line <= line.number && line.number <= item.last_line;
            if (item.spec.shape == reference::Shape::first_object) {
                if (!is_own) continue;
                if (is_unsure(line.text)) return line.number;
                if (const int other = line_of_another_object(section, line); other != 0) return other;
            } else if ((is_own &&
                        (offers_another(line.text) || (is_one_number(item.spec) && gives_two_numbers(line.text)))) ||
                       (line.number == item.last_line + 1 && is_alternative(line.text)) ||
                       (item.spec.id.name == "t" && section.question == item.spec.question &&
                        std::abs(line.number - item.line) <= nearby && chooses_other(line.text))) {
                return line.number;
            }
        }
    }
    return 0;
}

}  // namespace harness
