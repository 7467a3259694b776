#include "harness/line_reader.h"

#include <re2/re2.h>

#include <algorithm>
#include <optional>

#include "harness/linear_form.h"

namespace harness {
namespace {

using Kind = Token::Kind;

constexpr std::size_t longest_label = 200;
constexpr std::size_t longest_printed = 200;
/// A 4 x 4 matrix has 16 numbers in brackets two deep. Beyond these a bracket is no value; they keep reading linear in
/// the line's length whatever the brackets.
constexpr std::size_t deepest = 4;
constexpr std::size_t most_tokens_in_bracket = 128;

/// "vec3", "dvec4", "glm::mat4x4", "highp_vec3": the type names that glm::to_string and students print before a
/// bracket.
bool is_type_name(std::string_view word) {
    static const RE2 pattern(
        R"((?i)(?:glm::)?(?:(?:low|medium|high)p_)?(?:t?[fdiub]?\d{0,2}(?:vec|mat)[1234]?(?:x[234])?|vector[34]?|point[34]?|matrix[34]?))");
    return RE2::FullMatch(re2::StringPiece(word.data(), word.size()), pattern);
}

/// One line of a system written out: "| 0 2 -2 | * | t | = | 1.5 |".
const RE2& system_row_pattern() {
    static const RE2 pattern(
        R"([|\[(]\s*[-+.\deE]+\s*,?\s+[-+.\deE]+\s*,?\s+[-+.\deE]+\s*[|\])]\s*[*x.]?\s*[|\[(]\s*[a-zA-Z]\w?\s*[|\])]\s*=?\s*[|\[(]\s*[-+.\deE]+\s*[|\])])");
    return pattern;
}

class Reader {
  public:
    explicit Reader(std::string_view line) : line_(line), tokens_(tokenize(line)) { match_brackets(); }

