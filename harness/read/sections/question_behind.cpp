#include "harness/read/sections/question_behind.h"

#include <fmt/format.h>
#include <re2/re2.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "harness/read/sections/heading.h"

namespace harness {
namespace {

/// A line's question and the line without it.
std::optional<std::pair<int, std::string>> question_behind(std::string_view line) {
    constexpr std::size_t longest = 400;
    static const RE2 in_brackets(
        R"((?i)(.*\S)\s*[(\[](?:question|exercise|problem|task|aufgabe|frage)\s*#?(\d{1,2})[)\]](\s*[=:].*|\s*))");
    static const RE2 as_remark(
        R"((?i)(.*\S)\s*(?://|#|<-+|--)\s*(?:question|exercise|problem|task|aufgabe|frage|q)\s*#?(\d{1,2})()\W*)");
    if (line.size() > longest) return std::nullopt;
    int question = 0;
    std::string before, behind;
    const re2::StringPiece text(line.data(), line.size());
    if (!RE2::FullMatch(text, in_brackets, &before, &question, &behind) &&
        !RE2::FullMatch(text, as_remark, &before, &question, &behind))
        return std::nullopt;
    return std::pair(question, before + behind);
}

/// How many questions are named at the beginning of a line.
std::size_t questions_headed(const std::vector<std::string_view>& lines, int last_question) {
    std::set<int> headed;
    for (const std::string_view line : lines) {
        const auto heading = read_heading(line, last_question);
        if (heading && heading->style == Heading::Style::question) headed.insert(heading->question);
    }
    return headed.size();
}

}  // namespace

std::string with_questions_first(std::string_view text, int last_question) {
    constexpr std::size_t fewest = 5;
    std::set<int> named;
    std::vector<std::string_view> others;
    std::string moved;
    for (std::string_view rest = text; !rest.empty();) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        const std::string_view line = rest.substr(0, end);
        const auto found = question_behind(line);
        if (found && found->first >= 1 && found->first <= last_question) {
            named.insert(found->first);
            moved += fmt::format("Q{} {}", found->first, found->second);
        } else {
            others.push_back(line);
            moved += line;
        }
        if (end < rest.size()) moved += '\n';
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    const bool is_usual = named.size() < fewest || questions_headed(others, last_question) >= named.size() / 2;
    return is_usual ? std::string(text) : moved;
}

}  // namespace harness
