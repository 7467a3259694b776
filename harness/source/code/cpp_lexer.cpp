// Each function that reads a token moves past it and never goes back, so the time is linear.
#include "harness/source/code/cpp_lexer.h"

#include <algorithm>
#include <array>
#include <string>

namespace harness::source {
namespace {

constexpr std::array<std::string_view, 25> long_symbols{"<<=", ">>=", "<=>", "->*", "...", "::", "->", "++", "--",
                                                        "+=",  "-=",  "*=",  "/=",  "%=",  "&=", "|=", "^=", "==",
                                                        "!=",  "<=",  ">=",  "&&",  "||",  "<<", ">>"};
constexpr std::string_view short_symbols = "{}[]()<>;:,.?~!+-*/%^&|=";

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// g++ accepts characters with bytes from 0x80 on in names.
bool begins_name(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '$' ||
           static_cast<unsigned char>(c) >= 0x80;
}

bool continues_name(char c) {
    return begins_name(c) || is_digit(c);
}

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\f' || c == '\v';
}

class Lexer {
  public:
    explicit Lexer(std::string_view source) : source_(source) {}

    std::vector<Token> lex() {
        while (at_ < source_.size()) {
            const std::size_t begin = at_;
            const TokenKind kind = next();
            tokens_.push_back({kind, begin, at_});
            note_line(kind, source_.substr(begin, at_ - begin));
        }
        return std::move(tokens_);
    }

  private:
    /// The place of a token in its line. It determines the meaning of '#' and '<'.
    enum class Line { begun, directive, include, other };

    char peek(std::size_t ahead = 0) const { return at_ + ahead < source_.size() ? source_[at_ + ahead] : '\0'; }
    bool has(std::size_t ahead = 0) const { return at_ + ahead < source_.size(); }

    void note_line(TokenKind kind, std::string_view text) {
        switch (kind) {
            case TokenKind::line_end: line_ = Line::begun; break;
            case TokenKind::blank:
            case TokenKind::comment: break;
            case TokenKind::directive: line_ = Line::directive; break;
            case TokenKind::name:
                line_ = line_ == Line::directive && text == "include" ? Line::include : Line::other;
                break;
            case TokenKind::number:
            case TokenKind::text:
            case TokenKind::header_name:
            case TokenKind::symbol:
            case TokenKind::other: line_ = Line::other; break;
        }
    }

    /// The length of the line end at this place; 0 if there is none.
    std::size_t line_end_length(std::size_t at) const {
        if (at >= source_.size()) return 0;
        if (source_[at] == '\n') return 1;
        if (source_[at] != '\r') return 0;
        return at + 1 < source_.size() && source_[at + 1] == '\n' ? 2 : 1;
    }

    /// Moves past a backslash that joins its line to the next line; g++ allows blanks after the backslash.
    bool skip_splice() {
        if (peek() != '\\') return false;
        std::size_t at = at_ + 1;
        while (at < source_.size() && is_blank(source_[at])) ++at;
        const std::size_t length = line_end_length(at);
        if (length == 0) return false;
        at_ = at + length;
        return true;
    }

    TokenKind next() {
        const char c = peek();
        if (const std::size_t length = line_end_length(at_); length > 0) {
            at_ += length;
            return TokenKind::line_end;
        }
        if (is_blank(c) || c == '\\') return blank_or_other();
        if (c == '/' && peek(1) == '/') return line_comment();
        if (c == '/' && peek(1) == '*') return block_comment();
        if (begins_name(c)) return name_or_text();
        if (is_digit(c) || (c == '.' && is_digit(peek(1)))) return number();
        if (c == '"' || c == '\'') return quoted(c);
        if (c == '#' && line_ == Line::begun) {
            ++at_;
            return TokenKind::directive;
        }
        if (c == '<' && line_ == Line::include) return header_name();
        return symbol();
    }

