#include "harness/read/tags.h"

#include <re2/re2.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "harness/text/lines.h"

namespace harness {
namespace {

constexpr std::size_t longest_tag_line = 1000;

/// A line that is an element with its value: "<a>1</a>".
struct Element {
    re2::StringPiece name, value;
};

std::optional<Element> element_in(std::string_view line) {
    static const RE2 pattern(R"(\s*<([A-Za-z_][\w.\-]*)(?:\s[^<>]*)?>([^<>]*)</([\w.\-]+)>\s*)");
    Element element;
    re2::StringPiece end;
    const bool is_one =
        line.size() <= longest_tag_line &&
        RE2::FullMatch(re2::StringPiece(line.data(), line.size()), pattern, &element.name, &element.value, &end) &&
        end == element.name;
    return is_one ? std::optional(element) : std::nullopt;
}

/// What stands on a line with a single tag; empty if there is something else.
std::optional<std::string> tag_alone(std::string_view line) {
    static const RE2 declaration_or_end(R"(\s*<(?:\?[^<>]*\?|/[\w.\-]+)>\s*)");
    static const RE2 question(
        R"(\s*<(?i:question|q|exercise|problem|task|aufgabe|frage)\s+(?i:number|no|nr|n|id|name|index)\s*=\s*["']q?(\d{1,2})["'][^<>]*>\s*)");
    static const RE2 begin(R"(\s*<([A-Za-z_][\w.\-]*)>\s*)");
    const re2::StringPiece text(line.data(), line.size());
    std::string name;
    if (line.size() > longest_tag_line) return std::nullopt;
    if (RE2::FullMatch(text, declaration_or_end)) return "";
    if (RE2::FullMatch(text, question, &name)) return "Question " + name + ":";
    if (RE2::FullMatch(text, begin, &name)) return name + ":";
    return std::nullopt;
}

std::string without_tags_of(std::string_view line) {
    static const RE2 of_row("(?i)row|line|r|item|value");
    if (const auto element = element_in(line)) {
        const std::string value(element->value);
        return RE2::FullMatch(element->name, of_row) ? value : std::string(element->name) + ": " + value;
    }
    return tag_alone(line).value_or(std::string(line));
}

}  // namespace

std::string without_tags(std::string_view text) {
    constexpr int fewest = 3;
    const std::vector<std::string_view> lines = lines_of(text);
    const auto elements =
        std::ranges::count_if(lines, [](std::string_view line) { return element_in(line).has_value(); });
    if (elements < fewest && !text.starts_with("<?xml")) return std::string(text);
    std::string plain;
    for (const std::string_view line : lines) plain += without_tags_of(line) + '\n';
    if (!text.ends_with('\n')) plain.pop_back();
    return plain;
}

}  // namespace harness
