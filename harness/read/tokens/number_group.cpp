#include "harness/read/tokens/number_group.h"

#include <re2/re2.h>

#include <algorithm>

namespace harness {
namespace {

using Kind = Token::Kind;

class GroupReader {
  public:
    explicit GroupReader(const LineTokens& tokens) : tokens_(tokens) {}

    std::optional<NumberGroup> row(std::size_t begin) const {
        NumberGroup found{{}, 1, 0, begin, begin};
        std::size_t i = begin;
        while (is(i, Kind::number)) {
            const Number number = read_number(i);
            if (is_term(i, number.next)) {
                if (found.numbers.empty()) return std::nullopt;
                break;
            }
            // The number is an index too in "Root 1 = 3.41" and "row 0: 1 0 0".
            const bool is_whole = number.number.decimals == 0 && number.number.value >= 0;
            if (!found.numbers.empty() && is_whole && is(number.next, Kind::equals) &&
                (is(number.next + 1, Kind::number) || is(number.next + 1, Kind::open)))
                break;
            found.numbers.push_back(number.number);
            found.numbers.back().value *= found.numbers.size() == 1 ? sign_apart(i) : 1.0;
            i = number.next;
            found.last = i;
            while (is(i, Kind::comma) || is(i, Kind::bar)) {
                if (is(i, Kind::bar) && is(i + 1, Kind::number))
                    found.bar_after = static_cast<int>(found.numbers.size());
                ++i;
            }
        }
        if (found.numbers.empty()) return std::nullopt;
        return found;
    }

    std::optional<NumberGroup> bracket(std::size_t begin) const {
        const std::size_t end = tokens_.partner(begin);
        if (end == tokens_.size() || end - begin > most_tokens_in_bracket) return std::nullopt;
        NumberGroup found{{}, 0, 0, begin, end + 1};
        std::size_t depth = 0;
        std::size_t group_begin = 0;
        int group_size = 0;
        int rows = 1;
        for (std::size_t i = begin; i <= end;) {
            if (is(i, Kind::number)) {
                const Number number = read_number(i);
                if (is_term(i, number.next)) return std::nullopt;
                found.numbers.push_back(number.number);
                found.numbers.back().value *= sign_apart(i);
                i = number.next;
                continue;
            }
            const bool apart = is(i, Kind::op) && text(i) == "-" && is(i + 1, Kind::number) && !is(i - 1, Kind::number);
            if (is(i, Kind::open)) {
                if (++depth > deepest_bracket) return std::nullopt;
                group_begin = found.numbers.size();
            } else if (is(i, Kind::close)) {
                --depth;
                const int size = static_cast<int>(found.numbers.size() - group_begin);
                if (size > 0) {
                    if (group_size != 0 && size != group_size) return std::nullopt;
                    group_size = size;
                    ++found.groups;
                }
                group_begin = found.numbers.size();
            } else if (is(i, Kind::bar)) {
                if (!found.numbers.empty() && i + 1 < end)
                    found.bar_after = static_cast<int>(found.numbers.size() - group_begin);
            } else if (is(i, Kind::comma) && text(i) == ";" && depth == 1 && found.groups == 0 &&
                       group_begin < found.numbers.size()) {
                ++rows;
            } else if (!is(i, Kind::comma) && !apart && !tokens_.is_type(i)) {
                return std::nullopt;
            }
            ++i;
        }
        if (found.numbers.empty() || depth != 0) return std::nullopt;
        // "[0 2 -2; 0 4 4; 1 0 0]" has rows divided by semicolons; "[1; 2; 3]" is a single vector.
        const bool in_rows = found.groups == 1 && rows > 1 && static_cast<int>(found.numbers.size()) % rows == 0;
        if (in_rows && static_cast<int>(found.numbers.size()) > rows) found.groups = rows;
        return found;
    }

  private:
    bool is(std::size_t i, Kind kind) const { return tokens_.is(i, kind); }
    std::string_view text(std::size_t i) const { return tokens_.text(i); }

