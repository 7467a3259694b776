#include "harness/read/sections/counted_headings.h"

#include <re2/re2.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "harness/read/sections/heading_words.h"

namespace harness {
namespace {

/// A way to number questions that counts only if it numbers many of them, one behind the other.
struct ColumnForm {
    /// What group 3 of the pattern is: the number written otherwise, how many questions there are, or the question's
    /// number, where group 2 is the assignment's.
    enum class Third { alternative, total, question };
    RE2 pattern;  ///< group 1 is the heading, 2 the number
    Third third;
};

const std::array<ColumnForm, 9>& column_forms() {
    using enum ColumnForm::Third;
    const auto behind_decoration = [](const std::string& form) { return R"((^[\s*=\-_#(\[]*)" + form + ")"; };
    static const std::array<ColumnForm, 9> all = {
        // "| 6 | t | 0.59 |", "6\tt\t0.59"
        ColumnForm{
            RE2(R"((^\s*(?:[|\x{2502}]\s*(?:Q\s?)?(\d{1,2})\s*[|\x{2502}]|(?:Q\s?)?(\d{1,2})(?:\s*[;|,\x{2502}]|\t|\s{2,}))\s*)(?:[-+.]\s*)?[^\s\d.+\-])"),
            alternative},
        // "#6 t 0.59", "6 t = 0.59", "6-1 t = 0.59", "6.1 t = 0.59"
        ColumnForm{RE2(R"((^\s*#?(\d{1,2})(?:[.\-]\d)?\s+)[A-Za-z_(\[])"), alternative},
        // "6 - the sphere", "6 -> 0.59", "6.1 -> 0.59"
        ColumnForm{RE2(R"((^\s*(\d{1,2})(?:\s+-+|(?:\.\d)?\s*[-=]+>)(?:\s+|$)))"), alternative},
        // "VI.", but not "V:", which names the ray's direction
        ColumnForm{RE2(behind_decoration(R"((?i:(X|IX|IV|V?I{0,3}))\s?[.)\]]+(?:\s|$))")), alternative},
        // "SIX."
        ColumnForm{RE2(behind_decoration(std::string(number_words) + R"(\s?[.):\]]+(?:\s|$))")), alternative},
        // "A6:", "6th question"
        ColumnForm{
            RE2(behind_decoration(
                R"((?:A(\d{1,2})(?:[.):\]]+(?:\s|$)|\s*$)|(\d{1,2})(?:st|nd|rd|th)\s(?i:question|exercise|problem|task|answer)\b[\s:.)\]*=\-]*))")),
            alternative},
        // "[6/10]", "6 of 10"
        ColumnForm{RE2(behind_decoration(R"((\d{1,2})\s?(?:/|of)\s?(\d{1,2})(?:[\s:.)\]*=\-]+|$))")), total},
        // "HW6.2", "Exercise 6.2"
        ColumnForm{RE2(behind_decoration(R"((?:HW|A|)" + std::string(question_words) +
                                         R"()\s?(\d{1,2})\.(\d{1,2})(?:[\s:.)\]*=\-]+|$))")),
                   question},
        // "6.2", but not "6.2 1.5"
        ColumnForm{RE2(behind_decoration(R"((\d{1,2})\.(\d{1,2})(?:[:.)\]*=]+\s*|\s+|$))") + R"((?:$|[^\d\s.+\-]))"),
                   question}};
    return all;
}

int number_in(std::string_view digits_or_word) {
    constexpr std::array<std::string_view, 10> roman = {"I", "II", "III", "IV", "V", "VI", "VII", "VIII", "IX", "X"};
    int value = 0;
    const char* end = digits_or_word.data() + digits_or_word.size();
    if (std::from_chars(digits_or_word.data(), end, value).ptr == end && value > 0) return value;
    const auto found = std::find(roman.begin(), roman.end(), digits_or_word);
    return found != roman.end() ? static_cast<int>(found - roman.begin()) + 1 : spelled_number(digits_or_word);
}

/// The numbers in a line's heading: of the assignment, 0 without one, and of the question.
struct ColumnNumbers {
    int assignment;
    Heading heading;
};

std::optional<ColumnNumbers> heading_in(const ColumnForm& form, std::string_view start, int last_question) {
    using enum ColumnForm::Third;
    std::array<re2::StringPiece, 4> groups;
    if (!form.pattern.Match(re2::StringPiece(start.data(), start.size()), 0, start.size(), RE2::UNANCHORED,
                            groups.data(), 1 + form.pattern.NumberOfCapturingGroups()))
        return std::nullopt;
    const auto group_number = [&](std::size_t group) {
        return groups.at(group).empty() ? 0 : number_in(std::string_view(groups[group].data(), groups[group].size()));
    };
    const int second = group_number(2), third = group_number(3);
    if (form.third == total && third != last_question) return std::nullopt;
    const int found = form.third == question || second == 0 ? third : second;
    if (found < 1 || found > last_question) return std::nullopt;
    return ColumnNumbers{form.third == question ? second : 0,
                         {found, end_of(start, groups[1].size()), Heading::Style::column}};
}

/// The headings of this form; empty unless they number many questions, what belongs to each standing together.
std::vector<std::optional<Heading>> question_column(const ColumnForm& form, const std::vector<std::string_view>& lines,
                                                    int last_question) {
    constexpr std::size_t fewest = 5;
    std::vector<std::optional<Heading>> headings(lines.size());
    std::set<int> named, all, assignments;  // named: in this printing
    int last = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto numbers = heading_in(form, lines[i].substr(0, longest_heading), last_question);
        if (!numbers) continue;
        headings[i] = numbers->heading;
        assignments.insert(numbers->assignment);
        if (headings[i]->question == last) continue;
        last = headings[i]->question;
        all.insert(last);
        if (named.insert(last).second) continue;
        if (named.size() < fewest) return {};
        named = {last};  // as for another pixel
    }
    if (all.size() < fewest || assignments.size() != 1) headings.clear();
    return headings;
}

/// A line whose first cell, of a table with or without lines between its columns, begins with a number.
struct FirstCell {
    enum class End { line, gap, name };  ///< what stands behind the number: a drawn line, two blanks or more, a name
    int number;
    End end;
    std::size_t rest;  ///< offset of what follows
};

std::optional<FirstCell> first_cell(std::string_view line) {
    static const RE2 pattern(
        R"(^\s*(?:[|\x{2502}]\s*)?(?:Q\s?)?(\d{1,2})(?:\.?[a-h]\b|\([a-h]\)|\.\d\b)?[.)]?(\s*[|\x{2502}]\s*|\t\s*|\s{2,}|\s|)(\S))");
    static const RE2 name_in_cell(R"([A-Za-z_][^|\x{2502}\t]*?(?:[|\x{2502}\t]|\s{2}).*)");
    re2::StringPiece between, next;
    int number = 0;
    const re2::StringPiece start(line.data(), std::min(line.size(), longest_heading));
    if (!RE2::PartialMatch(start, pattern, &number, &between, &next)) return std::nullopt;
    const auto rest = static_cast<std::size_t>(next.data() - line.data());
    const auto has = [&](const char* sign) { return between.find(sign) != re2::StringPiece::npos; };
    if (has("|") || has("\u2502")) return FirstCell{number, FirstCell::End::line, rest};
    if (between.size() > 1 || has("\t")) return FirstCell{number, FirstCell::End::gap, rest};
    if (!RE2::FullMatch(re2::StringPiece(line.data() + rest, line.size() - rest), name_in_cell)) return std::nullopt;
    return FirstCell{number, FirstCell::End::name, rest};
}

/// The headings where the first column of a table goes up one by one from the first question to the last. Rows with
/// another number there or none belong to the question above. Empty if there is no such table.
std::vector<std::optional<Heading>> first_column(const std::vector<std::string_view>& lines, int last_question) {
    constexpr int fewest_without_lines = 5;
    std::vector<std::optional<Heading>> headings(lines.size());
    std::set<std::size_t> behind_gaps;  // where the second column begins
    bool is_drawn = false;
    int last = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto cell = first_cell(lines[i]);
        if (!cell || (cell->number != last && cell->number != last + 1)) continue;
        if (cell->number == 0) continue;
        last = cell->number;
        is_drawn = is_drawn || cell->end == FirstCell::End::line;
        if (cell->end == FirstCell::End::gap) behind_gaps.insert(cell->rest);
        headings[i] = Heading{last, cell->rest, Heading::Style::column};
    }
    const bool is_table = is_drawn ? behind_gaps.empty() : behind_gaps.size() == 1 && last >= fewest_without_lines;
    if (!is_table || last != last_question) headings.clear();
    return headings;
}

