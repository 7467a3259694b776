#include "harness/mark/score/doubt.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "harness/mark/compare/key_targets.h"
#include "harness/mark/score/listed_numbers.h"
#include "harness/match/question_match.h"
#include "harness/read/no_value.h"
#include "harness/read/words/hit_words.h"

namespace harness {
namespace {

using reference::Shape;

std::size_t numbers_in(Shape shape) {
    return static_cast<std::size_t>(reference::component_count(shape));
}

/// Whether a vector was read with a fourth number that cannot be its w, which is 0 or 1.
bool has_a_number_too_many(const ItemScore& item, const MatchedItem* own) {
    if (item.spec.shape != Shape::vector || own == nullptr || !own->value) return false;
    const auto& numbers = own->value->numbers;
    return numbers.size() == 4 && numbers.back().value != 0 && numbers.back().value != 1;
}

/// At most this many lines of words are examined.
constexpr std::size_t most_lines = 500;

/// The lines between which the item would be: those of the answers read before and after it.
std::pair<int, int> lines_of(const MarkedPrintout& printout, const ItemScore& item) {
    int first = 0, last = std::numeric_limits<int>::max();
    bool is_before = true;
    for (const QuestionScore& question : printout.score.questions) {
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

/// Whether the line has a word about hits, in a supported language.
bool tells_of_hits(std::string_view line) {
    return std::ranges::any_of(hit_words(line), [](const HitWord& word) {
        return object_of(word.meaning) || negates(word.meaning) || word.meaning == Meaning::hit ||
               word.meaning == Meaning::miss || word.meaning == Meaning::first || word.meaning == Meaning::nearest;
    });
}

/// Whether the answer to the first object was read from this line.
bool is_read_as_first_object(const MarkedPrintout& printout, int line) {
    return std::any_of(printout.matched.begin(), printout.matched.end(),
                       [&](const MatchedItem& item) { return item.first_object && item.first_object->line == line; });
}

/// Whether the line has words that belong neither to a value nor to the answer about the first object. Such an answer
/// is not a title of the value below it, and may contain numbers.
bool has_unread_words(const MarkedPrintout& printout, const Section& section, const PrintedLine& line,
                      const ItemScore& item) {
    if (is_read_as_first_object(printout, line.number) || says_not_answered(line.text)) return false;
    const bool is_verdict = item.spec.shape == Shape::first_object;
    if (is_verdict && section.question == item.spec.question && tells_of_hits(line.text)) return true;
    const bool is_read = std::ranges::any_of(section.values, [&](const PrintedValue& value) {
        const bool is_titled = !is_verdict && value.label.empty() && !value.above.empty();
        return (value.line <= line.number && line.number <= value.last_line) ||
               (is_titled && line.number < value.line && line.text.starts_with(value.above));
    });
    return std::ranges::any_of(line.text, is_letter) && !is_read;
}

/// A line with words that were not understood, in the place where the item's answer is expected. 0 if there is none or
/// if the item's answer does not consist of words.
int line_of_unread_words(const MarkedPrintout& printout, const ItemScore& item) {
    const bool is_verdict = item.spec.shape == Shape::first_object;
    const MatchedItem* own = printout.matched_to(item.spec.id);
    const bool is_guess = item.verdict == ItemVerdict::wrong && own != nullptr && own->by_order;
    if ((item.verdict != ItemVerdict::missing && !is_guess) || (!is_verdict && !is_of_hit(item.spec))) return 0;
    const auto [first, last] = lines_of(printout, item);
    int found = 0, outside = 0;
    for (const Section& section : printout.transcript.sections) {
        const bool is_elsewhere = section.question != 0 && section.question != item.spec.question;
        if ((is_elsewhere && !is_verdict) || !printout.may_be_of(section.question, item)) continue;
        for (const PrintedLine& line : std::span(section.lines).first(std::min(section.lines.size(), most_lines))) {
            if (!has_unread_words(printout, section, line, item)) continue;
            const bool tells = tells_of_hits(line.text);
            if (line.number <= first || line.number >= last) {
                if (is_verdict && tells && outside == 0) outside = line.number;
            } else if (tells) {
                return line.number;
            } else if (found == 0) {
                found = line.number;
            }
        }
    }
    return found != 0 ? found : outside;
}

class Doubter {
  public:
    Doubter(Score& score, const Transcript& transcript, const std::vector<MatchedItem>& matched,
            const reference::AnswerKey& key, const reference::Assignment& assignment)
        : score_(score), printout_(transcript, matched, key, assignment.rubric, score), listed_(printout_) {}

    void run() {
        const bool little_read = is_little_read();
        for (QuestionScore& question : score_.questions) {
            for (ItemScore& item : question.items) {
                if (item.verdict == ItemVerdict::right || item.doubt || is_settled(item)) continue;
                item.doubt = doubt_of_layout(item, little_read);
                const int line = line_of_right_value(item);
                if (line == 0) continue;
                item.layout_doubt = item.doubt;
                item.doubt = Doubt{Doubt::Why::right_elsewhere, line};
            }
        }
    }

  private:
    bool is_little_read() const {
        const auto read = std::count_if(
            printout_.matched.begin(), printout_.matched.end(),
            [](const MatchedItem& item) { return (item.value && !item.unreadable) || item.first_object; });
        const bool printed = std::any_of(printout_.transcript.sections.begin(), printout_.transcript.sections.end(),
                                         [](const Section& section) { return !section.values.empty(); });
        const auto left = std::count_if(listed_.all().begin(), listed_.all().end(),
                                        [](const ListedNumber& listed_number) { return listed_number.is_left(); });
        return printed && left >= 3 && 2 * static_cast<std::size_t>(read) < printout_.matched.size();
    }

    /// The doubt that the printout raises whatever the key is.
    std::optional<Doubt> doubt_of_layout(const ItemScore& item, bool little_read) const {
        // What follows and has all its points could gain nothing: unless the right value is there, it was meant.
        if (item.verdict == ItemVerdict::follow && item.points >= item.max_points) return std::nullopt;
        const MatchedItem* own = printout_.matched_to(item.spec.id);
        if (own != nullptr && own->again_line != 0) return Doubt{Doubt::Why::printed_again, own->again_line};
        // Where an item is missing, numbers that an answer has too may be it: a matrix repeats the axes.
        const bool is_wrong = item.verdict == ItemVerdict::wrong || item.verdict == ItemVerdict::follow;
        const bool is_meant = is_wrong && own != nullptr && !own->by_order;
        const auto left = [&](const ListedNumber& found) {
            const bool on_its_line = item.line <= found.line && found.line <= item.last_line;
            return found.is_left() &&
                   (on_its_line || (printout_.may_be_of(found.question, item) && !(is_meant && found.repeats)));
        };
        const auto count = static_cast<std::size_t>(std::count_if(listed_.all().begin(), listed_.all().end(), left));
        constexpr std::size_t row = 3;  // a row of a matrix may be left alone
        if (count > 0 && count >= std::min(row, numbers_in(item.spec.shape)) && item.spec.shape != Shape::first_object)
            return Doubt{Doubt::Why::numbers_left,
                         std::find_if(listed_.all().begin(), listed_.all().end(), left)->line};
        if (is_wrong && has_a_number_too_many(item, own)) return Doubt{Doubt::Why::numbers_left, item.line};
        if (is_wrong && has_loose_sign(*own)) return Doubt{Doubt::Why::numbers_left, item.line};
        if (is_wrong && own->by_order && is_one_of_several(item) && !item.no_value)
            return Doubt{Doubt::Why::by_order, item.line};
        if (const int line = line_of_unread_words(printout_, item); line != 0)
            return Doubt{Doubt::Why::words_left, line};
        if (little_read && item.verdict != ItemVerdict::follow) return Doubt{Doubt::Why::little_read, 0};
        return std::nullopt;
    }

    /// Whether its question asks for several items of this shape, so that order alone may take one for another.
    bool is_one_of_several(const ItemScore& item) const {
        const auto question = std::ranges::find(score_.questions, item.spec.question, &QuestionScore::number);
        return std::ranges::count(question->items, item.spec.shape,
                                  [](const ItemScore& other) { return other.spec.shape; }) > 1;
    }

    /// Whether a minus sign before one of its numbers was not read: "-'6.7'".
    bool has_loose_sign(const MatchedItem& own) const {
        return std::ranges::any_of(listed_.all(), [&](const ListedNumber& number) {
            return number.has_loose_sign && was_read_from(own, number);
        });
    }

    /// The line where a value begins that is right for the item and was not read for it; 0 if there is none.
    int line_of_right_value(const ItemScore& item) const {
        const std::size_t size = numbers_in(item.spec.shape);
        if (size == 0) return 0;
        // A vector may also be a column of a block with three or four columns.
        for (const std::size_t stride : {std::size_t{1}, std::size_t{3}, std::size_t{4}}) {
            if (stride > 1 && size != 3) break;
            for (std::size_t i = 0; i + (size - 1) * stride < listed_.all().size(); ++i) {
                if (is_right_value(item, i, stride)) return listed_.all()[i].line;
            }
        }
        return 0;
    }

    /// Whether these numbers are no doubt of the item: it was read from all of them, and so they were judged; or their
    /// labels name others and its own label names it, as where u and v are swapped.
    bool is_said_which(const ItemScore& item, const std::vector<const ListedNumber*>& numbers) const {
        const MatchedItem* own = printout_.matched_to(item.spec.id);
        if (own == nullptr) return false;
        const bool are_of_others = std::ranges::all_of(numbers, [&](const ListedNumber* listed_number) {
            return listed_number->named != nullptr && !names(*listed_number->named, item.spec) &&
                   !names(*own, listed_number->named->spec);
        });
        return (are_of_others && names(*own, item.spec)) ||
               std::ranges::all_of(numbers, [&](const ListedNumber* each) { return was_read_from(*own, *each); });
    }

    /// Whether the numbers from `first` on, a stride apart, are right for the item and no right answer's. A single
    /// number must stand in the item's question and have three digits, or stand on the item's line: others are right by
    /// chance too often.
    bool is_right_value(const ItemScore& item, std::size_t first, std::size_t stride) const {
        if (!listed_.is_one_value(first, numbers_in(item.spec.shape), stride)) return false;
        std::vector<const ListedNumber*> found;
        for (std::size_t k = 0; k < numbers_in(item.spec.shape); ++k)
            found.push_back(&listed_.all()[first + k * stride]);
        // Lines such as "t = 2 u = 0.25 v = 0.25" are no rows of a block.
        if (stride > 1 && std::any_of(found.begin(), found.end(),
                                      [](const ListedNumber* listed_number) { return listed_number->is_scalar; }))
            return false;
        const bool is_own = printout_.may_be_of(found.front()->question, item);
        const bool on_its_line = item.line <= found.front()->line && found.front()->line <= item.last_line;
        if (found.size() == 1 && (!is_own || (!on_its_line && found.front()->number.significant < 3))) return false;
        const auto is_free = [&](const ListedNumber* each) {
            return each->is_left() ||
                   (printout_.may_be_of(each->question, item) && !each->in_right_answer && !each->is_aside);
        };
        const auto is_plain = [](const ListedNumber* each) {
            return each->number.value == 0 || std::abs(each->number.value) == 1;
        };
        if (std::all_of(found.begin(), found.end(), is_plain) || std::none_of(found.begin(), found.end(), is_free))
            return false;
        if (is_said_which(item, found)) return false;
        MatchedItem read{item.spec, PrintedValue()};
        for (const ListedNumber* each : found) read.value->numbers.push_back(each->number);
        const reference::KeyItem& key = printout_.key_item(item.spec);
        return std::any_of(key.answers.begin(), key.answers.end(), [&](const reference::Answer& answer) {
            const Target target = target_with_allowance(key, answer, printout_.rubric);
            return !target.no_value && compare(read, target, 0, printout_.rubric.min_decimals).within;
        });
    }

    Score& score_;
    const MarkedPrintout printout_;
    const ListedNumbers listed_;
};

}  // namespace

void doubt_readings(Score& score, const Transcript& transcript, const std::vector<MatchedItem>& matched,
                    const reference::AnswerKey& key, const reference::Assignment& assignment) {
    if (transcript.sections.empty()) return;
    const bool all_right =
        std::all_of(score.questions.begin(), score.questions.end(),
                    [](const QuestionScore& question) { return question.verdict == ItemVerdict::right; });
    if (all_right) return;
    Doubter(score, transcript, matched, key, assignment).run();
}

}  // namespace harness