    /// Whether the number in tokens [i, end) is a term of a formula or of a comparison.
    bool is_term(std::size_t i, std::size_t end) const {
        const bool compared = is(end, Kind::compare) && !(i > 0 && is(i - 1, Kind::equals));  // not "t = 0.9 > 0"
        if (is(end, Kind::op) || compared || is_coefficient(end)) return true;
        if (i == 0) return false;
        const bool glued = tokens_.size() == 3 && is(0, Kind::word) && i == 2 && tokens_[0].end == tokens_[1].begin;
        if (glued && text(1) == "-" && tokens_[1].end == tokens_[2].begin) return false;  // "b-3.5"
        if (is(i - 1, Kind::compare)) return true;
        // A '-' after '=', ',' or a bracket is a detached sign; a '-' at the start of the line is a bullet.
        return is(i - 1, Kind::op) && i >= 2 && !is(i - 2, Kind::equals) && !is(i - 2, Kind::open) &&
               !is(i - 2, Kind::comma);
    }

    /// Whether the number before `end` multiplies what touches it or follows an "x", and '=' stands behind: "2(V.D) =
    /// -4", "2h = -4", "2 x -2 = -4".
    bool is_coefficient(std::size_t end) const {
        if (end == 0 || end + 1 >= tokens_.size()) return false;
        const bool touches = tokens_[end - 1].end == tokens_[end].begin;
        if (is(end, Kind::open) && touches) return is_equals_sign(tokens_.partner(end) + 1);
        if (!is(end, Kind::word)) return false;
        // "a=1b=-4" has two values.
        const bool is_apart = tokens_[end].end < tokens_[end + 1].begin;
        return touches ? is_equals_sign(end + 1) && is_apart
                       : text(end) == "x" && is(end + 1, Kind::number) && is_equals_sign(end + 2);
    }

    bool is_equals_sign(std::size_t i) const { return is(i, Kind::equals) && text(i) == "="; }

    struct Number {
        PrintedNumber number;
        std::size_t next;
    };

    /// One number, or a fraction of two whole numbers.
    Number read_number(std::size_t i) const {
        PrintedNumber number = tokens_[i].number;
        if (is(i + 1, Kind::op) && text(i + 1) == "/" && is(i + 2, Kind::number) && number.decimals == 0 &&
            tokens_[i + 2].number.decimals == 0 && tokens_[i + 2].number.value != 0) {
            number.value /= tokens_[i + 2].number.value;
            number.exact = true;
            return {number, i + 3};
        }
        return {number, i + 1};
    }

    /// "= - 3", "= minus 3"
    double sign_apart(std::size_t i) const {
        if (i >= 2 && is(i - 1, Kind::word) && text(i - 1) == "minus" && is(i - 2, Kind::equals)) return -1.0;
        return i > 0 && is(i - 1, Kind::op) && text(i - 1) == "-" && i >= 2 ? -1.0 : 1.0;
    }

    const LineTokens& tokens_;
};

}  // namespace

std::optional<NumberGroup> read_row(const LineTokens& tokens, std::size_t begin) {
    return GroupReader(tokens).row(begin);
}

std::optional<NumberGroup> read_bracket(const LineTokens& tokens, std::size_t begin) {
    return GroupReader(tokens).bracket(begin);
}

bool is_index(const LineTokens& tokens, std::size_t i) {
    static const RE2 counted("(?i)rows?|line|eq|equation|cols?|columns?|root");
    const bool whole = tokens[i].number.decimals == 0 && tokens[i].number.value >= 0 && tokens[i].number.value < 10;
    if (!whole || i == 0 || !tokens.is(i - 1, Token::Kind::word)) return false;
    const std::string_view word = tokens.text(i - 1);
    return RE2::FullMatch(re2::StringPiece(word.data(), word.size()), counted);
}

}  // namespace harness