    TokenKind blank_or_other() {
        const std::size_t begin = at_;
        while (is_blank(peek()) || skip_splice()) {
            if (is_blank(peek())) ++at_;
        }
        if (at_ > begin) return TokenKind::blank;
        ++at_;
        return TokenKind::other;
    }

    TokenKind line_comment() {
        while (has() && line_end_length(at_) == 0) {
            if (!skip_splice()) ++at_;
        }
        return TokenKind::comment;
    }

    TokenKind block_comment() {
        const std::size_t end = source_.find("*/", at_ + 2);
        at_ = end == std::string_view::npos ? source_.size() : end + 2;
        return TokenKind::comment;
    }

    TokenKind name_or_text() {
        const std::size_t begin = at_;
        skip_name();
        const std::string_view name = source_.substr(begin, at_ - begin);
        const char quote = peek();
        if (quote != '"' && quote != '\'') return TokenKind::name;
        if (quote == '"' && !name.empty() && name.back() == 'R' && is_prefix(name.substr(0, name.size() - 1))) {
            if (skip_raw_string()) return TokenKind::text;
        }
        return !name.empty() && is_prefix(name) ? quoted(quote) : TokenKind::name;
    }

    static bool is_prefix(std::string_view name) {
        return name.empty() || name == "u8" || name == "u" || name == "U" || name == "L";
    }

    void skip_name() {
        while (has() && (continues_name(peek()) || skip_splice())) {
            if (continues_name(peek())) ++at_;
        }
    }

    /// Skips R"delimiter( ... )delimiter". Returns false and skips nothing if this is not a raw string.
    bool skip_raw_string() {
        constexpr std::size_t longest = 16;
        std::size_t open = at_ + 1;
        while (open < source_.size() && open - at_ - 1 <= longest && source_[open] != '(') {
            if (is_blank(source_[open]) || source_[open] == ')' || source_[open] == '\\' || source_[open] == '"' ||
                line_end_length(open) > 0) {
                return false;
            }
            ++open;
        }
        if (open >= source_.size() || source_[open] != '(') return false;
        std::string closing(1, ')');
        closing.append(source_.substr(at_ + 1, open - at_ - 1)).append(1, '"');
        const std::size_t end = source_.find(closing, open + 1);
        at_ = end == std::string_view::npos ? source_.size() : end + closing.size();
        return true;
    }

    TokenKind quoted(char quote) {
        ++at_;
        while (has() && line_end_length(at_) == 0) {
            if (skip_splice()) continue;
            const char c = peek();
            at_ += c == '\\' && has(1) && line_end_length(at_ + 1) == 0 ? 2 : 1;
            if (c == quote) break;
        }
        return TokenKind::text;
    }

    TokenKind number() {
        char before = '\0';
        while (has()) {
            const char c = peek();
            const bool sign_of_exponent =
                (c == '+' || c == '-') && (before == 'e' || before == 'E' || before == 'p' || before == 'P');
            const bool separator = c == '\'' && has(1) && continues_name(peek(1));
            if (continues_name(c) || c == '.' || sign_of_exponent || separator) {
                before = c;
                ++at_;
            } else if (!skip_splice()) {
                break;
            }
        }
        return TokenKind::number;
    }

    TokenKind header_name() {
        const std::size_t end = source_.find_first_of(">\r\n", at_);
        if (end == std::string_view::npos || source_[end] != '>') return symbol();
        at_ = end + 1;
        return TokenKind::header_name;
    }

    TokenKind symbol() {
        const std::string_view rest = source_.substr(at_, 3);
        for (const std::string_view symbol : long_symbols) {
            if (!rest.starts_with(symbol)) continue;
            at_ += symbol.size();
            return TokenKind::symbol;
        }
        const bool known = short_symbols.find(peek()) != std::string_view::npos && peek() != '\0';
        ++at_;
        return known ? TokenKind::symbol : TokenKind::other;
    }

    std::string_view source_;
    std::size_t at_ = 0;
    Line line_ = Line::begun;
    std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> lex_cpp(std::string_view source) {
    return Lexer(source).lex();
}

}  // namespace harness::source
