#include "harness/line_reader.h"

#include <re2/re2.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace harness {
namespace {

using Kind = Token::Kind;

constexpr std::size_t longest_label = 200;
constexpr std::size_t longest_printed = 200;
/// A 4 x 4 matrix has 16 numbers in brackets two deep. Beyond these a bracket is no value; they keep reading linear in the
/// line's length whatever the brackets.
constexpr std::size_t deepest = 4;
constexpr std::size_t most_tokens_in_bracket = 128;

/// "vec3", "dvec4", "glm::mat4x4", "highp_vec3": the type names that glm::to_string and students print before a bracket.
bool is_type_name(std::string_view word) {
    static const RE2 pattern(R"((?i)(?:glm::)?(?:(?:low|medium|high)p_)?(?:[fdiub]?(?:vec|mat)[234](?:x[234])?|vector[34]?|point[34]?|matrix[34]?))");
    return RE2::FullMatch(re2::StringPiece(word.data(), word.size()), pattern);
}

/// "a t^2 + b t + c = 0": a quadratic written with its coefficients.
const RE2& quadratic_pattern() {
    static const RE2 pattern(
        R"(^(.*?)\(?\s*([-+]?[\d.]+(?:e[-+]?\d+)?)\s*\)?\s*\*?\s*(?:t\s*\^\s*2|t\s*\*\s*t|t2|tt)\s*([-+])\s*\(?\s*([-+]?[\d.]+(?:e[-+]?\d+)?)\s*\)?\s*\*?\s*t\s*([-+])\s*\(?\s*([-+]?[\d.]+(?:e[-+]?\d+)?)\s*\)?\s*=\s*0(?:\.0*)?\b)");
    return pattern;
}

class Reader {
  public:
    explicit Reader(std::string_view line) : line_(line), tokens_(tokenize(line)) { match_brackets(); }

    LineReading run() {
        if (read_quadratic()) return std::move(reading_);
        while (at_ < tokens_.size()) step();
        if (reading_.values.empty() && before_equals_) emit(*before_equals_);
        return std::move(reading_);
    }

  private:
    /// A value found, by its tokens [first, last).
    struct Found {
        std::vector<PrintedNumber> numbers;
        int groups = 1;
        int bar_after = 0;
        std::size_t first;
        std::size_t last;
    };

    bool is(std::size_t i, Kind kind) const { return i < tokens_.size() && tokens_[i].kind == kind; }
    std::string_view text(std::size_t i) const { return line_.substr(tokens_[i].begin, tokens_[i].end - tokens_[i].begin); }

    /// Finds every opening bracket's partner once, so that unbalanced brackets cost no repeated search.
    void match_brackets() {
        partner_.assign(tokens_.size(), tokens_.size());
        std::vector<std::size_t> open;
        for (std::size_t i = 0; i < tokens_.size(); ++i) {
            if (is(i, Kind::open)) open.push_back(i);
            if (is(i, Kind::close) && !open.empty()) {
                partner_[open.back()] = i;
                open.pop_back();
            }
        }
    }

    bool read_quadratic() {
        if (line_.size() > 1000 || line_.find('t') == std::string_view::npos) return false;
        re2::StringPiece label;
        std::string a, b, c, b_sign, c_sign;
        if (!RE2::PartialMatch(re2::StringPiece(line_.data(), line_.size()), quadratic_pattern(), &label, &a, &b_sign, &b, &c_sign, &c)) {
            return false;
        }
        reading_.has_words = true;
        add_coefficient("a", "+", a);
        add_coefficient("b", b_sign, b);
        add_coefficient("c", c_sign, c);
        return reading_.values.size() == 3;
    }

    void add_coefficient(const char* name, const std::string& sign, const std::string& number) {
        const std::vector<Token> tokens = tokenize(number);
        if (tokens.size() != 1 || tokens[0].kind != Kind::number) return;
        PrintedValue value;
        value.numbers = {tokens[0].number};
        if (sign == "-") value.numbers[0].value = -value.numbers[0].value;
        value.label = name;
        value.printed = std::string(line_.substr(0, longest_printed));
        reading_.values.push_back(value);
    }