/// The headings where each question or part of one is numbered alone on a line, "2.3" or "5"; empty unless these
/// numbers go up one by one, from the first question or its first part to the last question. A line with another number
/// alone is an answer, but one with the same number again may be the heading just as well.
std::vector<std::optional<Heading>> lone_numbers(const std::vector<std::string_view>& lines, int last_question) {
    constexpr std::size_t fewest = 5;
    static const RE2 pattern(R"(\s*(\d{1,2})(?:\.(\d))?\s*)");
    std::vector<std::optional<Heading>> headings(lines.size());
    std::map<std::pair<int, int>, int> times;  // that a question's number and its part's, 0 without one, stand alone
    std::vector<std::pair<int, int>> numbers;  // of the headings
    for (std::size_t i = 0; i < lines.size(); ++i) {
        re2::StringPiece part;
        int question = 0;
        const re2::StringPiece line(lines[i].data(), lines[i].size());
        if (line.size() > longest_heading || !RE2::FullMatch(line, pattern, &question, &part)) continue;
        const std::pair<int, int> here(question, part.empty() ? 0 : part[0] - '0');
        ++times[here];
        const std::pair<int, int> last = numbers.empty() ? std::pair(0, 0) : numbers.back();
        const bool is_next_part = here.first == last.first && last.second > 0 && here.second == last.second + 1;
        const bool is_next_question = here.first == last.first + 1 && here.second <= 1;
        if (!is_next_part && !is_next_question) continue;
        numbers.push_back(here);
        headings[i] = Heading{question, lines[i].size(), Heading::Style::column};
    }
    const bool are_headings =
        numbers.size() >= fewest && numbers.back().first == last_question &&
        std::ranges::all_of(numbers, [&](const auto& question_and_part) { return times[question_and_part] == 1; });
    if (!are_headings) headings.clear();
    return headings;
}

