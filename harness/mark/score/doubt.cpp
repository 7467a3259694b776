#include "harness/mark/score/doubt.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <span>

#include "harness/mark/compare/key_targets.h"
#include "harness/match/question_match.h"
#include "harness/read/no_value.h"
#include "harness/read/tokens/own_separators.h"
#include "harness/read/words/hit_words.h"

namespace harness {
namespace {

using reference::Shape;

/// Beyond this many numbers the printout is an endless loop's.
constexpr std::size_t most_numbers = 4000;

/// As many values that are said to be no answers, and lines of words, are looked at.
constexpr std::size_t most_asides = 500;
constexpr std::size_t most_lines = 500;

/// A number of the printout, wherever it stands.
struct Found {
    PrintedNumber number;
    int question;
    int line;
    bool in_answer = false;  ///< it belongs to what was read for an item
    bool in_right_answer = false;
    bool is_scalar = false;              ///< it is an answer of one number, which is right or follows
    const MatchedItem* named = nullptr;  ///< the item that it was read for, if its label names it
    bool is_aside = false;               ///< it is said to be no answer, or counts something
    bool repeats = false;                ///< an answer has the same number
};

/// The values of one question from a heading on.
struct Printing {
    int first_line;
    int last_line;
    std::size_t values;
};

std::size_t numbers_in(Shape shape) {
    return static_cast<std::size_t>(reference::component_count(shape));
}

bool same(const PrintedNumber& a, const PrintedNumber& b) {
    return std::abs(a.value) == std::abs(b.value) || (std::isnan(a.value) && std::isnan(b.value));
}

/// Whether the item has a number like it in the value that was read for it.
bool has_number(const MatchedItem& item, const Found& found) {
    return item.value && std::any_of(item.value->numbers.begin(), item.value->numbers.end(),
                                     [&](const PrintedNumber& x) { return same(x, found.number); });
}

/// Whether what was read for the item includes this number of the printout.
bool was_read_from(const MatchedItem& item, const Found& found) {
    return !item.unreadable && has_number(item, found) && item.value->line <= found.line &&
           found.line <= item.value->last_line;
}

/// Whether the label of what was read for `item` names the item `other`.
bool names(const MatchedItem& item, const reference::ItemSpec& other) {
    return item.value && !item.unreadable && fit_label(item.value->label, item.value->above, other) >= LabelFit::named;
}

class Doubter {
  public:
    Doubter(Score& score, const Transcript& transcript, const std::vector<MatchedItem>& matched,
            const reference::AnswerKey& key, const reference::Assignment& assignment)
        : transcript_(transcript), matched_(matched), key_(key), rubric_(assignment.rubric), score_(score) {
        list_numbers();
        account_for_answers();
        account_for_asides();
    }

    void run() {
        const bool little_read = is_little_read();
        for (QuestionScore& question : score_.questions) {
            for (ItemScore& item : question.items) {
                if (item.verdict == ItemVerdict::right || !item.reread.empty()) continue;
                item.doubt = doubt_of(item, little_read);
            }
        }
    }

  private:
    void list_numbers() {
        for (const Section& section : transcript_.sections) headings_.insert(section.question);
        for (const Section& section : transcript_.sections) {
            for (const PrintedLine& line : section.lines) {
                if (numbers_.size() >= most_numbers) return;
                const std::vector<Token> tokens = tokenize(line.text);
                for (std::size_t i = 0; i < tokens.size(); ++i) {
                    if (tokens[i].kind != Token::Kind::number || is_bracketed_index(tokens, i)) continue;
                    numbers_.push_back({tokens[i].number, section.question, line.number});
                    if (i > 0 && tokens[i - 1].kind == Token::Kind::equals) equations_.insert(line.number);
                }
            }
        }
    }

