// A C++ source as tokens: as much of the language as it takes to know which numbers are code and where they stand.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace harness::variants {

enum class TokenKind {
    blank,        ///< white space and spliced line ends, but not a line's own end
    line_end,     ///< "\n", "\r\n" or "\r"
    comment,      ///< without its line's end
    name,         ///< identifier or keyword
    number,       ///< as the preprocessor takes it (a pp-number), with digit separators and suffix
    text,         ///< string, raw string or character literal with its prefix
    header_name,  ///< <...> behind #include
    directive,    ///< the '#' that begins a preprocessor line
    symbol,       ///< operator or punctuation, the longest that fits
    other,        ///< a byte that is none of these
};

struct Token {
    TokenKind kind;
    std::size_t begin;
    std::size_t end;  ///< above begin
};

/// Any bytes, in linear time: the tokens follow each other without a gap from 0 to the source's end. What a literal or
/// comment lacks at its end is taken to end with its line, or with the source where it may go over lines.
std::vector<Token> lex_cpp(std::string_view source);

}  // namespace harness::variants
