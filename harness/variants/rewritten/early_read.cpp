#include "harness/variants/rewritten/early_read.h"

#include <re2/re2.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <vector>

#include "harness/source/code/words.h"

namespace harness::variants {
namespace {

/// The first word of the declaration or statement that the word at `at` belongs to; of a very long one some word of it.
std::size_t begin_of_statement(const std::vector<source::Word>& words, std::size_t at) {
    constexpr int most_steps = 200;
    for (int step = 0; at > 0 && step < most_steps; ++step) {
        const source::Word& before = words[at - 1];
        if (source::is_any_of(before.text, {";", "{"}) || before.kind == source::TokenKind::line_end) return at;
        if (before.text == "}" && before.partner != source::nowhere && words[before.partner].parent == words[at].parent)
            return at;
        at -= 1;
        if (source::is_any_of(before.text, {")", "]"}) && before.partner != source::nowhere) at = before.partner;
    }
    return at;
}

/// Whether the bracket at `open` holds a function's statements, and not a class, a namespace or a list.
bool is_body_of_function(const std::vector<source::Word>& words, std::size_t open) {
    if (words[open].text != "{") return false;
    bool has_parameters = false;
    for (std::size_t at = begin_of_statement(words, open); at < open; ++at) {
        if (source::is_any_of(words[at].text, {"struct", "class", "union", "enum", "namespace", "="})) return false;
        has_parameters = has_parameters || words[at].text == "(";
    }
    return has_parameters;
}

/// For each word, whether it stands in a function's body.
std::vector<bool> in_functions(const std::vector<source::Word>& words) {
    std::vector<bool> inside(words.size()), is_body(words.size());
    for (std::size_t at = 0; at < words.size(); ++at) {
        const std::size_t parent = words[at].parent;
        inside[at] = parent != source::nowhere && (inside[parent] || is_body[parent]);
        is_body[at] = !inside[at] && is_body_of_function(words, at);
    }
    return inside;
}

using Types = std::set<std::string_view>;

/// The types that the source defines.
Types types_of(const std::vector<source::Word>& words) {
    Types types;
    for (std::size_t at = 1; at < words.size(); ++at) {
        if (source::is_any_of(words[at - 1].text, {"struct", "class", "union", "enum"})) types.insert(words[at].text);
    }
    return types;
}

/// Whether the word names a type, as far as that can be told without its headers.
bool is_type(const Types& types, const source::Word& word) {
    static const RE2 common(
        "(?:float|double|int|unsigned|bool|char|auto|void|string|size_t|[dui]?(?:vec|mat)[234]|quat)");
    return types.contains(word.text) || RE2::FullMatch(re2::StringPiece(word.text.data(), word.text.size()), common);
}

/// Whether the bracket at `open` holds parameters, "(vec3 S, float)", and not what a variable begins with, "(1, x, 3)".
bool holds_parameters(const std::vector<source::Word>& words, const Types& types, std::size_t open) {
    const std::size_t close = words[open].partner;
    if (close == source::nowhere || close == open + 1) return true;
    constexpr std::size_t longest = 200;
    for (std::size_t at = open + 1; at < std::min(close, open + longest); ++at) {
        const bool is_named =
            is_name(words[at]) && (is_name(words[at + 1]) || source::is_any_of(words[at + 1].text, {"&", "*"}));
        if (is_named || (is_name(words[at]) && words[at + 1].text != "(" && is_type(types, words[at]))) return true;
    }
    return false;
}

/// Whether the word at `at`, outside of all functions, declares what is defined further below: a function without its
/// body, "extern float x;", or a class's static member.
bool declares_ahead(const std::vector<source::Word>& words, const Types& types, std::size_t at) {
    const source::Word& word = words[at];
    if (word.text == "extern") return at + 1 < words.size() && words[at + 1].kind != source::TokenKind::text;
    if (word.text == "static") return word.parent != source::nowhere;
    if (word.text != "(" || word.partner == source::nowhere || at == 0 || !is_name(words[at - 1])) return false;
    if (word.parent != source::nowhere && words[word.parent].text == "(") return false;
    for (std::size_t before = begin_of_statement(words, at); before < at; ++before) {
        if (words[before].text == "=") return false;
    }
    std::size_t behind = word.partner + 1;  // of "const", "noexcept", "-> float"
    while (behind < words.size() && (is_name(words[behind]) || words[behind].text == "->")) ++behind;
    const bool has_body = behind < words.size() && source::is_any_of(words[behind].text, {"{", ":", "="});
    return !has_body && holds_parameters(words, types, at);
}

}  // namespace

bool may_be_read_early(std::string_view source, const source::SceneLiterals& found) {
    const std::vector<source::Word> words = source::words_of(source);
    const std::vector<bool> inside = in_functions(words);
    const auto is_early = [&](const source::SceneLiteral& literal) {
        if (literal.constant.value != 0) return false;
        const auto word = std::ranges::lower_bound(words, literal.begin, {}, &source::Word::begin);
        return literal.in_define || word == words.end() || !inside[static_cast<std::size_t>(word - words.begin())];
    };
    if (std::ranges::none_of(found.literals, is_early)) return false;
    const Types types = types_of(words);
    for (std::size_t at = 0; at < words.size(); ++at) {
        if (!inside[at] && !words[at].in_define && declares_ahead(words, types, at)) return true;
    }
    return false;
}

}  // namespace harness::variants
