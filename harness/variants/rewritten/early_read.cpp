#include "harness/variants/rewritten/early_read.h"

#include <algorithm>
#include <vector>

#include "harness/source/code/words.h"

namespace harness::variants {
namespace {

using Words = std::vector<source::Word>;

/// For each word, whether it is in a function's body: in braces after parameters.
std::vector<bool> in_functions(const Words& words) {
    std::vector<bool> inside(words.size()), is_body(words.size());
    for (std::size_t at = 1; at < words.size(); ++at) {
        const std::size_t parent = words[at].parent;
        inside[at] = parent != source::nowhere && (inside[parent] || is_body[parent]);
        is_body[at] = words[at].text == "{" && source::is_any_of(words[at - 1].text, {")", "const", "noexcept"});
    }
    return inside;
}

/// Whether the brackets at `open` may contain parameters, "(vec3 S, float)": no numbers, as in "(0, 0, 4)", and no
/// calls.
bool may_hold_parameters(const Words& words, std::size_t open) {
    constexpr std::size_t longest = 200;
    const std::size_t end = std::min(words[open].partner, open + longest);
    for (std::size_t at = open + 1; at < end; ++at) {
        if (words[at].kind == source::TokenKind::number || words[at].text == "(") return false;
    }
    return true;
}

/// Whether the bracket at `open` may belong to a function that is declared without its body.
bool may_declare_function(const Words& words, std::size_t open) {
    const source::Word& bracket = words[open];
    if (bracket.text != "(" || bracket.partner == source::nowhere || open == 0 || !is_name(words[open - 1]))
        return false;
    if (bracket.parent != source::nowhere && words[bracket.parent].text == "(") return false;
    std::size_t behind = bracket.partner + 1;  // of "const", "noexcept", "-> float"
    while (behind < words.size() && (is_name(words[behind]) || words[behind].text == "->")) ++behind;
    const bool has_body = behind < words.size() && source::is_any_of(words[behind].text, {"{", ":", "="});
    return !has_body && may_hold_parameters(words, open);
}

/// Whether something outside of all functions may be declared before it is defined: a function, "extern float x;", or a
/// class's static member.
bool may_declare_ahead(const Words& words, const std::vector<bool>& inside) {
    bool is_initializer = false;
    for (std::size_t at = 0; at < words.size(); ++at) {
        const source::Word& word = words[at];
        if (inside[at] || word.in_define) continue;
        if (source::is_any_of(word.text, {";", "{", "}"})) is_initializer = false;
        if (word.text == "=") is_initializer = true;
        if (word.text == "extern" && at + 1 < words.size() && words[at + 1].kind != source::TokenKind::text)
            return true;
        if (word.text == "static" && word.parent != source::nowhere) return true;
        if (!is_initializer && may_declare_function(words, at)) return true;
    }
    return false;
}

}  // namespace

bool may_be_read_early(std::string_view source, const source::SceneLiterals& found) {
    const Words words = source::words_of(source);
    const std::vector<bool> inside = in_functions(words);
    const auto is_early = [&](const source::SceneLiteral& literal) {
        if (literal.constant.value != 0) return false;
        const auto word = std::ranges::lower_bound(words, literal.begin, {}, &source::Word::begin);
        return literal.in_define || word == words.end() || !inside[static_cast<std::size_t>(word - words.begin())];
    };
    return std::ranges::any_of(found.literals, is_early) && may_declare_ahead(words, inside);
}

}  // namespace harness::variants
