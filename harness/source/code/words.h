// The words of a source that the compiler acts on, with brackets matched. Comments and text that #if 0 removes are left
// out.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "harness/source/code/cpp_lexer.h"

namespace harness::source {

/// The index that means no word.
inline constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

struct Word {
    TokenKind kind;  ///< name, number, text, symbol or other; a directive and a line_end enclose a #define
    std::string_view text;
    std::size_t begin;              ///< in the source
    std::size_t partner = nowhere;  ///< for a bracket: the index of the matching bracket, if any
    std::size_t parent = nowhere;   ///< the index of the innermost opening bracket around it
    bool in_define = false;
    /// False between #if and #endif if the source alone does not decide the condition.
    bool certain = true;
};

/// The words in the source's order. A #define consists of '#', its name, its words and a line_end; all other directives
/// are left out. Brackets match within the same #define or outside of every #define. The words refer to `source`.
std::vector<Word> words_of(std::string_view source);

bool is_name(const Word& word);
bool is_any_of(std::string_view text, std::initializer_list<std::string_view> list);
/// Whether the word at `at` exists and is this symbol.
bool is_symbol(const std::vector<Word>& words, std::size_t at, std::string_view text);

}  // namespace harness::source
