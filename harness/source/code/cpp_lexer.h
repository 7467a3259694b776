// Splits a C++ source into tokens, with just enough of the language to know which numbers are code and where they are.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace harness::source {

enum class TokenKind {
    blank,        ///< white space and spliced line ends, but not a line's own end
    line_end,     ///< "\n", "\r\n" or "\r"
    comment,      ///< without the line's end
    name,         ///< identifier or keyword
    number,       ///< a preprocessing number (pp-number), with digit separators and suffix
    text,         ///< string, raw string or character literal with its prefix
    header_name,  ///< <...> after #include
    directive,    ///< the '#' that begins a preprocessor line
    symbol,       ///< operator or punctuation, the longest that fits
    other,        ///< any other byte
};

struct Token {
    TokenKind kind;
    std::size_t begin;
    std::size_t end;  ///< greater than begin
};

/// Accepts any bytes and takes linear time. The tokens cover the source without gaps. An unterminated literal or
/// comment ends with its line, or with the source if it may span lines.
std::vector<Token> lex_cpp(std::string_view source);

}  // namespace harness::source
