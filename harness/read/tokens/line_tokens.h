// The tokens of one line of output, with matched brackets.
#pragma once

#include <string_view>
#include <vector>

#include "harness/read/tokens/token.h"

namespace harness {

/// A 4 x 4 matrix has 16 numbers in brackets two deep. A bracket beyond these limits is not read as a value, which
/// keeps reading linear in the line's length.
constexpr std::size_t deepest_bracket = 4;
constexpr std::size_t most_tokens_in_bracket = 128;

class LineTokens {
  public:
    /// `line` must outlive this object.
    explicit LineTokens(std::string_view line);

    std::size_t size() const { return tokens_.size(); }
    const Token& operator[](std::size_t i) const { return tokens_[i]; }
    /// Whether token i exists and has this kind.
    bool is(std::size_t i, Token::Kind kind) const { return i < tokens_.size() && tokens_[i].kind == kind; }
    std::string_view text(std::size_t i) const {
        return line_.substr(tokens_[i].begin, tokens_[i].end - tokens_[i].begin);
    }
    /// The index of the bracket that closes token i; size() if there is none, for any i.
    std::size_t partner(std::size_t i) const { return i < size() ? partner_[i] : size(); }
    /// Whether token i is a type name such as "glm::vec3" or "dmat4" before a bracket: "mat3(vec3(…), vec3(…))".
    bool is_type(std::size_t i) const;
    /// Whether token i is a type name. A word that is also a label, such as "matrix", is a type name only directly
    /// before its bracket: "Matrix([1, 0, 0], …)".
    bool is_type_word(std::size_t i) const;
    /// Whether bracket i encloses a function's arguments: "sqrt(2)", "dot(V, V)".
    bool is_call(std::size_t i) const;
    /// Whether bracket i is the index of a matrix's row or column, as in "M(1,:) = 1 0 0 4" and in the line "[0]
    /// vec4(1, 0, 0, 0)".
    bool is_index_of_row(std::size_t i) const;

  private:
    std::string_view line_;
    std::vector<Token> tokens_;
    std::vector<std::size_t> partner_;
};

}  // namespace harness