    void account_for_answers() {
        for (const MatchedItem& item : matched_) {
            if (!item.value) continue;
            for (Found& found : numbers_) {
                if (has_number(item, found) && !std::isnan(found.number.value)) answered_.push_back(found.number.value);
                if (!was_read_from(item, found)) continue;
                found.in_answer = true;
                const ItemVerdict verdict = verdict_of(item.spec.id);
                found.in_right_answer = found.in_right_answer || verdict == ItemVerdict::right;
                const bool is_sure = verdict == ItemVerdict::right || verdict == ItemVerdict::follow;
                found.is_scalar = found.is_scalar || (is_sure && item.spec.shape == Shape::scalar);
                if (names(item, item.spec)) found.named = &item;
            }
        }
    }

    /// Repetitions of answers, values that are said to be none, whole numbers in sentences.
    void account_for_asides() {
        std::sort(answered_.begin(), answered_.end());
        std::set<std::pair<int, int>> asides;  // first and last lines
        std::set<int> with_values;
        std::size_t seen = 0;
        for (const Section& section : transcript_.sections) {
            for (const PrintedValue& value : section.values) {
                if (++seen > most_numbers) break;
                for (int line = value.line; line <= value.last_line; ++line) with_values.insert(line);
                const auto& items = key_.questions.front().items;
                if (asides.size() < most_asides &&
                    fit_label(value.label, value.above, items.front().spec) == LabelFit::forbidden)
                    asides.insert({value.line, value.last_line});
            }
        }
        for (Found& found : numbers_) {
            found.repeats = std::binary_search(answered_.begin(), answered_.end(), found.number.value);
            const bool counts =
                found.number.decimals == 0 && !with_values.contains(found.line) && !equations_.contains(found.line);
            const bool aside = std::any_of(asides.begin(), asides.end(), [&](const auto& lines) {
                return lines.first <= found.line && found.line <= lines.second;
            });
            found.is_aside = counts || aside;
        }
    }

    bool is_little_read() const {
        const auto read = std::count_if(matched_.begin(), matched_.end(), [](const MatchedItem& item) {
            return (item.value && !item.unreadable) || item.verdict;
        });
        const bool printed = std::any_of(transcript_.sections.begin(), transcript_.sections.end(),
                                         [](const Section& section) { return !section.values.empty(); });
        const auto left = std::count_if(numbers_.begin(), numbers_.end(), is_left);
        return printed && left >= 3 && 2 * static_cast<std::size_t>(read) < matched_.size();
    }

    std::optional<Doubt> doubt_of(const ItemScore& item, bool little_read) const {
        if (const int line = line_of_right_value(item); line != 0) return Doubt{Doubt::Why::right_elsewhere, line};
        // What follows and has all its points could gain nothing: unless the right value is there, it was meant.
        if (item.verdict == ItemVerdict::follow && item.points >= item.max_points) return std::nullopt;
        if (const int line = line_printed_again(item); line != 0) return Doubt{Doubt::Why::printed_again, line};
        // Where an item is missing, numbers that an answer has too may be it: a matrix repeats the axes.
        const bool is_wrong = item.verdict == ItemVerdict::wrong || item.verdict == ItemVerdict::follow;
        const auto left = [&](const Found& found) {
            const bool on_its_line = item.line <= found.line && found.line <= item.last_line;
            return is_left(found) && (on_its_line || (may_be_of(found.question, item) && !(is_wrong && found.repeats)));
        };
        const auto count = static_cast<std::size_t>(std::count_if(numbers_.begin(), numbers_.end(), left));
        constexpr std::size_t row = 3;  // a row of a matrix may be left alone
        if (count > 0 && count >= std::min(row, numbers_in(item.spec.shape)) && item.spec.shape != Shape::verdict)
            return Doubt{Doubt::Why::numbers_left, std::find_if(numbers_.begin(), numbers_.end(), left)->line};
        if (const int line = line_of_words(item); line != 0) return Doubt{Doubt::Why::words_left, line};
        if (little_read && item.verdict != ItemVerdict::follow) return Doubt{Doubt::Why::little_read, 0};
        return std::nullopt;
    }

