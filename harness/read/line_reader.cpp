#include "harness/read/line_reader.h"

#include <re2/re2.h>

#include <algorithm>
#include <cstddef>
#include <optional>

#include "harness/read/quadratic_line.h"
#include "harness/read/tokens/number_group.h"

namespace harness {
namespace {

using Kind = Token::Kind;

constexpr std::size_t longest_label = 200;

std::string_view trim(std::string_view part) {
    constexpr std::string_view around = " \t=:-><,;.*#|~/\\\"_";
    const std::size_t first = part.find_first_not_of(around);
    if (first == std::string_view::npos) return std::string_view();
    return part.substr(first, part.find_last_not_of(around) - first + 1);
}

bool is_named(std::string_view part, const RE2& name) {
    return RE2::FullMatch(re2::StringPiece(part.data(), part.size()), name);
}

/// The name in the words before a value: the text before the first '='. Anything but a word may come between a name and
/// its value: "t ==>", "t ....", "- t:". In "P_s = {x =" the name is the x of P_s.
std::string value_label(std::string_view words) {
    static const RE2 size(R"((?i).*(?:\|\s*(\w+)\s*\||abs\s*\(\s*(\w+)\s*\))\s*[:=]\s*)");
    re2::StringPiece of[2];
    if (RE2::FullMatch(re2::StringPiece(words.data(), words.size()), size, &of[0], &of[1]))
        return "intermediate: " + std::string(of[0]) + std::string(of[1]);
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
    if (first_part.data() != last_part.data()) {
        static const RE2 unknowns(R"((?i)[(\[{<]?\s*[tuv](?:\s*,\s*[tuv]){2}\s*[)\]}>]?)");  // "x = (u, v, t) ="
        if (is_named(last_part, unknowns)) return std::string(last_part);
        static const RE2 component(R"((?:(?:\w+\s*)?[(\[{<]\s*){0,2}["']?[xX])");
        if (is_named(last_part, component)) return std::string(first_part) + " x";
    }
    return first_part == "and" ? "" : std::string(first_part);
}

class Reader {
  public:
    explicit Reader(std::string_view line) : line_(line), tokens_(line) {}

    LineReading run() {
        take_quadratic();
        while (at_ < tokens_.size()) step();
        if (before_equals_) emit(*before_equals_);  // "0.58 = 2 - sqrt(2)", "0.58 = t"
        read_labels_behind();
        return std::move(reading_);
    }

  private:
    bool is(std::size_t i, Kind kind) const { return tokens_.is(i, kind); }
    std::string_view text(std::size_t i) const { return tokens_.text(i); }

    /// Reads the quadratic equation of the line, if it has one, and moves behind it.
    void take_quadratic() {
        auto equation = read_quadratic(line_);
        if (!equation) return;
        reading_.values = std::move(equation->values);
        reading_.has_words = true;
        label_begin_ = equation->end;
        while (at_ < tokens_.size() && tokens_[at_].begin < equation->end) ++at_;
    }

    /// Whether the bracket is a remark without a value: "0.333 (= 1/3)", "1.0 (unit vector, so 1)", "sqrt(2)".
    bool is_remark(std::size_t open) const {
        const std::size_t close = tokens_.partner(open);
        if (close == tokens_.size() || close - open > most_tokens_in_bracket) return false;
        if (is(open + 1, Kind::equals) || tokens_.is_call(open)) return true;
        bool has_words = false, has_equals = false;
        for (std::size_t i = open + 1; i < close; ++i) {
            has_words = has_words || (is(i, Kind::word) && !tokens_.is_type(i));
            has_equals = has_equals || is(i, Kind::equals);
        }
        return !reading_.values.empty() && has_words && !has_equals;
    }

    /// The '=' behind a formula that begins with the group: "(0, 0, 1) + 2 * (1, 0, 0) =". Empty if it begins none.
    std::optional<std::size_t> end_of_formula(const NumberGroup& found) const {
        std::size_t i = found.last;
        // "b = 2 dot(V, S - C) = -13.46"
        const bool is_coefficient = found.numbers.size() == 1 && found.numbers[0].decimals == 0 && found.first > 0 &&
                                    is(found.first - 1, Kind::equals) &&
                                    (tokens_.is_call(i + 1) || is(tokens_.partner(i) + 1, Kind::equals));
        if (!is(i, Kind::op) && !is_coefficient) return std::nullopt;
        std::size_t depth = 0;
        const std::size_t end = std::min(tokens_.size(), i + most_tokens_in_bracket);
        for (; i < end; ++i) {
            if (is(i, Kind::equals)) return text(i) != ":" && depth == 0 ? std::optional(i) : std::nullopt;
            if (is(i, Kind::comma) && depth == 0) return std::nullopt;
            if (is(i, Kind::open)) ++depth;
            if (is(i, Kind::close) && depth > 0) --depth;
        }
        return std::nullopt;
    }

    /// Whether the group before the '=' at `at_` has a name of its own, and so has the value behind: "d = 8 -> sqrt(d)
    /// = 2.83".
    bool names_next(const NumberGroup& found) const {
        const bool has_own = found.first > 0 && is(found.first - 1, Kind::equals);
        const bool is_call = is(at_ + 2, Kind::open) && tokens_.partner(at_ + 2) < tokens_.size();
        const std::size_t behind = is_call ? tokens_.partner(at_ + 2) + 1 : at_ + 2;
        return has_own && is(at_ + 1, Kind::word) && is(behind, Kind::equals) && text(at_) != "=";
    }

    void step() {
        if (is(at_, Kind::word)) {
            if (!tokens_.is_type(at_)) reading_.has_words = true;
            ++at_;
            return;
        }
        if (is(at_, Kind::open) && is_remark(at_)) {
            at_ = tokens_.partner(at_) + 1;
            return;
        }
        if (tokens_.is_index_of_row(at_)) {
            reading_.has_words = true;
            at_ = tokens_.partner(at_) + 1;
            return;
        }
        std::optional<NumberGroup> found;
        if (is(at_, Kind::open)) found = read_bracket(tokens_, at_);
        if (is(at_, Kind::number) && !is_index(tokens_, at_)) found = read_row(tokens_, at_);
        if (!found) {
            ++at_;
            return;
        }
        at_ = found->last;
        if (const auto equals = end_of_formula(*found)) {  // "(0, 0, 1) + 2 * (1, 0, 0) = (2, 0, 1)"
            at_ = *equals;
            return;
        }
        // A number before a second '=', as in "d = 8 = 16 - 8", is a value only if no value follows it.
        if (is(at_, Kind::equals) && !names_next(*found)) {
            before_equals_ = found;
            return;
        }
        emit(*found);
    }

    void emit(const NumberGroup& found) {
        PrintedValue value;
        value.groups = found.groups;
        value.bar_after = found.bar_after;
        value.numbers = found.numbers;
        std::size_t begin = tokens_[found.first].begin;
        std::size_t before = found.first;  // skips the brackets of a matrix that continues on the next lines
        while (before > 0 && found.first - before < deepest_bracket && is(before - 1, Kind::open)) --before;
        if (before > 0 && tokens_.is_type_word(before - 1)) {
            begin = tokens_[before - 1].begin;
            value.typed = true;
            --before;
        }
        if (is(found.first, Kind::open)) {
            const auto [factor, at] = factor_before(before);
            for (PrintedNumber& number : value.numbers) number.value *= factor;
            if (at < before) begin = tokens_[at].begin;
        }
        const bool opened = found.first > 0 && (is(found.first - 1, Kind::bar) || is(found.first - 1, Kind::open));
        value.framed =
            is(found.first, Kind::open) || (opened && (is(found.last, Kind::bar) || is(found.last, Kind::close)));
        value.label = label(begin);
        if (is_in_sentence(found, value.label) || negates_last(value.label, begin)) return;
        const std::size_t end = tokens_[found.last - 1].end;
        value.printed = std::string(line_.substr(begin, std::min(end - begin, longest_printed)));
        label_begin_ = end;
        before_equals_.reset();
        reading_.values.push_back(std::move(value));
    }

    /// What multiplies the bracket whose tokens begin at `begin`, "-1 * (1, 0, 0)" or "-(1, 0, 0)" behind '=', and
    /// where that begins.
    std::pair<double, std::size_t> factor_before(std::size_t begin) const {
        double factor = 1;
        std::size_t at = begin;
        if (at >= 2 && is(at - 1, Kind::op) && text(at - 1) == "*" && is(at - 2, Kind::number)) {
            at -= 2;
            factor = tokens_[at].number.value;
        }
        if (at >= 1 && is(at - 1, Kind::op) && text(at - 1) == "-") {
            --at;
            factor = -factor;
        }
        const bool is_value = at < begin && at >= 1 && is(at - 1, Kind::equals);
        return is_value ? std::pair(factor, at) : std::pair(1.0, begin);
    }

    /// Whether the value at `begin` only repeats the last one with the other sign: "b = 6 (-b = -6)".
    bool negates_last(std::string_view label, std::size_t begin) const {
        static const RE2 negated(R"([\s(,;]+-\s*\w+\s*[=:]\s*)");
        return !reading_.values.empty() && !label.empty() && reading_.values.back().label == label &&
               RE2::FullMatch(re2::StringPiece(line_.data() + label_begin_, begin - label_begin_), negated);
    }

    /// Whether a whole number is part of a sentence: "if there are 2 positive roots".
    bool is_in_sentence(const NumberGroup& found, std::string_view label) const {
        if (found.numbers.size() != 1 || found.numbers[0].decimals != 0 || found.first == 0) return false;
        const bool is_between_words = is(found.first - 1, Kind::word) && is(found.last, Kind::word);
        return is_between_words && !is(found.last + 1, Kind::equals) && label.find(' ') != std::string_view::npos &&
               text(found.first - 1) != "is" && tokens_[found.first].begin - tokens_[found.first - 1].end <= 1;
    }

    /// "1 (a), -4 (b), 2 (c)", "0.585786 <- t": if no words stand before the first value, the labels follow the values.
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

    /// What the value that begins at `end` is called.
    std::string label(std::size_t end) const {
        std::string_view words = line_.substr(label_begin_, end - label_begin_);
        if (words.size() > longest_label) words.remove_prefix(words.size() - longest_label);
        return value_label(words);
    }

    std::string_view line_;
    LineTokens tokens_;
    std::size_t at_ = 0;
    std::size_t label_begin_ = 0;
    std::optional<NumberGroup> before_equals_;
    LineReading reading_;
};

}  // namespace

LineReading read_line(std::string_view line) {
    return Reader(line).run();
}

}  // namespace harness
