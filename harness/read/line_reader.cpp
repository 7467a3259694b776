#include "harness/read/line_reader.h"

#include <re2/re2.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "harness/read/chosen_value.h"
#include "harness/read/formula.h"
#include "harness/read/joined_values.h"
#include "harness/read/number_in_sentence.h"
#include "harness/read/tokens/expression.h"
#include "harness/read/tokens/number_group.h"
#include "harness/read/value_label.h"
#include "harness/read/words/hit_words.h"
#include "harness/read/words/meaning.h"
#include "harness/text/lower_case.h"

namespace harness {
namespace {

using Kind = Token::Kind;

constexpr std::size_t longest_label = 200;

class Reader {
  public:
    Reader(std::string_view line, const OwnSeparators& separators)
        : separators_(separators), line_(line), tokens_(line, separators) {}

    LineReading run() {
        if (take_ray()) return std::move(reading_);
        take_linear_form();
        while (at_ < tokens_.size()) step();
        emit_before_equals();
        // A lone "none" may be part of a sentence, which the caller reads.
        if (reading_.values.size() == 1 && reading_.values[0].numbers.empty()) reading_.values.clear();
        join_system_row(reading_.values, line_);
        drop_places(reading_.values);
        drop_raw(reading_.values, line_);
        take_note_behind();
        read_labels_behind();
        keep_chosen(reading_.values, line_);
        return std::move(reading_);
    }

  private:
    bool is(std::size_t i, Kind kind) const { return tokens_.is(i, kind); }
    std::string_view text(std::size_t i) const { return tokens_.text(i); }

    /// Reads the formula that the line begins with, if it does, and moves behind it.
    void take_linear_form() {
        auto form = read_linear_form(line_);
        if (!form) return;
        reading_.values = std::move(form->values);
        reading_.has_words = true;
        label_begin_ = form->end;
        while (at_ < tokens_.size() && tokens_[at_].begin < form->end) ++at_;
    }

    /// Reads the origin and the direction if the line is a ray written out.
    bool take_ray() {
        const auto ray = read_ray(line_);
        if (!ray) return false;
        for (const auto& [vector, name] :
             {std::pair(ray->origin, "ray origin in the formula"), {ray->direction, "V in the formula"}}) {
            LineReading line_reading = Reader(vector, separators_).run();
            if (line_reading.values.size() != 1 || line_reading.values.front().numbers.size() != 3) {
                reading_.values.clear();
                return false;
            }
            line_reading.values.front().label = name;
            reading_.values.push_back(std::move(line_reading.values.front()));
        }
        reading_.has_words = true;
        return true;
    }

    /// Adds the note behind a matrix to its name: "M = ((0, 0, -1, 0), …) (column-major)".
    void take_note_behind() {
        constexpr std::size_t fewest = 9;
        std::vector<PrintedValue>& values = reading_.values;
        if (values.size() != 1 || values[0].numbers.size() < fewest || values[0].label.empty()) return;
        const std::string note = note_about_order(line_.substr(label_begin_));
        if (!note.empty()) values[0].label += " (" + note + ")";
    }

    /// Whether the bracket is a remark without a value: "0.333 (= 1/3)", "1.0 (unit vector, so 1)", "2 [2 = 6 - R^2]",
    /// "0.58 (also t = 3.41, farther)", "root (1 of 2)".
    bool is_remark(std::size_t open) const {
        static const RE2 of_others("(?i)also|other|not|instead|vs|rather");
        if (is(open + 1, Kind::equals)) return true;
        if (is(open + 1, Kind::number) && text(open + 2) == "of" && is(open + 3, Kind::number)) return true;
        if (reading_.values.empty() || tokens_.partner(open) - open > most_tokens_in_bracket) return false;
        const std::string_view first = text(open + 1);
        if (is(open + 1, Kind::word) && RE2::FullMatch(re2::StringPiece(first.data(), first.size()), of_others))
            return true;
        bool words = false;
        bool equals = false;
        for (std::size_t i = open + 1; i < tokens_.partner(open); ++i) {
            words = words || (is(i, Kind::word) && !tokens_.is_type(i));
            equals = equals || is(i, Kind::equals);
        }
        return words && (!equals || is(open + 1, Kind::number));
    }