    static bool is_left(const Found& found) { return !found.in_answer && !found.is_aside; }

    /// Whether what stands under this heading may be meant for the item: under the heading of its question, or, if
    /// there is none, under any.
    bool may_be_of(int question, const ItemScore& item) const {
        return question == item.spec.question || !headings_.contains(item.spec.question);
    }

    ItemVerdict verdict_of(const ItemId& id) const {
        for (const QuestionScore& question : score_.questions) {
            for (const ItemScore& item : question.items) {
                if (item.spec.id == id) return item.verdict;
            }
        }
        return ItemVerdict::missing;
    }

    const reference::KeyItem& key_item(const reference::ItemSpec& spec) const {
        const reference::KeyItem* item = reference::asked_item(key_, spec.id);
        return item == nullptr ? key_.questions.front().items.front() : *item;
    }

    /// The line where a value begins that is right for the item and was not read for it; 0 if there is none.
    int line_of_right_value(const ItemScore& item) const {
        const std::size_t size = numbers_in(item.spec.shape);
        if (size == 0) return 0;
        // A vector may also be a column of a block with three or four columns.
        for (const std::size_t stride : {std::size_t{1}, std::size_t{3}, std::size_t{4}}) {
            if (stride > 1 && size != 3) break;
            for (std::size_t i = 0; i + (size - 1) * stride < numbers_.size(); ++i) {
                if (is_right_value(item, i, stride)) return numbers_[i].line;
            }
        }
        return 0;
    }

    bool begins_line(std::size_t i) const { return i == 0 || numbers_[i - 1].line != numbers_[i].line; }
    bool ends_line(std::size_t i) const { return i + 1 == numbers_.size() || begins_line(i + 1); }

    /// Whether so many numbers from `first` on, a stride apart, are printed as one value: in one line, in whole lines
    /// one after the other, or as a column of lines that have as many numbers as the stride. Others are pieces of
    /// several values.
    bool is_one_value(std::size_t first, std::size_t size, std::size_t stride) const {
        const std::size_t last = first + (size - 1) * stride;
        if (numbers_[first].line == numbers_[last].line) return true;
        if (stride == 1) return begins_line(first) && ends_line(last);
        std::size_t row = first;
        while (!begins_line(row)) --row;
        for (std::size_t i = row; i < row + size * stride; ++i) {
            const bool is_start = (i - row) % stride == 0, is_end = (i - row) % stride == stride - 1;
            if (i >= numbers_.size() || begins_line(i) != is_start || ends_line(i) != is_end) return false;
        }
        return true;
    }

    /// Whether these numbers are no doubt of the item: it was read from all of them, and so they were judged; or their
    /// labels name others and its own label names it, as where u and v are swapped.
    bool is_said_which(const ItemScore& item, const std::vector<const Found*>& numbers) const {
        const auto own = std::find_if(matched_.begin(), matched_.end(),
                                      [&](const MatchedItem& each) { return each.spec.id == item.spec.id; });
        if (own == matched_.end()) return false;
        const bool are_of_others = std::ranges::all_of(numbers, [&](const Found* each) {
            return each->named != nullptr && !names(*each->named, item.spec) && !names(*own, each->named->spec);
        });
        return (are_of_others && names(*own, item.spec)) ||
               std::ranges::all_of(numbers, [&](const Found* each) { return was_read_from(*own, *each); });
    }

