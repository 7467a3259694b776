#include "harness/read/tokens/expression.h"

#include "harness/read/tokens/number_group.h"

namespace harness {
namespace {

using Kind = Token::Kind;

class ExpressionReader {
  public:
    ExpressionReader(const LineTokens& tokens, std::size_t begin) : tokens_(tokens), begin_(begin) {}

    std::optional<std::size_t> end() const {
        std::size_t last = begin_;  // where the last operand begins
        std::size_t i = operand_end(last);
        if (i == last || i - begin_ > most_tokens_in_bracket) return std::nullopt;
        const bool is_product = is_coefficient(begin_);
        if (is_product) {
            last = i;
            const std::size_t behind_dot_product = dot_product_end(last);
            i = behind_dot_product != last ? behind_dot_product : operand_end(last);
            // "t = 2 P_s = (0, 0, 1)"
            if (behind_dot_product == last && !tokens_.is_call(last + 1) && !is_multiplication(i) &&
                !is_factor(last, i))
                return std::nullopt;
        }
        const bool multiplies_brackets = is(last, Kind::open) && multiplies(last, i);  // "(0)(0) + (1)(2)"
        if (!is_product && !is_operator(i) && !multiplies_brackets)
            return is_bracket_of_operators() ? std::optional(i) : std::nullopt;
        while (is_operator(i) || multiplies(last, i)) {
            const bool follows_operator = is_operator(i);
            last = follows_operator ? i + 1 : i;
            i = follows_operator && is(last, Kind::bar) ? length_end(last) : operand_end(last);
            if (i == last || i - begin_ > most_tokens_in_bracket) return std::nullopt;
        }
        return may_be_label(last, i) ? std::nullopt : std::optional(i);
    }

  private:
    bool is(std::size_t i, Kind kind) const { return tokens_.is(i, kind); }
    std::string_view text(std::size_t i) const { return tokens_.text(i); }
    std::size_t gap_before(std::size_t i) const { return tokens_[i].begin - tokens_[i - 1].end; }

    /// Behind the number, word, bracket, or word with its bracket, at i; i if there is none.
    std::size_t operand_end(std::size_t i) const {
        if (is(i, Kind::number)) return i + 1;
        const bool with_bracket = is(i, Kind::word) && is(i + 1, Kind::open) && gap_before(i + 1) == 0;
        const std::size_t open = with_bracket ? i + 1 : i;
        if (is(open, Kind::open)) {
            const std::size_t close = tokens_.partner(open);
            return close == tokens_.size() || (!with_bracket && holds_unknowns(open, close)) ? i : close + 1;
        }
        return is(i, Kind::word) ? i + 1 : i;
    }

    /// Behind the length of a vector, "|(0, 0, -2)|" or "||V||", whose bars open at i; i if they don't close.
    std::size_t length_end(std::size_t i) const {
        for (std::size_t k = i + 1; k < tokens_.size() && k - i <= most_tokens_in_bracket; ++k) {
            if (is(k, Kind::bar)) return text(k) == text(i) ? k + 1 : i;
        }
        return i;
    }

    /// Whether the bracket holds names and nothing else, as in a system: "[0 2 -2] * [t] = [1.5]".
    bool holds_unknowns(std::size_t open, std::size_t close) const {
        std::size_t i = open + 1;
        while (i < close && (is(i, Kind::word) || is(i, Kind::comma))) ++i;
        return i == close;
    }

    /// Whether the bracket [open, end) is a number or a sum in a product: "2 (-2) = -4", "2(S.x - C.x)V.x", "1(1) +
    /// 2(2)".
    bool is_factor(std::size_t open, std::size_t end) const {
        if (!is(open, Kind::open) || end == open) return false;
        bool has_number_or_sum = false;
        for (std::size_t i = open + 1; i + 1 < end; ++i) {
            if (is(i, Kind::comma)) return false;
            has_number_or_sum = has_number_or_sum || is(i, Kind::number) || is(i, Kind::op);
        }
        return has_number_or_sum && (is_operator(end) || is(end, Kind::equals) || multiplies(open, end));
    }

    /// Behind the dot product that opens at i, "(V, S - C)" or "<V, V>"; i if it is none.
    std::size_t dot_product_end(std::size_t i) const {
        if (!is(i, Kind::open) || tokens_.partner(i) == tokens_.size()) return i;
        std::size_t commas = 0;
        for (std::size_t k = i + 1; k < tokens_.partner(i); ++k) {
            if (!is(k, Kind::word) && !is(k, Kind::comma) && !is(k, Kind::op)) return i;
            commas += is(k, Kind::comma) ? 1 : 0;
        }
        return commas == 1 ? tokens_.partner(i) + 1 : i;
    }

    /// Whether the operand at i multiplies the one at `next`: "5.78 (0, 0, 1)", "2 V", "4(1)(2)".
    bool multiplies(std::size_t i, std::size_t next) const {
        if (!is(next, Kind::open) && !is(next, Kind::word)) return false;
        if (is(i, Kind::number)) return gap_before(next) <= 1;
        return is(i, Kind::open) && gap_before(next) == 0;  // "(0)(1)", "(S.x - C.x)V.x"
    }

    /// Whether the number at i multiplies what stands behind it and is no value: a whole number right behind '='.
    bool is_coefficient(std::size_t i) const {
        const bool is_whole = is(i, Kind::number) && tokens_[i].number.decimals == 0;
        return is_whole && multiplies(i, i + 1) && i > 0 && is(i - 1, Kind::equals);
    }

    bool is_operator(std::size_t i) const { return is(i, Kind::op) || is_multiplication(i); }

    /// '*', a point as in "V.(S - C)" but not at the end of a sentence, a cross.
    bool is_multiplication(std::size_t i) const {
        if (is(i, Kind::op)) return text(i) == "*";
        if (is(i, Kind::word)) return text(i) == "x";
        return is(i, Kind::other) && text(i) == "." && i + 1 < tokens_.size() && gap_before(i) == gap_before(i + 1);
    }

    bool is_bracket_of_operators() const {
        if (!is(begin_, Kind::open) || read_bracket(tokens_, begin_)) return false;
        for (std::size_t i = begin_; i < tokens_.partner(begin_); ++i) {
            if (is(i, Kind::op)) return true;
        }
        return false;
    }

    /// Whether the last operand may be the next value's label, as in "X = (1, 0, 0) / Y = (0, 1, 0)".
    bool may_be_label(std::size_t last, std::size_t end) const {
        const bool divides = is(last - 1, Kind::op) && (text(last - 1) == "-" || text(last - 1) == "/");
        return divides && is(last, Kind::word) && end == last + 1;
    }

    const LineTokens& tokens_;
    std::size_t begin_;
};

}  // namespace

std::optional<std::size_t> end_of_expression(const LineTokens& tokens, std::size_t begin) {
    return ExpressionReader(tokens, begin).end();
}

}  // namespace harness
