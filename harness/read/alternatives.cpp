#include "harness/read/alternatives.h"

#include <re2/re2.h>

#include <algorithm>

namespace harness {
namespace {

bool has(std::string_view text, const RE2& pattern) {
    constexpr std::size_t longest = 400;
    return RE2::PartialMatch(re2::StringPiece(text.data(), std::min(text.size(), longest)), pattern);
}

}  // namespace

bool offers_several(std::string_view line) {
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

bool gives_two_numbers(std::string_view line) {
    static const RE2 pattern(
        R"((?i)^[^:=,&/]*[:=]\s*[-+]?[\d.]+(?:e[-+]?\d+)?\s*(?:and|&)\s*[-+]?[\d.]+(?:e[-+]?\d+)?\W*$)");
    static const RE2 several_names(R"((?i)^[^:=]*\band\b[^:=]*[:=])");
    return has(line, pattern) && !has(line, several_names);
}

bool chooses_other_root(std::string_view line) {
    static const RE2 larger(
        R"((?i)\b(?:us(?:e|ed|ing)|tak(?:e|en|ing)|took|choos(?:e|ing)|chosen?|pick(?:ed|ing)?|select(?:ed|ing)?)\b.*\b(?:larger|larg?est|bigger|second|far(?:ther|thest)?|t_?(?:2|max|far|plus))\b)");
    static const RE2 by_name(
        R"((?i)^\W*t\w*\s*(?:=|is|:|->)\s*(?:t_?(?:\d|near|far|min|max|minus|plus|small\w*|large\w*)|root\w*|x_?\d)\W*$)");
    return has(line, larger) || has(line, by_name);
}

bool is_alternative(std::string_view line) {
    static const RE2 pattern(R"((?i)^\W*or\b\W*(?:[-+]?\s*[\d.(\[{<]|[dui]?vec\d|mat\d))");
    return has(line, pattern);
}

}  // namespace harness
