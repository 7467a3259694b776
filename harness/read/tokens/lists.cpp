#include "harness/read/tokens/lists.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace harness {
namespace {

using Kind = Token::Kind;

/// What stands between two numbers.
struct Gap {
    std::string form;              ///< its text, with '#' for a component's name; empty if it separates no list
    std::optional<int> component;  ///< the name in it: 0 to 3 for x, y, z, w, or 0 to 2 for i, j, k
    bool negates = false;          ///< it ends with the minus sign of the next number
};

std::optional<int> component_of(std::string_view word) {
    if (word.size() != 1) return std::nullopt;
    for (const std::string_view names : {"xyzw", "ijk"}) {
        if (const std::size_t at = names.find(static_cast<char>(word[0] | 0x20)); at != std::string_view::npos)
            return static_cast<int>(at);
    }
    return std::nullopt;
}

Gap gap_of(std::string_view text) {
    constexpr std::size_t longest = 40;
    Gap gap;
    std::string form;
    bool is_indexed = false;
    if (text.size() > longest || text.find_first_of("<>") != std::string_view::npos) return gap;
    for (std::size_t i = 0; i < text.size();) {
        if (text[i] == '[' && i + 2 < text.size() && is_digit(text[i + 1]) && text[i + 2] == ']' && !gap.component) {
            gap.component = text[i + 1] - '0';
            form += '#';
            is_indexed = true;
            i += 3;
            continue;
        }
        std::size_t end = i;
        while (end < text.size() && is_letter(text[end])) ++end;
        const std::string_view word = text.substr(i, end - i);
        const auto component = gap.component ? std::nullopt : component_of(word);
        if (component) gap.component = component;
        const bool is_blank = text[i] == ' ' || text[i] == '\t';
        if (component) {
            form += '#';
        } else if (!word.empty()) {
            form += word;
        } else if (!is_blank) {
            form += text[i];
        } else if (!form.empty() && form.back() != ' ') {
            form += ' ';
        }
        i = std::max(end, i + 1);
    }
    if (form.find_first_of(is_indexed ? "0123456789" : "=:0123456789") != std::string::npos) return gap;
    const auto trim = [&] { form.erase(form.find_last_not_of(' ') + 1); };
    trim();
    if (gap.component && (form.ends_with('+') || form.ends_with('-'))) {
        gap.negates = form.ends_with('-');
        form.pop_back();
        trim();
    }
    const bool is_arithmetic = !gap.component && form.find_first_of("+-*^") != std::string::npos;
    const bool is_common = form.find_first_not_of(" ,;|()[]{}") == std::string::npos;
    if (!is_arithmetic && !is_common) gap.form = form;
    return gap;
}

/// Numbers of a line with the same separator between them.
struct List {
    std::string form;
    std::vector<std::size_t> numbers;  ///< indices of tokens
    std::vector<Gap> gaps;
};

/// Whether the names in the gaps belong to the numbers before them (0), to those after them (1), or are no names of a
/// vector's components.
std::optional<int> names_side(const List& list) {
    for (const int side : {0, 1}) {
        bool all = true;
        for (std::size_t i = 0; i < list.gaps.size(); ++i)
            all = all && list.gaps[i].component == static_cast<int>(i) + side;
        if (all) return side;
    }
    return std::nullopt;
}

std::vector<List> lists_of(const std::vector<Token>& tokens, std::string_view line) {
    std::vector<List> lists;
    std::optional<std::size_t> before;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (tokens[i].kind != Kind::number || tokens[i].number.index == 0) continue;
        if (before) {
            Gap gap = gap_of(line.substr(tokens[*before].end, tokens[i].begin - tokens[*before].end));
            const bool goes_on =
                !lists.empty() && lists.back().numbers.back() == *before && lists.back().form == gap.form;
            if (!gap.form.empty() && !goes_on) lists.push_back({gap.form, {*before}, {}});
            if (!gap.form.empty()) {
                lists.back().numbers.push_back(i);
                lists.back().gaps.push_back(std::move(gap));
            }
        }
        before = i;
    }
    std::erase_if(lists, [](const List& list) {
        return list.numbers.size() < 3 || (list.gaps.front().component && !names_side(list));
    });
    return lists;
}

/// Index of the token with the name of the component, at most two tokens from `from` in steps of `step`; the bracket of
/// "[0] =".
std::optional<std::size_t> name_beside(const std::vector<Token>& tokens, std::string_view line, std::size_t from,
                                       int step, int component) {
    if (step < 0 && from >= 4 && tokens[from - 3].kind == Kind::number && tokens[from - 3].number.index == 0 &&
        tokens[from - 3].number.value == component)
        return from - 4;
    for (int distance = 1; distance <= 2; ++distance) {
        const std::size_t at = from + static_cast<std::size_t>(step * distance);
        if (at >= tokens.size()) return std::nullopt;
        const std::string_view text = line.substr(tokens[at].begin, tokens[at].end - tokens[at].begin);
        if (tokens[at].kind == Kind::word && component_of(text) == component) return at;
    }
    return std::nullopt;
}

}  // namespace

void join_lists(std::vector<Token>& tokens, std::string_view line) {
    const std::vector<List> lists = lists_of(tokens, line);
    if (lists.empty()) return;
    std::vector<Token> result;
    std::size_t taken = 0;  // tokens before this one are in the result
    for (const List& list : lists) {
        if (list.numbers.front() < taken) continue;  // it begins with the last number of the list before
        const bool is_named = list.gaps.front().component.has_value();
        std::size_t from = list.numbers.front(), to = list.numbers.back() + 1;
        if (is_named && names_side(list) == 1) {
            if (const auto name = name_beside(tokens, line, from, -1, 0); name && *name >= taken) from = *name;
        } else if (is_named) {
            const auto last = static_cast<int>(list.numbers.size()) - 1;
            if (const auto name = name_beside(tokens, line, to - 1, 1, last)) to = *name + 1;
        }
        result.insert(result.end(), tokens.begin() + static_cast<std::ptrdiff_t>(taken),
                      tokens.begin() + static_cast<std::ptrdiff_t>(from));
        if (is_named) result.push_back({Kind::open, tokens[from].begin, tokens[from].begin, {}});
        for (std::size_t i = 0; i < list.numbers.size(); ++i) {
            const Token& number = tokens[list.numbers[i]];
            if (i > 0) result.push_back({Kind::comma, tokens[list.numbers[i - 1]].end, number.begin, {}});
            result.push_back(number);
            if (i > 0 && list.gaps[i - 1].negates) result.back().number.value = -number.number.value;
        }
        if (is_named) result.push_back({Kind::close, tokens[to - 1].end, tokens[to - 1].end, {}});
        taken = to;
    }
    result.insert(result.end(), tokens.begin() + static_cast<std::ptrdiff_t>(taken), tokens.end());
    tokens = std::move(result);
}

}  // namespace harness
