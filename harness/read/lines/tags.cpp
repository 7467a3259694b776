#include "harness/read/lines/tags.h"

#include <re2/re2.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
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

/// Whether the text is a page of HTML or a piece of one. <a>, <b> and <u> may be XML that is named by the items.
bool is_html(std::string_view text) {
    constexpr int fewest = 3;
    static const RE2 tag(R"((?i)<(?:html|body|div|h[1-6]|pre|br|ol|ul|li|table|tr|td|th)(?:\s[^<>]{0,200})?/?>)");
    re2::StringPiece rest(text.data(), text.size());
    int found = 0;
    while (found < fewest && RE2::FindAndConsume(&rest, tag)) ++found;
    return found == fewest;
}

/// Shows lists: their items begin lines, and those of ordered lists that stand in no other have numbers, from 6 on for
/// "<ol start="6">". `open` has the next number of each list that the text stands in, 0 for one without numbers.
void show_lists(std::string& line, std::vector<int>& open) {
    static const RE2 list_tag(R"((?i)(<(?:ol(?:\s[^<>]*?)?|ul(?:\s[^<>]*)?|/ol|/ul|li(?:\s[^<>]*)?)>))");
    static const RE2 ordered(R"re((?i)<ol(?:.*\sstart\s*=\s*["']?(\d{1,2}))?.*)re");
    static const RE2 unordered("(?i)<ul.*"), end("</.*");
    std::string numbered;
    re2::StringPiece rest(line), tag;
    const char* begin = line.data();
    while (RE2::FindAndConsume(&rest, list_tag, &tag)) {
        numbered.append(begin, tag.data());
        begin = tag.data() + tag.size();
        const std::size_t last = numbered.find_last_not_of(" \t");
        const bool begins_line = last == std::string::npos || numbered[last] == ';' || numbered[last] == '>';
        if (!begins_line && tag[1] != '/') numbered += "; ";
        std::string start;
        if (RE2::FullMatch(tag, ordered, &start)) {
            open.push_back(start.empty() ? 1 : std::stoi(start));
        } else if (RE2::FullMatch(tag, unordered)) {
            open.push_back(0);
        } else if (RE2::FullMatch(tag, end)) {
            if (!open.empty()) open.pop_back();
        } else if (open.size() == 1 && open.back() != 0) {
            numbered += std::to_string(open.back()++) + ") ";
        }
    }
    numbered.append(begin, static_cast<const char*>(line.data()) + line.size());
    line = numbered;
}

/// The text without comments, scripts and other pieces that a browser does not show; its lines stay.
std::string without_what_is_not_shown(std::string_view text) {
    static const RE2 piece(
        R"((?is)(<!--.*?(?:-->|$)|<(?:script|template|style)(?:\s[^<>]*)?>.*?(?:</(?:script|template|style)>|$)))");
    std::string shown;
    re2::StringPiece rest(text.data(), text.size()), found;
    const char* begin = text.data();
    while (RE2::FindAndConsume(&rest, piece, &found)) {
        shown.append(begin, found.data());
        std::ranges::copy_if(found, std::back_inserter(shown), [](char c) { return c == '\n'; });
        begin = found.data() + found.size();
    }
    shown.append(begin, text.data() + text.size());
    return shown;
}

/// Each line of HTML as it is shown, but still one line.
std::string without_html(std::string_view text) {
    static const RE2 row_end(R"((?i)<br\s*/?>|</(?:li|p|tr|div|h[1-6])>)");
    static const RE2 begins_behind(R"((?i)([^;>\s])\s*<(?:p|div|h[1-6]|table|tr)(?:\s[^<>]*)?>)");
    static const RE2 cell(R"((?i)<t[dh](?:\s[^<>]*)?>)");
    static const RE2 below("(?i)<sub>"), above("(?i)<sup>"), minus("&minus;"), less("&lt;"), greater("&gt;"),
        blank("&nbsp;");
    static const RE2 tag(R"(</?[A-Za-z][^<>]*>|<![^<>]*>)");
    std::string plain;
    std::vector<int> open;
    for (const std::string_view each : lines_of(text)) {
        std::string line(each);
        show_lists(line, open);
        RE2::GlobalReplace(&line, row_end, "; ");
        RE2::GlobalReplace(&line, begins_behind, "\\1; ");
        RE2::GlobalReplace(&line, cell, "  ");
        RE2::GlobalReplace(&line, below, "_");
        RE2::GlobalReplace(&line, above, "^");
        RE2::GlobalReplace(&line, tag, "");
        for (const auto& [entity, sign] : {std::pair(&minus, "-"), {&less, "<"}, {&greater, ">"}, {&blank, " "}})
            RE2::GlobalReplace(&line, *entity, sign);
        plain += line + '\n';
    }
    if (!text.ends_with('\n') && !plain.empty()) plain.pop_back();
    return plain;
}

}  // namespace

std::string without_tags(std::string_view text) {
    if (text.find('<') == std::string_view::npos) return std::string(text);
    const std::string shown = without_what_is_not_shown(text);
    text = shown;
    if (is_html(text)) return without_html(text);
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