    void step() {
        if (is(at_, Kind::word)) {
            if (!(is_type_name(text(at_)) && is(at_ + 1, Kind::open))) {
                reading_.has_words = true;
                before_equals_.reset();
            }
            ++at_;
            return;
        }
        if (is(at_, Kind::open) && is(at_ + 1, Kind::equals) && partner_[at_] < tokens_.size()) {
            at_ = partner_[at_] + 1;  // a remark: "0.333 (= 1/3)"
            return;
        }
        std::optional<Found> found;
        if (is(at_, Kind::open)) found = read_bracket(at_);
        if (is(at_, Kind::number) && !is_index(at_)) found = read_run(at_);
        if (!found) {
            ++at_;
            return;
        }
        at_ = found->last;
        // "d = 8 = 16 - 8": what stands before another '=' is a value only when nothing follows that is one.
        if (is(at_, Kind::equals)) {
            if (!before_equals_) before_equals_ = found;
            return;
        }
        emit(*found);
    }

    void emit(const Found& found) {
        PrintedValue value;
        value.numbers = found.numbers;
        value.groups = found.groups;
        value.bar_after = found.bar_after;
        std::size_t begin = tokens_[found.first].begin;
        std::size_t before = found.first;  // past the brackets of a matrix that goes on over the next lines
        while (before > 0 && found.first - before < deepest && is(before - 1, Kind::open)) --before;
        if (before > 0 && is(before - 1, Kind::word) && is_type_name(text(before - 1))) {
            begin = tokens_[before - 1].begin;
            value.typed = true;
        }
        value.label = label(begin);
        if (is_prose(value, found)) return;
        if (is_equation(value)) return;
        const std::size_t end = tokens_[found.last - 1].end;
        value.printed = std::string(line_.substr(begin, std::min(end - begin, longest_printed)));
        label_begin_ = end;
        before_equals_.reset();
        reading_.values.push_back(std::move(value));
    }

    /// The words between the last value and `end`, up to their first '=', without the punctuation around them.
    std::string label(std::size_t end) const {
        std::string_view words = line_.substr(label_begin_, end - label_begin_);
        if (words.size() > longest_label) words.remove_prefix(words.size() - longest_label);
        constexpr std::string_view around = " \t=:-><,;.*#|~/\\\"";
        const auto trim = [&](std::string_view part) {
            const std::size_t first = part.find_first_not_of(around);
            if (first == std::string_view::npos) return std::string_view();
            return part.substr(first, part.find_last_not_of(around) - first + 1);
        };
        std::string_view first_part;
        for (std::string_view rest = words; first_part.empty() && !rest.empty();) {
            const std::size_t equals = rest.find('=');
            first_part = trim(rest.substr(0, equals));
            rest = equals == std::string_view::npos ? std::string_view() : rest.substr(equals + 1);
        }
        // A remark behind the value before: "t = 0.58 (the smaller root), hit = …".
        if (label_begin_ > 0 && !first_part.empty() && first_part.front() == '(') {
            const std::size_t close = first_part.find(')');
            if (close != std::string_view::npos) {
                const std::string_view rest = trim(first_part.substr(close + 1));
                if (!rest.empty()) first_part = rest;
            }
        }
        return std::string(first_part);
    }

    /// A lone whole number within a sentence: "if there are 2 positive roots".
    bool is_prose(const PrintedValue& value, const Found& found) const {
        if (value.numbers.size() != 1 || value.numbers[0].decimals != 0 || found.first == 0) return false;
        if (!is(found.first - 1, Kind::word) || !is(found.last, Kind::word)) return false;
        const std::size_t gap = tokens_[found.first].begin - tokens_[found.first - 1].end;
        return gap <= 1 && value.label.find(' ') != std::string::npos;
    }

    /// The 0 of "a t^2 + b t + c = 0", which is no answer.
    static bool is_equation(const PrintedValue& value) {
        const bool zero = value.numbers.size() == 1 && value.numbers[0].value == 0 && value.numbers[0].decimals == 0;
        return zero && value.label.find('+') != std::string::npos;
    }

