// The words of a source that the compiler acts on, with brackets matched: no comments, no text that #if 0 takes out.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "harness/variants/cpp_lexer.h"

namespace harness::variants {

/// No word.
inline constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

struct Word {
    TokenKind kind;  ///< name, number, text, symbol or other; directive and line_end around what a #define holds
    std::string_view text;
    std::size_t begin;              ///< in the source
    std::size_t partner = nowhere;  ///< of a bracket ( [ { or its end: the other one, where there is one
    std::size_t parent = nowhere;   ///< the bracket that opens the innermost pair around it
    bool in_define = false;
    /// False between #if and #endif where the condition can't be told from the source alone.
    bool certain = true;
};

/// In the source's order. A #define is '#', its name, its words and a line_end; every other directive is left out.
/// Brackets match within a #define or within what is none. The words refer to `source`.
std::vector<Word> words_of(std::string_view source);

bool is_name(const Word& word);
/// Whether there is a word at `at`, this symbol.
bool is_symbol(const std::vector<Word>& words, std::size_t at, std::string_view text);

}  // namespace harness::variants