/// A line that begins with a word and a number: "Soru 2 (the sphere):". A short word of ASCII letters with its number
/// directly behind it is a name such as "t1".
std::optional<std::pair<std::string_view, Heading>> word_and_number(std::string_view line) {
    static const RE2 pattern(
        R"((^[\s*=\-_#~]*(\p{L}{1,20})(\s*)(\d{1,2})(?:[\s*=_#~]*(?:[:.)\]\-]+(?:\s|$)|\s|$)+)\s*))");
    const std::string_view start = line.substr(0, longest_heading);
    re2::StringPiece whole, word, gap;
    int number = 0;
    if (!RE2::PartialMatch(re2::StringPiece(start.data(), start.size()), pattern, &whole, &word, &gap, &number))
        return std::nullopt;
    if (const bool is_ascii = (word[0] & 0x80) == 0; gap.empty() && is_ascii) return std::nullopt;
    return std::pair(std::string_view(word.data(), word.size()),
                     Heading{number, end_of(start, whole.size()), Heading::Style::question});
}

}  // namespace

std::vector<std::optional<Heading>> counted_by_a_word(const std::vector<std::string_view>& lines, int last_question) {
    constexpr int fewest = 5;
    if (last_question < fewest) return {};
    std::map<std::string_view, int> last;  // number behind a word; 0 if its numbers do not go up
    std::vector<std::optional<std::pair<std::string_view, Heading>>> found;
    for (const std::string_view line : lines) {
        found.push_back(word_and_number(line));
        if (!found.back()) continue;
        const auto& [word, heading] = *found.back();
        const auto [known, is_new] = last.try_emplace(word, heading.question == 1 ? 1 : 0);
        const bool goes_up = heading.question == known->second || heading.question == known->second + 1;
        if (!is_new && known->second > 0) known->second = goes_up ? heading.question : 0;
    }
    const auto counting = std::ranges::find_if(last, [&](const auto& each) { return each.second == last_question; });
    if (counting == last.end()) return {};
    std::vector<std::optional<Heading>> headings(lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (found[i] && found[i]->first == counting->first) headings[i] = found[i]->second;
    }
    return headings;
}

std::vector<std::optional<Heading>> headings_in_column(const std::vector<std::string_view>& lines, int last_question) {
    if (auto column = first_column(lines, last_question); !column.empty()) return column;
    for (const ColumnForm& form : column_forms()) {
        if (auto column = question_column(form, lines, last_question); !column.empty()) return column;
    }
    return lone_numbers(lines, last_question);
}

}  // namespace harness