    /// Whether the numbers from `first` on, a stride apart, are right for the item and no right answer's. A single
    /// number must have three digits and stand in the item's question: others are right by chance too often.
    bool is_right_value(const ItemScore& item, std::size_t first, std::size_t stride) const {
        if (!is_one_value(first, numbers_in(item.spec.shape), stride)) return false;
        std::vector<const Found*> found;
        for (std::size_t k = 0; k < numbers_in(item.spec.shape); ++k) found.push_back(&numbers_[first + k * stride]);
        // Lines such as "t = 2 u = 0.25 v = 0.25" are no rows of a block.
        if (stride > 1 && std::any_of(found.begin(), found.end(), [](const Found* each) { return each->is_scalar; }))
            return false;
        const bool is_own = may_be_of(found.front()->question, item);
        if (found.size() == 1 && (!is_own || found.front()->number.significant < 3)) return false;
        const auto is_free = [&](const Found* each) {
            return is_left(*each) || (may_be_of(each->question, item) && !each->in_right_answer && !each->is_aside);
        };
        const auto is_plain = [](const Found* each) {
            return each->number.value == 0 || std::abs(each->number.value) == 1;
        };
        if (std::all_of(found.begin(), found.end(), is_plain) || std::none_of(found.begin(), found.end(), is_free))
            return false;
        if (is_said_which(item, found)) return false;
        MatchedItem read{item.spec, PrintedValue(), MatrixOrder::unsaid, {}, false, {}};
        for (const Found* each : found) read.value->numbers.push_back(each->number);
        const reference::KeyItem& key = key_item(item.spec);
        return std::any_of(key.answers.begin(), key.answers.end(), [&](const reference::Answer& answer) {
            const Target target = target_with_allowance(key, answer, rubric_);
            return !target.no_value && compare(read, target, 0, rubric_.min_decimals).within;
        });
    }

    /// A line of words that were not understood, where the item would stand. Empty also where the answer is no words.
    int line_of_words(const ItemScore& item) const {
        const bool is_verdict = item.spec.shape == Shape::verdict;
        const bool is_guess = item.verdict == ItemVerdict::wrong && is_read_by_order(item);
        if ((item.verdict != ItemVerdict::missing && !is_guess) || (!is_verdict && !is_of_hit(item.spec))) return 0;
        const auto [first, last] = lines_of(item);
        std::optional<std::pair<int, int>> best;  // its rank, and the line
        for (const Section& section : transcript_.sections) {
            const bool is_elsewhere = section.question != 0 && section.question != item.spec.question;
            if (!may_be_of(section.question, item) || (is_elsewhere && !may_be_in_words(item))) continue;
            for (const PrintedLine& line : std::span(section.lines).first(std::min(section.lines.size(), most_lines))) {
                if (!has_unread_words(section, line, item)) continue;
                const bool is_outside = line.number <= first || line.number >= last;
                if (is_outside && (is_guess || !may_be_in_words(item))) continue;
                const bool is_title = section.question != 0 && &line == &section.lines.front();
                const int rank = (is_outside ? 4 : 0) + (tells_of_hits(line.text) ? 0 : 2) + (is_title ? 1 : 0);
                if (!best || rank < best->first) best = {rank, line.number};
            }
        }
        return best ? best->second : 0;
    }

    /// Whether the right answer is in words.
    bool may_be_in_words(const ItemScore& item) const {
        const reference::KeyItem& key = key_item(item.spec);
        return item.spec.shape == Shape::verdict ||
               std::any_of(key.answers.begin(), key.answers.end(), [&](const reference::Answer& answer) {
                   return target_with_allowance(key, answer, rubric_).no_value;
               });
    }

    /// Whether only its place told that what was read is the item.
    bool is_read_by_order(const ItemScore& item) const {
        const auto own =
            std::ranges::find_if(matched_, [&](const MatchedItem& each) { return each.spec.id == item.spec.id; });
        if (own == matched_.end() || !own->value) return false;
        std::vector<reference::ItemSpec> asked;
        for (const MatchedItem& each : matched_) asked.push_back(each.spec);
        return fit_value(*own->value, item.spec, asked) <= LabelFit::none;
    }

