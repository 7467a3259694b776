#include "harness/read/tokens/own_separators.h"

#include <algorithm>
#include <map>
#include <optional>

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
    if (text.size() > longest || text.find_first_of("<>") != std::string_view::npos) return gap;
    std::string form;
    bool indexed = false;
    for (std::size_t i = 0; i < text.size();) {
        if (text[i] == '[' && i + 2 < text.size() && is_digit(text[i + 1]) && text[i + 2] == ']' && !gap.component) {
            gap.component = text[i + 1] - '0';
            form += '#';
            indexed = true;
            i += 3;
            continue;
        }
        std::size_t end = i;
        while (end < text.size() && is_letter(text[end])) ++end;
        if (end == i) {
            const bool blank = text[i] == ' ' || text[i] == '\t';
            if (!blank || (!form.empty() && form.back() != ' ')) form += blank ? ' ' : text[i];
            ++i;
            continue;
        }
        const auto component = component_of(text.substr(i, end - i));
        if (component && !gap.component) {
            gap.component = component;
            form += '#';
        } else {
            form += text.substr(i, end - i);
        }
        i = end;
    }
    if (form.find_first_of(indexed ? "0123456789" : "=:0123456789") != std::string::npos) return gap;
    while (form.ends_with(' ')) form.pop_back();
    if (gap.component && (form.ends_with('+') || form.ends_with('-'))) {
        gap.negates = form.ends_with('-');
        form.pop_back();
        while (form.ends_with(' ')) form.pop_back();
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
        if (tokens[i].kind != Kind::number || is_bracketed_index(tokens, i)) continue;
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
    if (step < 0 && from >= 4 && is_bracketed_index(tokens, from - 3) && tokens[from - 3].number.value == component)
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

bool is_bracketed_index(const std::vector<Token>& tokens, std::size_t i) {
    return i > 0 && i + 2 < tokens.size() && tokens[i].kind == Kind::number && tokens[i - 1].kind == Kind::open &&
           tokens[i + 1].kind == Kind::close && tokens[i + 2].kind == Kind::equals;
}

OwnSeparators::OwnSeparators(const std::vector<std::string_view>& lines) {
    constexpr int fewest = 3;
    std::map<std::string, int> count;
    for (const std::string_view line : lines) {
        for (const List& list : lists_of(tokenize(line), line)) {
            const std::size_t size = list.numbers.size();
            if (size == 3 || size == 4 || size == 9 || size == 16) ++count[list.form];
        }
    }
    for (const auto& [form, lists] : count) {
        if (lists >= fewest) separators_.insert(form);
    }
}

void OwnSeparators::replace_in(std::vector<Token>& tokens, std::string_view line) const {
    if (separators_.empty()) return;
    std::vector<List> lists = lists_of(tokens, line);
    std::erase_if(lists, [&](const List& list) { return !separators_.contains(list.form); });
    if (lists.empty()) return;
    const auto text_of = [&](const Token& token) { return line.substr(token.begin, token.end - token.begin); };
    std::vector<Token> result;
    std::size_t taken = 0;  // tokens before this one are in the result
    for (const List& list : lists) {
        const bool named = list.gaps.front().component.has_value();
        const bool names_first = named && names_side(list) == 1;
        const auto last = static_cast<int>(list.numbers.size()) - 1;
        std::size_t from = list.numbers.front();
        std::size_t to = list.numbers.back() + 1;
        Token open{Kind::open, tokens[from].begin, tokens[from].begin, {}};
        Token close{Kind::close, tokens[to - 1].end, tokens[to - 1].end, {}};
        const bool angled =
            from > taken && to < tokens.size() && text_of(tokens[from - 1]) == "<" && text_of(tokens[to]) == ">";
        if (angled) {  // the lexer knows such brackets only around common separators
            open = tokens[--from];
            close = tokens[to++];
            open.kind = Kind::open;
            close.kind = Kind::close;
        }
        if (names_first) {
            if (const auto name = name_beside(tokens, line, from, -1, 0); name && *name >= taken) {
                from = *name;
                open.begin = tokens[from].begin;
            }
        } else if (named) {
            if (const auto name = name_beside(tokens, line, to - 1, 1, last)) {
                to = *name + 1;
                close.end = tokens[to - 1].end;
            }
        }
        result.insert(result.end(), tokens.begin() + static_cast<std::ptrdiff_t>(taken),
                      tokens.begin() + static_cast<std::ptrdiff_t>(from));
        if (named || angled) result.push_back(open);
        for (std::size_t i = 0; i < list.numbers.size(); ++i) {
            const Token& number = tokens[list.numbers[i]];
            if (i > 0) result.push_back({Kind::comma, tokens[list.numbers[i - 1]].end, number.begin, {}});
            result.push_back(number);
            if (i > 0 && list.gaps[i - 1].negates) result.back().number.value = -number.number.value;
        }
        if (named || angled) result.push_back(close);
        taken = to;
    }
    result.insert(result.end(), tokens.begin() + static_cast<std::ptrdiff_t>(taken), tokens.end());
    tokens = std::move(result);
}

}  // namespace harness
