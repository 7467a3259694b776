#include "harness/source/code/source_names.h"

namespace harness::source {
namespace {

/// Whether the word can precede a bracket or a name without being its type.
bool is_keyword(std::string_view name) {
    for (const std::string_view keyword :
         {"return", "new", "throw", "else", "case", "if", "while", "for", "switch", "sizeof"}) {
        if (name == keyword) return true;
    }
    return false;
}

}  // namespace

SourceNames::SourceNames(const std::vector<Word>& words) : words_(words), is_block_(words.size(), false) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (is(i, ";") && words[i].parent != nowhere) is_block_[words[i].parent] = true;
    }
}

/// The place before an index such as [3] that ends at `at`; `at` itself if there is no index.
std::size_t SourceNames::before_index(std::size_t at) const {
    while (at != nowhere && at < words_.size() && is(at, "]") && words_[at].partner != nowhere &&
           words_[at].partner > 0)
        at = words_[at].partner - 1;
    return at;
}

std::string SourceNames::left_of(std::size_t equals) const {
    if (equals == 0) return {};
    const std::size_t at = before_index(equals - 1);
    if (at >= words_.size() || !is_name(words_[at])) return {};
    std::string name(words_[at].text);
    if (at >= 2 && (is(at - 1, ".") || is(at - 1, "->")) && is_name(words_[at - 2]))
        name = std::string(words_[at - 2].text) + "." + name;
    if (at + 4 == equals && words_[at + 2].kind == TokenKind::number)
        name += "[" + std::string(words_[at + 2].text) + "]";
    return name;
}

/// Whether the name at `at`, which precedes a bracket, is declared there: after its type, in a list of declarations or
/// in a constructor's member initialisers.
bool SourceNames::is_declared(std::size_t at) const {
    if (at == 0) return false;
    const Word& before = words_[at - 1];
    if (is_name(before)) return !is_keyword(before.text);
    for (const std::string_view symbol : {">", "&", "*"}) {
        if (is(at - 1, symbol)) return true;
    }
    const bool in_block = words_[at].parent == nowhere || is_block_[words_[at].parent];
    return (is(at - 1, ",") || is(at - 1, ":")) && in_block;
}

Naming SourceNames::of_list(std::size_t open) const {
    Naming result;
    if (open == 0) return result;
    std::size_t at = before_index(open - 1);
    if (at >= words_.size()) return result;
    if (is_name(words_[at])) {
        if (at == open - 1) result.callee = words_[at].text;
        std::size_t first = at;
        while (first >= 2 && is(first - 1, "::") && is_name(words_[first - 2])) first -= 2;
        if (first > 0 && is(first - 1, "=")) {
            result.name = left_of(first - 1);
        } else if (first > 0 && words_[first - 1].kind == TokenKind::name && first >= 2 &&
                   words_[first - 2].kind == TokenKind::directive) {
            result.name = {};
        } else if (is_declared(first)) {
            result.name = words_[at].text;
        }
    } else if (is(at, "=")) {
        result.name = left_of(at);
    } else if (is(at, "{") || is(at, "(")) {
        // eye{{0, 0, 4}} and eye({0, 0, 4}) mean the same as a single pair of brackets.
        if (words_[at].partner == words_[open].partner + 1) return one_bracket_further_out(at);
    }
    return result;
}

/// Like of_list, for the next bracket outward; goes no further.
Naming SourceNames::one_bracket_further_out(std::size_t open) const {
    if (open == 0) return {};
    const std::size_t at = before_index(open - 1);
    if (at >= words_.size()) return {};
    if (is(at, "=")) return {left_of(at), {}};
    if (is_name(words_[at]) && is_declared(at)) return {std::string(words_[at].text), {}};
    return {};
}

std::map<std::string, std::vector<std::size_t>, std::less<>> SourceNames::settings() const {
    std::map<std::string, std::vector<std::size_t>, std::less<>> settings;
    for (std::size_t i = 0; i < words_.size(); ++i) {
        if (words_[i].kind != TokenKind::symbol || words_[i].in_define) continue;
        std::string name;
        if (is_any_of(words_[i].text, {"=", "+=", "-=", "*=", "/="})) {
            name = left_of(i);
        } else if ((is(i, "(") || is(i, "{")) && words_[i].partner != nowhere && !is_block(i)) {
            name = of_list(i).name;
        }
        if (!name.empty()) settings[name.substr(0, name.find_first_of(".["))].push_back(i);
    }
    return settings;
}

}  // namespace harness::source
