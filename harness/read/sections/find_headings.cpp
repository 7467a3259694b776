#include "harness/read/sections/find_headings.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>

#include "harness/read/sections/counted_headings.h"

namespace harness {
namespace {

/// Of numbers alone, in brackets and without, those that name fewer questions are something else: "[1]: 0 4 0" below
/// "3)" is a row.
void keep_one_dress(std::vector<std::optional<Heading>>& headings, const std::vector<std::string_view>& lines) {
    std::array<std::set<int>, 2> named;
    const auto is_in_brackets = [&](std::size_t i) {
        return lines[i][std::min(lines[i].find_first_not_of(" \t"), lines[i].size() - 1)] == '[' ? 1U : 0U;
    };
    const auto is_bare = [&](std::size_t i) { return headings[i] && headings[i]->style == Heading::Style::bare; };
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (is_bare(i)) named.at(is_in_brackets(i)).insert(headings[i]->question);
    }
    const std::size_t fewer = named[0].size() < named[1].size() ? 0 : 1;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (is_bare(i) && is_in_brackets(i) == fewer) headings[i].reset();
    }
}

/// By style, the questions that its headings name.
using Named = std::array<std::set<int>, 4>;

std::size_t index_of(Heading::Style style) {
    return static_cast<std::size_t>(style);
}

Named named_by(const std::vector<std::optional<Heading>>& headings, int last_question) {
    Named named;
    for (const auto& heading : headings) {
        if (heading && heading->question <= last_question) named.at(index_of(heading->style)).insert(heading->question);
    }
    return named;
}

/// Chooses the style of the headings. The later styles also number steps within questions, so they must name many more
/// questions to be chosen.
std::size_t choose_style(const Named& named) {
    constexpr std::size_t fewest_bare = 3;
    const std::size_t questions = named[0].size();
    const std::size_t parts = named[1].size();
    const std::size_t bare_numbers = named[2].size() < fewest_bare ? 0 : named[2].size();
    const std::size_t others = std::max(parts, bare_numbers);
    if (questions == 0 && others == 0 && named[3].size() >= fewest_bare) return 3;
    if (questions > 0 && (others < 5 || 3 * questions >= others)) return 0;
    return parts > 0 && 2 * parts >= bare_numbers ? 1 : bare_numbers > 0 ? 2 : 0;
}

/// Leaves the headings of the style `best`, and those of numbers for questions that it leaves out, in their place:
/// "2.1 X" and "2.2 Y" between "Question 1" and "Question 3", or "1. P" and "3. M".
void keep_style(std::size_t best, std::vector<std::optional<Heading>>& headings, const Named& named,
                int last_question) {
    constexpr std::size_t fewest = 3;
    const bool may_mix = named[best].size() >= fewest &&
                         (best == index_of(Heading::Style::question) || best == index_of(Heading::Style::bare));
    int last = 0;
    for (auto& heading : headings) {
        if (!heading) continue;
        const bool is_number = heading->style == Heading::Style::bare || heading->style == Heading::Style::dotted;
        const bool is_left_out = may_mix && is_number && !named[best].contains(heading->question) &&
                                 (heading->question == last || heading->question == last + 1);
        if (index_of(heading->style) == best || (is_left_out && heading->question <= last_question)) {
            last = heading->question;
        } else {
            heading.reset();
        }
    }
}

}  // namespace

std::vector<std::optional<Heading>> find_headings(const std::vector<std::string_view>& lines, int last_question) {
    std::vector<std::optional<Heading>> headings;
    headings.reserve(lines.size());
    for (const std::string_view line : lines) headings.push_back(read_heading(line, last_question));
    const Named named = named_by(headings, last_question);
    if (named[0].size() < 3 && named[1].size() < 3) {
        if (auto counted = counted_by_a_word(lines, last_question); !counted.empty()) return counted;
    }
    if (named[0].size() < 3) {
        if (auto column = headings_in_column(lines, last_question); !column.empty()) return column;
    }
    keep_one_dress(headings, lines);
    keep_style(choose_style(named), headings, named, last_question);
    return headings;
}

}  // namespace harness