    /// The lines between which the item would stand: those of the answers read before and after it.
    std::pair<int, int> lines_of(const ItemScore& item) const {
        int first = 0, last = std::numeric_limits<int>::max();
        bool is_before = true;
        for (const QuestionScore& question : score_.questions) {
            for (const ItemScore& other : question.items) {
                if (other.spec.id == item.spec.id) {
                    is_before = false;
                    if (item.line != 0) last = item.line;
                } else if (other.line != 0 && is_before) {
                    first = std::max(first, other.last_line);
                } else if (other.line > first) {
                    last = std::min(last, other.line);
                }
            }
        }
        return {first, last};
    }

    /// Whether the line has words that are no value and no answer to what is hit first. Such an answer is no title of
    /// the value below it, and may hold numbers.
    bool has_unread_words(const Section& section, const PrintedLine& line, const ItemScore& item) const {
        if (is_read_verdict(line.number) || says_not_answered(line.text)) return false;
        const bool is_verdict = item.spec.shape == Shape::verdict;
        if (is_verdict && section.question == item.spec.question && tells_of_hits(line.text)) return true;
        const bool is_read = std::ranges::any_of(section.values, [&](const PrintedValue& value) {
            const bool is_titled = !is_verdict && value.label.empty() && !value.above.empty();
            return (value.line <= line.number && line.number <= value.last_line) ||
                   (is_titled && line.number < value.line && line.text.starts_with(value.above));
        });
        return std::ranges::any_of(line.text, is_letter) && !is_read;
    }

    /// Whether a word is one that tells of hits, in a language that is read.
    static bool tells_of_hits(std::string_view line) {
        return std::ranges::any_of(hit_words(line), [](const HitWord& word) {
            return object_of(word.meaning) || negates(word.meaning) || word.meaning == Meaning::hit ||
                   word.meaning == Meaning::miss || word.meaning == Meaning::first || word.meaning == Meaning::nearest;
        });
    }

    /// Whether the answer to what is hit first was read from this line.
    bool is_read_verdict(int line) const {
        return std::any_of(matched_.begin(), matched_.end(),
                           [&](const MatchedItem& each) { return each.verdict && each.verdict->line == line; });
    }

    /// The first line of another printing of the item's question, which has as many values; 0 if there is none.
    /// Sections of one question that follow one another, such as 8 a) and 8 b), are one printing.
    int line_printed_again(const ItemScore& item) const {
        std::vector<Printing> printings;
        const Section* before = nullptr;
        for (const Section& section : transcript_.sections) {
            if (section.question != item.spec.question || section.values.empty()) continue;
            if (before == nullptr || before + 1 != &section) printings.push_back({section.values.front().line, 0, 0});
            printings.back().last_line = section.values.back().last_line;
            printings.back().values += section.values.size();
            before = &section;
        }
        const auto read = std::find_if(printings.begin(), printings.end(), [&](const Printing& each) {
            return each.first_line <= item.line && item.line <= each.last_line;
        });
        for (const Printing& each : printings) {
            const bool is_as_long = read == printings.end() || each.values >= read->values;
            if (printings.size() > 1 && (read == printings.end() || &each != &*read) && is_as_long)
                return each.first_line;
        }
        return 0;
    }

    const Transcript& transcript_;
    const std::vector<MatchedItem>& matched_;
    const reference::AnswerKey& key_;
    const reference::Rubric& rubric_;
    Score& score_;
    std::vector<Found> numbers_;
    std::set<int> equations_;       ///< the lines with a number directly behind "=" or ":"
    std::set<int> headings_;        ///< the questions that have one
    std::vector<double> answered_;  ///< sorted
};

}  // namespace

void doubt_readings(Score& score, const Transcript& transcript, const std::vector<MatchedItem>& matched,
                    const reference::AnswerKey& key, const reference::Assignment& assignment) {
    const bool all_right =
        std::all_of(score.questions.begin(), score.questions.end(),
                    [](const QuestionScore& question) { return question.verdict == ItemVerdict::right; });
    if (all_right || transcript.sections.empty()) return;
    Doubter(score, transcript, matched, key, assignment).run();
}

}  // namespace harness