    /// Where reading goes on behind an expression that is no value, since its result stands behind it or before it:
    /// "P = (0, 0, 1) + 2 * (1, 0, 0) = (2, 0, 1)".
    std::optional<std::size_t> behind_worked_out() const {
        const auto end = end_of_expression(tokens_, at_);
        if (!end) return std::nullopt;
        if (*end == tokens_.size() || is(*end, Kind::comma)) {  // "u = 0.25 = 1/4" has a fraction
            bool holds_names = is(at_, Kind::open);
            for (std::size_t i = at_; i < *end; ++i) holds_names = holds_names || is(i, Kind::word);
            return before_equals_ && holds_names ? end : std::nullopt;
        }
        const bool detached = is(*end + 1, Kind::op) && text(*end + 1) == "-";
        const std::size_t result = *end + (detached ? 2 : 1);
        const bool has_result = is(result, Kind::number) || is(result, Kind::open) || tokens_.is_type(result);
        return is(*end, Kind::equals) && text(*end) != ":" && has_result ? end : std::nullopt;
    }

    /// Whether the word says that the label before it has no value, as in "t": null within a line.
    bool is_no_value(std::size_t i) const {
        // Words that say so only as a value.
        static const RE2 as_value("(?i)na|x|empty|nullopt|flt_max|dbl_max");
        const std::string_view word = text(i);
        const bool says_none =
            meaning_of(lower_case(word)) == Meaning::none ||
            (i + 1 == tokens_.size() && RE2::FullMatch(re2::StringPiece(word.data(), word.size()), as_value));
        if (i == 0 || !says_none) return false;
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

    /// Whether the value behind the next '=' has a name of its own, as in "P_VCS = (0, 0, -2) -> P_WCS = (0, 0, 2)",
    /// "t = 0.58: P = (0, 0, 1)" and "d = 8 -> sqrt(d) = 2.83".
    bool names_next(const NumberGroup& found) const {
        const bool has_own = found.first > 0 && is(found.first - 1, Kind::equals);
        const bool is_call = is(at_ + 2, Kind::open) && tokens_.partner(at_ + 2) < tokens_.size();
        const std::size_t behind = is_call ? tokens_.partner(at_ + 2) + 1 : at_ + 2;
        return has_own && is(at_ + 1, Kind::word) && is(behind, Kind::equals) && text(at_) != "=";
    }

    /// Whether the number says where on the ray the point behind it is: "hit at t = 0.58: (0, 0, 1)".
    bool is_t_of_point(const NumberGroup& found) const {
        const bool is_named = found.first > 1 && is(found.first - 1, Kind::equals) && is(found.first - 2, Kind::word);
        const bool has_point = is(at_ + 1, Kind::open) || tokens_.is_type(at_ + 1);
        return found.numbers.size() == 1 && is_named && has_point && text(at_) != "=";
    }

    /// The point has the same label.
    void emit_t_of_point(const NumberGroup& found) {
        PrintedValue value;
        value.numbers = found.numbers;
        value.groups = found.groups;
        value.label = label(tokens_[found.first].begin);
        value.printed = std::string(
            line_.substr(tokens_[found.first].begin, tokens_[found.last - 1].end - tokens_[found.first].begin));
        reading_.values.push_back(std::move(value));
    }

    void step() {
        if (is(at_, Kind::word)) {
            if (before_equals_ && is(at_ - 1, Kind::equals)) {
                if (const auto end = behind_worked_out()) {  // "P_WCS = (0, 0, 2) = M * (0, 0, -2)"
                    at_ = *end;
                    return;
                }
            }
            if (is_no_value(at_)) emit_no_value();
            if (!tokens_.is_type(at_)) reading_.has_words = true;
            ++at_;
            return;
        }
        if (is(at_, Kind::number) || is(at_, Kind::open)) {
            if (const auto end = behind_worked_out()) {
                at_ = *end;
                return;
            }
        }
        if (is(at_, Kind::open) && tokens_.partner(at_) < tokens_.size() && is_remark(at_)) {
            at_ = tokens_.partner(at_) + 1;  // a remark: "0.333 (= 1/3)"
            return;
        }
        if (is_index_of_row(tokens_, at_)) {
            reading_.has_words = true;
            at_ = tokens_.partner(at_) + 1;
            return;
        }
        if (is(at_, Kind::open) && tokens_.partner(at_) < tokens_.size() && tokens_.is_call(at_)) {
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
        drop_count_of_roots(*found);
        if (found->numbers.empty()) {
            ++at_;
            return;
        }
        at_ = found->last;
        // A number before a second '=', as in "d = 8 = 16 - 8", is a value only if no value follows it.
        if (is(at_, Kind::equals) && !names_next(*found)) {
            if (is_t_of_point(*found)) return emit_t_of_point(*found);
            before_equals_ = found;
            return;
        }
        emit(*found);
    }

    /// Takes such a number out where a value stands before it.
    void drop_count_of_roots(NumberGroup& found) const {
        if (found.numbers.empty() || found.groups != 1 || !counts_roots(tokens_, found.last - 1)) return;
        const bool has_value = found.numbers.size() > 1 || before_equals_ || !reading_.values.empty();
        if (!has_value) return;
        found.numbers.pop_back();
        --found.last;
        while (found.last > found.first + 1 && is(found.last - 1, Kind::comma)) --found.last;
    }

    /// What multiplies the bracket whose value begins at `begin`, "-1 * (1, 0, 0)" or "-(1, 0, 0)" behind '=', and
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

    /// Whether the number is the right-hand side of the row before its '=', "0 2 -2 = 0".
    bool is_right_side_of_row(const NumberGroup& found) const {
        constexpr std::size_t columns = 3;
        return before_equals_ && before_equals_->last + 1 == found.first && text(before_equals_->last) == "=" &&
               before_equals_->numbers.size() == columns && before_equals_->groups == 1 && found.numbers.size() == 1 &&
               is(before_equals_->first, Kind::number) && is(found.first, Kind::number) && found.last == tokens_.size();
    }

    void emit(NumberGroup found) {
        PrintedValue value;
        value.groups = found.groups;
        value.bar_after = found.bar_after;
        if (is_right_side_of_row(found)) {
            value.bar_after = static_cast<int>(before_equals_->numbers.size());
            found.numbers.insert(found.numbers.begin(), before_equals_->numbers.begin(), before_equals_->numbers.end());
            found.first = before_equals_->first;
        }
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
        value.label = is_next_of_list(begin) ? reading_.values.back().label : label(begin);
        if (is_reason_for_vector(value, found.first)) value.label = "intermediate: " + value.label;
        if (is_in_sentence(tokens_, found, value.label)) return;
        if (negates_last(value.label, begin)) return;
        if (is_compared(tokens_, found)) return;
        const std::string_view words = line_.substr(label_begin(begin), begin - label_begin(begin));
        if (is_zero_of_equation(value, words) || is_truth_of_comparison(value, words)) return;
        const std::size_t end = tokens_[found.last - 1].end;
        value.printed = std::string(line_.substr(begin, std::min(end - begin, longest_printed)));
        label_begin_ = end;
        before_equals_.reset();
        reading_.values.push_back(std::move(value));
    }

    /// Emits the number before '=' if no value follows: "0.58 = 2 - sqrt(2)", "0.58 = t". Skips the index in "Root 1 =
    /// none".
    void emit_before_equals() {
        if (!before_equals_) return;
        const PrintedNumber& number = before_equals_->numbers.front();
        const bool counts = before_equals_->numbers.size() == 1 && number.decimals == 0 && before_equals_->first > 0 &&
                            is(before_equals_->first - 1, Kind::word) &&
                            !label(tokens_[before_equals_->first].begin).empty();
        const bool exact_words = reading_.has_words && is(before_equals_->last + 1, Kind::word);
        if (!counts || !exact_words) emit(*before_equals_);
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

    /// Where the label of a value ends at `end` begins. "t is none since d = -91": what follows "since" is d. "0 <= u,
    /// u+v = 0.5" and "u+v <= 1: yes (u+v = 0.5)": what is compared in an earlier clause has no value behind it.
    std::size_t label_begin(std::size_t end) const {
        const std::size_t begin = std::max(label_begin_, end - std::min(end, longest_label));  // no more is kept
        std::size_t last_clause = label_begin_, in_bracket = 0;
        bool has_name = false, in_list = false;
        for (std::size_t i = std::min(at_, tokens_.size()); i > 0 && tokens_[i - 1].begin >= begin; --i) {
            if (tokens_[i - 1].end > end) continue;
            if (is_reason_word(tokens_, i - 1)) return tokens_[i - 1].end;
            in_list = is(i - 1, Kind::close) || (in_list && !is(i - 1, Kind::open));
            has_name = has_name || is(i - 1, Kind::word);
            if (is(i - 1, Kind::comma) && has_name && !in_list && last_clause == label_begin_)
                last_clause = tokens_[i - 1].end;
            const std::size_t closed = is(i - 1, Kind::open) ? tokens_.partner(i - 1) : 0;
            const bool holds_value =
                is(i - 1, Kind::open) && (closed >= tokens_.size() || tokens_[closed].begin >= end);
            if (holds_value && has_name && in_bracket == 0) in_bracket = tokens_[i - 1].end;
            if (is(i - 1, Kind::compare) && in_bracket > 0) return in_bracket;
            if (is(i - 1, Kind::compare) && last_clause > tokens_[i - 1].end) return last_clause;
        }
        return label_begin_;
    }

    /// "check:" at the beginning of a line, of which only the last of several clauses names the value that ends at
    /// `label_begin`: it holds for this clause too.
    std::string_view remark_before(std::size_t label_begin) const {
        static const RE2 remark(R"(^\W*([A-Za-z]\w*\s*:))");
        re2::StringPiece found;
        const std::string_view before = line_.substr(0, label_begin);
        const bool has_one = label_begin_ == 0 && label_begin > 0 &&
                             RE2::PartialMatch(re2::StringPiece(before.data(), before.size()), remark, &found);
        return has_one ? std::string_view(found.data(), found.size()) : std::string_view();
    }

    /// What the value that begins at `end` is called.
    std::string label(std::size_t end) const {
        const std::size_t begin = label_begin(end);
        std::string_view words = line_.substr(begin, end - begin);
        if (words.size() > longest_label) words.remove_prefix(words.size() - longest_label);
        return value_label(words, remark_before(begin), label_begin_ == 0);
    }

    /// Whether the vector that begins with the token is given as a reason for one before it: "V = (0, 0, -1), since D =
    /// (0, 0, -2) and |D| = 2".
    bool is_reason_for_vector(const PrintedValue& value, std::size_t first_token) const {
        constexpr std::size_t vector = 3;
        const auto has_as_many = [&](const PrintedValue& printed) {
            return printed.numbers.size() == value.numbers.size();
        };
        bool is_behind_reason = false;
        for (std::size_t i = first_token; i > 0 && tokens_[i - 1].begin >= label_begin_; --i)
            is_behind_reason = is_behind_reason || is_reason_word(tokens_, i - 1);
        return is_behind_reason && value.numbers.size() >= vector && std::ranges::any_of(reading_.values, has_as_many);
    }

    /// Whether the value at `begin` is the next of those that the one before it is named for: "roots = 0.58 and 3.41".
    bool is_next_of_list(std::size_t begin) const {
        static const RE2 conjunction(R"((?i)\s*(?:and|und|et)\s*)");
        return !reading_.values.empty() && reading_.values.back().label.ends_with('s') &&
               RE2::FullMatch(re2::StringPiece(line_.data() + label_begin_, begin - label_begin_), conjunction);
    }

    /// Whether the value that ends the label at `begin` only repeats the last one with the other sign: "b = 6 (-b =
    /// -6)".
    bool negates_last(const std::string& label, std::size_t begin) const {
        static const RE2 negated(R"([\s(,;]+-\s*\w+\s*[=:]\s*)");
        const std::string_view name =
            std::string_view(label).substr(std::min(label.find_first_not_of("(- "), label.size()));
        if (reading_.values.empty() || name.empty() || reading_.values.back().label != name) return false;
        return RE2::FullMatch(re2::StringPiece(line_.data() + label_begin_, begin - label_begin_), negated);
    }

    const OwnSeparators& separators_;
    std::string_view line_;
    LineTokens tokens_;
    std::size_t at_ = 0;
    std::size_t label_begin_ = 0;
    std::optional<NumberGroup> before_equals_;
    LineReading reading_;
};

}  // namespace

LineReading read_line(std::string_view line, const OwnSeparators& separators) {
    return Reader(line, separators).run();
}

}  // namespace harness