    LineReading run() {
        if (auto values = read_linear_form(line_)) return {std::move(*values), true};
        while (at_ < tokens_.size()) step();
        emit_before_equals();
        // One such word may be the beginning of a sentence, which the caller reads.
        if (reading_.values.size() == 1 && reading_.values[0].numbers.empty()) reading_.values.clear();
        join_system_row();
        read_labels_behind();
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
    std::string_view text(std::size_t i) const {
        return line_.substr(tokens_[i].begin, tokens_[i].end - tokens_[i].begin);
    }

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

    /// Joins the matrix's row and the right-hand side's number of a system written out.
    void join_system_row() {
        std::vector<PrintedValue>& values = reading_.values;
        constexpr std::size_t longest_row = 400;
        if (values.size() != 2 || values[0].numbers.size() != 3 || values[1].numbers.size() != 1 ||
            line_.size() > longest_row)
            return;
        if (!RE2::PartialMatch(re2::StringPiece(line_.data(), line_.size()), system_row_pattern())) return;
        values[0].numbers.push_back(values[1].numbers[0]);
        values[0].bar_after = 3;
        values[0].printed = std::string(line_.substr(0, longest_printed));
        values.pop_back();
    }

    /// Brackets that hold no value: "0.333 (= 1/3)", "1.0 (unit vector, so 1)", "2 [2 = 6 - R^2]".
    bool is_remark(std::size_t open) const {
        if (is(open + 1, Kind::equals)) return true;
        if (reading_.values.empty() || partner_[open] - open > most_tokens_in_bracket) return false;
        bool words = false;
        bool equals = false;
        for (std::size_t i = open + 1; i < partner_[open]; ++i) {
            words = words || (is(i, Kind::word) && !is_inner_type(i));
            equals = equals || is(i, Kind::equals);
        }
        return words && (!equals || is(open + 1, Kind::number));
    }

    /// "sqrt(2)", "dot(V, V)".
    bool is_call(std::size_t open) const {
        static const RE2 function(
            "sqrt|abs|fabs|pow|min|max|dot|cross|length|normalize|inverse|determinant|sin|cos|tan");
        if (open == 0 || !is(open - 1, Kind::word) || tokens_[open - 1].end != tokens_[open].begin) return false;
        const std::string_view word = text(open - 1);
        return RE2::FullMatch(re2::StringPiece(word.data(), word.size()), function);
    }

    /// "t": null, within a line: the label has no value.
    bool is_no_value(std::size_t i) const {
        static const RE2 none("(?i)none|null|nil|undefined|nothing");
        const std::string_view word = text(i);
        if (i == 0 || !RE2::FullMatch(re2::StringPiece(word.data(), word.size()), none)) return false;
        const std::size_t quote = i > 1 && is(i - 1, Kind::other) && text(i - 1) == "\"" ? 1 : 0;
        return is(i - 1 - quote, Kind::equals);
    }

    void emit_no_value() {
        PrintedValue value;
        value.label = label(tokens_[at_].begin);
        value.printed = std::string(text(at_));
        label_begin_ = tokens_[at_].end;
        before_equals_.reset();
        reading_.values.push_back(std::move(value));
    }

    void step() {
        if (is(at_, Kind::word)) {
            if (is_no_value(at_)) emit_no_value();
            if (!(is_type_name(text(at_)) && is(at_ + 1, Kind::open))) {
                reading_.has_words = true;
            }
            ++at_;
            return;
        }
        if (is(at_, Kind::open) && partner_[at_] < tokens_.size() && is_remark(at_)) {
            at_ = partner_[at_] + 1;  // a remark: "0.333 (= 1/3)"
            return;
        }
        if (is(at_, Kind::open) && partner_[at_] < tokens_.size() && is_call(at_)) {
            at_ = partner_[at_] + 1;
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
            before_equals_ = found;
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
        const bool opened = found.first > 0 && (is(found.first - 1, Kind::bar) || is(found.first - 1, Kind::open));
        value.framed =
            is(found.first, Kind::open) || (opened && (is(found.last, Kind::bar) || is(found.last, Kind::close)));
        value.label = label(begin);
        if (is_prose(value, found)) return;
        if (is_equation(value)) return;
        const std::size_t end = tokens_[found.last - 1].end;
        value.printed = std::string(line_.substr(begin, std::min(end - begin, longest_printed)));
        label_begin_ = end;
        before_equals_.reset();
        reading_.values.push_back(std::move(value));
    }

    /// "0.58 = 2 - sqrt(2)", "0.58 = t": nothing behind the '=' is a value. Not "Root 1 = none", where the number
    /// counts.
    void emit_before_equals() {
        if (!before_equals_) return;
        const PrintedNumber& number = before_equals_->numbers.front();
        const bool counts = before_equals_->numbers.size() == 1 && number.decimals == 0 &&
                            !label(tokens_[before_equals_->first].begin).empty();
        const bool exact_words = reading_.has_words && is(before_equals_->last + 1, Kind::word);
        if (!counts || !exact_words) emit(*before_equals_);
    }

    /// "1 (a), -4 (b), 2 (c)", "0.585786 <- t": where no words stand before the first value, the labels stand behind.
    void read_labels_behind() {
        std::vector<PrintedValue>& values = reading_.values;
        if (values.empty() || !values.front().label.empty() || values.front().numbers.empty()) return;
        const std::string last = label(line_.size());
        if (last.empty()) return;
        for (std::size_t i = 0; i + 1 < values.size(); ++i) {
            if (values[i + 1].label.empty()) return;
        }
        for (std::size_t i = 0; i + 1 < values.size(); ++i) values[i].after = std::move(values[i + 1].label);
        for (PrintedValue& value : values) value.label.clear();
        values.back().after = last;
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
        std::string_view last_part;
        for (std::string_view rest = words; !rest.empty();) {
            const std::size_t equals = rest.find('=');
            if (const std::string_view part = trim(rest.substr(0, equals)); !part.empty()) {
                last_part = part;
                if (first_part.empty()) first_part = part;
            }
            rest = equals == std::string_view::npos ? std::string_view() : rest.substr(equals + 1);
        }
        // "P_s = {x = 2": component x of P_s.
        last_part.remove_prefix(std::min(last_part.find_first_not_of("([{<"), last_part.size()));
        if (last_part == "x" && first_part.data() != last_part.data()) return std::string(first_part) + " x";
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
        static const RE2 counted(R"((?i)of|to|by|than|for|from|question|step|part)");
        const std::string_view before = text(found.first - 1);
        const auto spaces = std::count(value.label.begin(), value.label.end(), ' ');
        if (spaces >= 4 && RE2::FullMatch(re2::StringPiece(before.data(), before.size()), counted)) return true;
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
        const bool whole =
            tokens_[i].number.decimals == 0 && tokens_[i].number.value >= 0 && tokens_[i].number.value < 10;
        if (!whole || i == 0 || !is(i - 1, Kind::word)) return false;
        const std::string_view word = text(i - 1);
        return RE2::FullMatch(re2::StringPiece(word.data(), word.size()), counted);
    }

    /// Whether number token `i`, a fraction up to `end`, is a term of a formula or of a comparison.
    bool is_term(std::size_t i, std::size_t end) const {
        const bool compared = is(end, Kind::compare) && !(i > 0 && is(i - 1, Kind::equals));  // not "t = 0.9 > 0"
        if (is(end, Kind::op) || compared) return true;
        if (i == 0) return false;
        const bool glued = tokens_.size() == 3 && is(0, Kind::word) && i == 2 && tokens_[0].end == tokens_[1].begin;
        if (glued && text(1) == "-" && tokens_[1].end == tokens_[2].begin) return false;  // "b-3.5"
        if (is(i - 1, Kind::compare)) return true;
        // A '-' after '=', ',' or a bracket is a sign that stands apart, and one at the line's start is a bullet.
        return is(i - 1, Kind::op) && i >= 2 && !is(i - 2, Kind::equals) && !is(i - 2, Kind::open) &&
               !is(i - 2, Kind::comma);
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

    double sign_apart(std::size_t i) const {
        return i > 0 && is(i - 1, Kind::op) && text(i - 1) == "-" && i >= 2 ? -1.0 : 1.0;
    }

    /// "col 1 (t): 0 0 -1": a number that is a label's index.
    bool is_named_index(std::size_t next) const {
        return is(next, Kind::open) && is(next + 1, Kind::word) && is(next + 2, Kind::close) &&
               is(next + 3, Kind::equals);
    }

    /// "0.9, 0.2 and 0.3".
    bool joins_last(std::size_t i, std::size_t count) const {
        return count >= 2 && is(i, Kind::word) && text(i) == "and" && is(i + 1, Kind::number);
    }

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
            if (is_named_index(number.next)) return std::nullopt;
            // "Root 1 = 3.41", "row 0: 1 0 0": here too.
            if (!found.numbers.empty() && is(number.next, Kind::equals)) break;
            found.numbers.push_back(number.number);
            found.numbers.back().value *= found.numbers.size() == 1 ? sign_apart(i) : 1.0;
            i = number.next;
            found.last = i;
            while (is(i, Kind::comma) || is(i, Kind::bar) || joins_last(i, found.numbers.size())) {
                if (is(i, Kind::bar) && is(i + 1, Kind::number))
                    found.bar_after = static_cast<int>(found.numbers.size());
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
                if (!found.numbers.empty() && i + 1 < end)
                    found.bar_after = static_cast<int>(found.numbers.size() - group_begin);
            } else if (is(i, Kind::comma) && text(i) == ";" && depth == 1 && found.groups == 0 &&
                       group_begin < found.numbers.size()) {
                ++rows;
            } else if (!is(i, Kind::comma) && !apart && !is_inner_type(i)) {
                return std::nullopt;
            }
            ++i;
        }
        if (found.numbers.empty() || depth != 0) return std::nullopt;
        // "[0 2 -2; 0 4 4; 1 0 0]": rows divided by semicolons, as "[1; 2; 3]" is not.
        const bool in_rows = found.groups == 1 && rows > 1 && static_cast<int>(found.numbers.size()) % rows == 0;
        if (in_rows && static_cast<int>(found.numbers.size()) > rows) found.groups = rows;
        return found;
    }

    /// "mat3(vec3(…), vec3(…))".
    bool is_inner_type(std::size_t i) const {
        return is(i, Kind::word) && is(i + 1, Kind::open) && is_type_name(text(i));
    }

    std::string_view line_;
    std::vector<Token> tokens_;
    std::vector<std::size_t> partner_;
    std::size_t at_ = 0;
    std::size_t label_begin_ = 0;
    std::optional<Found> before_equals_;
    LineReading reading_;
};

}  // namespace

LineReading read_line(std::string_view line) {
    return Reader(line).run();
}

}  // namespace harness
