#include "harness/read/lines/output_lines.h"

#include <re2/re2.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "harness/read/lines/clean_text.h"
#include "harness/read/lines/tags.h"

namespace harness {
namespace {

/// Appends a line. Splits it where a heading follows a value without a line break: "t: 0.61Question 7:".
void append_line(std::vector<OutputLine>& lines, std::string_view text, int number) {
    static const RE2 heading(
        R"((?:[\d)\]}>.;]\s*|\s\s)((?:Question|QUESTION|Quest|Ques|Exercise|EXERCISE|Problem|PROBLEM|Q)[\s_.]*#?\s?\d{1,2}\s?[:.)\]\-]))");
    re2::StringPiece rest(text.data(), text.size());
    re2::StringPiece found;
    while (RE2::FindAndConsume(&rest, heading, &found)) {
        const auto before = static_cast<std::size_t>(found.data() - text.data());
        if (text.substr(0, before).find_first_not_of(" \t") == std::string_view::npos) continue;
        lines.push_back({text.substr(0, before), number});
        text.remove_prefix(before);
    }
    lines.push_back({text, number});
}

/// The line without what a log begins it with: "[12:00:06] ", "[0.003s] ", "[LOG 0.030] ", "ray_cast.cpp:42: ",
/// "2021-10-31 23:14:01.001 INFO - ".
std::string_view without_time(std::string_view line) {
    static const RE2 time(
        R"(^(\s*\[?(?:\d{4}-\d\d-\d\d[ T])?\d\d?:\d\d:\d\d(?:[.,]\d+)?\]?\s+(?:[\[(]?(?:INFO|DEBUG|TRACE|LOG|WARN|WARNING)[\])]?[\s:\-]*\s)?))");
    static const RE2 place(
        R"(^(\s*(?:\[\s*\d+(?:\.\d+)?\s*(?:s|ms|us)\s*\]|\[(?:INFO|DEBUG|TRACE|LOG)\s+[\d.:]+\]|[\w./\-]+\.(?:cpp|cc|cxx):\d+:)\s+))");
    re2::StringPiece found;
    for (const RE2* pattern : {&time, &place}) {
        if (RE2::PartialMatch(re2::StringPiece(line.data(), line.size()), *pattern, &found))
            line.remove_prefix(found.size());
    }
    return line;
}

/// The text without what each line begins with that is not empty: as many bytes as `length_of_head(line, number)` says,
/// with the line's number from 1. Empty if it says 0 of a line.
template <class LengthOfHead>
std::optional<std::string> without_heads(const std::string& text, LengthOfHead length_of_head) {
    std::string rest;
    int number = 0;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        std::string_view line = std::string_view(text).substr(begin, end - begin);
        ++number;
        if (line.find_first_not_of(" \t") != std::string_view::npos) {
            const std::size_t length = length_of_head(line, number);
            if (length == 0) return std::nullopt;
            line.remove_prefix(length);
        }
        rest += line;
        if (end < text.size()) rest += '\n';
        begin = end + 1;
    }
    return rest;
}

/// The text without the numbers of its lines, where each line that is not empty has its own, "4: " or " 4| ", and they
/// are more than there are questions, which may be numbered so too.
std::string without_line_numbers(std::string text, int last_question) {
    static const RE2 numbered(R"(^(\s*(\d{1,5})[:|](?:\s|$)))");
    const auto lines = std::ranges::count(text, '\n') + (text.ends_with('\n') || text.empty() ? 0 : 1);
    if (lines <= last_question) return text;
    auto rest = without_heads(text, [&](std::string_view line, int number) {
        re2::StringPiece head;
        int found = 0;
        const bool is_numbered =
            RE2::PartialMatch(re2::StringPiece(line.data(), line.size()), numbered, &head, &found) && found == number;
        return is_numbered ? head.size() : 0;
    });
    return rest ? std::move(*rest) : std::move(text);
}

/// The text without the prompt, "out> ", that each of its lines that is not empty begins with.
std::string without_prompt(std::string text) {
    constexpr int fewest = 5;
    static const RE2 pattern(R"(^\s*([A-Za-z][\w.\-]{0,30}\s?>))");
    std::string prompt;
    if (!RE2::PartialMatch(text, pattern, &prompt)) return text;
    int lines = 0;
    auto rest = without_heads(text, [&](std::string_view line, int /*number*/) {
        const std::size_t first = line.find_first_not_of(" \t");
        ++lines;
        return line.substr(first).starts_with(prompt) ? first + prompt.size() : 0;
    });
    return rest && lines >= fewest ? std::move(*rest) : std::move(text);
}

/// Whether what is worked out on a line goes on on the next: "V = (0, 0, -2) / 2" above "= (0, 0, -1)", or with the '='
/// at the line's end. An '=' behind a name alone may stand above a matrix.
bool goes_on(std::string_view line, std::string_view next) {
    constexpr std::size_t longest = 200;
    static const RE2 begins_with_result(R"(\s*=>?\s*[-+]?\s*(?:\d|[(\[{<]|[dui]?vec[234]|sqrt).*)");
    static const RE2 ends_worked_out(
        R"(.*[=:]\s*[-+]?[(\[{<\d][-+*/x\d.,eE\s(){}\[\]<>]*[*/+\-x][-+*/x\d.,eE\s(){}\[\]<>]*=\s*)");
    static const RE2 result(R"(\s*[-+]?\s*(?:\d|[(\[{<]|[dui]?vec[234]).*)");
    if (line.size() > longest || next.size() > longest || line.find_first_not_of(" \t") == std::string_view::npos)
        return false;
    const re2::StringPiece before(line.data(), line.size()), after(next.data(), next.size());
    const std::size_t first = next.find_first_not_of(" \t");
    if (first == std::string_view::npos) return false;
    if (next[first] == '=' && RE2::FullMatch(after, begins_with_result)) {
        const bool is_arrow = next.substr(first).starts_with("=>");
        return !is_arrow || line.find('=') != std::string_view::npos;
    }
    const bool ends_with_equals = line[line.find_last_not_of(" \t")] == '=';
    return ends_with_equals && RE2::FullMatch(before, ends_worked_out) && RE2::FullMatch(after, result);
}

}  // namespace

std::string readable_text(std::string_view output, int last_question) {
    return without_line_numbers(without_prompt(without_tags(clean_text(output))), last_question);
}

std::vector<OutputLine> split_lines(std::string& text) {
    constexpr int most_joined = 6;
    const auto end_from = [&](std::size_t begin) { return std::min(text.find('\n', begin), text.size()); };
    std::vector<OutputLine> lines;
    int number = 1;
    for (std::size_t begin = 0; begin < text.size();) {
        std::size_t last = begin, end = end_from(begin);  // of the last line that is joined
        int joined = 1;
        for (; end < text.size() && joined < most_joined; ++joined) {
            const std::size_t next = end + 1, end_of_next = end_from(next);
            const std::string_view all(text);
            if (!goes_on(all.substr(last, end - last), all.substr(next, end_of_next - next))) break;
            text[end] = ' ';
            last = next;
            end = end_of_next;
        }
        append_line(lines, without_time(std::string_view(text).substr(begin, end - begin)), number);
        number += joined;
        begin = end + 1;
    }
    return lines;
}

}  // namespace harness