    /// "row 1", "column 0": the number is part of the label.
    bool is_index(std::size_t i) const {
        static const RE2 counted(R"((?i)rows?|col(?:umn)?s?|line|eq(?:uation)?|root)");
        const bool whole = tokens_[i].number.decimals == 0 && tokens_[i].number.value >= 0 && tokens_[i].number.value < 10;
        if (!whole || i == 0 || !is(i - 1, Kind::word)) return false;
        const std::string_view word = text(i - 1);
        return RE2::FullMatch(re2::StringPiece(word.data(), word.size()), counted);
    }

    /// Whether number token `i`, a fraction up to `end`, is a term of a formula or of a comparison.
    bool is_term(std::size_t i, std::size_t end) const {
        const auto joins = [&](std::size_t k) { return is(k, Kind::op) || is(k, Kind::compare); };
        if (joins(end)) return true;
        if (i == 0) return false;
        if (is(i - 1, Kind::compare)) return true;
        // A '-' after '=', ',' or a bracket is a sign that stands apart, and one at the line's start is a bullet.
        return is(i - 1, Kind::op) && i >= 2 && !is(i - 2, Kind::equals) && !is(i - 2, Kind::open) && !is(i - 2, Kind::comma);
    }

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

    double sign_apart(std::size_t i) const { return i > 0 && is(i - 1, Kind::op) && text(i - 1) == "-" && i >= 2 ? -1.0 : 1.0; }

    /// Numbers in a row without words between: "1 -4 2", "0, 0, -2", "0 2 -2 | 0".
    std::optional<Found> read_run(std::size_t begin) {
        Found found{{}, 1, 0, begin, begin};
        std::size_t i = begin;
        while (is(i, Kind::number)) {
            const Number number = read_number(i);
            if (is_term(i, number.next)) {
                if (found.numbers.empty()) return std::nullopt;
                break;
            }
            // "Root 1 = 3.41", "row 0: 1 0 0": a number that is a label's index.
            if (!found.numbers.empty() && is(number.next, Kind::equals)) break;
            found.numbers.push_back(number.number);
            found.numbers.back().value *= found.numbers.size() == 1 ? sign_apart(i) : 1.0;
            i = number.next;
            found.last = i;
            while (is(i, Kind::comma) || is(i, Kind::bar)) {
                if (is(i, Kind::bar) && is(i + 1, Kind::number)) found.bar_after = static_cast<int>(found.numbers.size());
                ++i;
            }
        }
        if (found.numbers.empty()) return std::nullopt;
        return found;
    }

    /// "(0, 0, -2)" or "((1, 0), (0, 1))": a bracket that holds numbers only.
    std::optional<Found> read_bracket(std::size_t begin) const {
        const std::size_t end = partner_[begin];
        if (end == tokens_.size() || end - begin > most_tokens_in_bracket) return std::nullopt;
        Found found{{}, 0, 0, begin, end + 1};
        std::size_t depth = 0;
        std::size_t group_begin = 0;
        int group_size = 0;
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
            if (is(i, Kind::open) && is(i + 1, Kind::equals)) {  // a remark: "( 0.5 (= 1/2), … )"
                i = std::min(partner_[i], end) + 1;
                continue;
            }
            if (is(i, Kind::open)) {
                if (++depth > deepest) return std::nullopt;
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
                if (!found.numbers.empty() && i + 1 < end) found.bar_after = static_cast<int>(found.numbers.size() - group_begin);
            } else if (!is(i, Kind::comma) && !apart && !is_inner_type(i)) {
                return std::nullopt;
            }
            ++i;
        }
        if (found.numbers.empty() || depth != 0) return std::nullopt;
        return found;
    }

    /// "mat3(vec3(…), vec3(…))".
    bool is_inner_type(std::size_t i) const { return is(i, Kind::word) && is(i + 1, Kind::open) && is_type_name(text(i)); }

    std::string_view line_;
    std::vector<Token> tokens_;
    std::vector<std::size_t> partner_;
    std::size_t at_ = 0;
    std::size_t label_begin_ = 0;
    std::optional<Found> before_equals_;
    LineReading reading_;
};

}  // namespace

LineReading read_line(std::string_view line) { return Reader(line).run(); }

}  // namespace harness
