#include "harness/mark/score/unread_words.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "harness/mark/compare/key_targets.h"
#include "harness/match/question_match.h"
#include "harness/read/no_value.h"
#include "harness/read/words/hit_words.h"

namespace harness {
namespace {

using reference::Shape;

/// As many lines of words are looked at.
constexpr std::size_t most_lines = 500;

/// Whether the right answer is in words.
bool may_be_in_words(const MarkedPrintout& printout, const ItemScore& item) {
    const reference::KeyItem& key = printout.key_item(item.spec);
    return item.spec.shape == Shape::first_object ||
           std::any_of(key.answers.begin(), key.answers.end(), [&](const reference::Answer& answer) {
               return target_with_allowance(key, answer, printout.rubric).no_value;
           });
}

/// Whether only its place told that what was read is the item.
bool is_read_by_order(const MarkedPrintout& printout, const ItemScore& item) {
    const MatchedItem* own = printout.matched_to(item.spec.id);
    if (own == nullptr || !own->value) return false;
    std::vector<reference::ItemSpec> asked;
    for (const MatchedItem& scored : printout.matched) asked.push_back(scored.spec);
    return fit_value(*own->value, item.spec, asked) <= LabelFit::none;
}

/// The lines between which the item would stand: those of the answers read before and after it.
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

/// Whether a word is one that tells of hits, in a language that is read.
bool tells_of_hits(std::string_view line) {
    return std::ranges::any_of(hit_words(line), [](const HitWord& word) {
        return object_of(word.meaning) || negates(word.meaning) || word.meaning == Meaning::hit ||
               word.meaning == Meaning::miss || word.meaning == Meaning::first || word.meaning == Meaning::nearest;
    });
}

/// Whether the answer to what is hit first was read from this line.
bool is_read_as_first_object(const MarkedPrintout& printout, int line) {
    return std::any_of(printout.matched.begin(), printout.matched.end(),
                       [&](const MatchedItem& item) { return item.first_object && item.first_object->line == line; });
}

/// Whether the line has words that are no value and no answer to what is hit first. Such an answer is no title of
/// the value below it, and may hold numbers.
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

}  // namespace

int line_of_unread_words(const MarkedPrintout& printout, const ItemScore& item) {
    const bool is_verdict = item.spec.shape == Shape::first_object;
    const bool is_guess = item.verdict == ItemVerdict::wrong && is_read_by_order(printout, item);
    if ((item.verdict != ItemVerdict::missing && !is_guess) || (!is_verdict && !is_of_hit(item.spec))) return 0;
    const auto [first, last] = lines_of(printout, item);
    std::optional<std::pair<int, int>> best;  // its rank, and the line
    for (const Section& section : printout.transcript.sections) {
        const bool is_elsewhere = section.question != 0 && section.question != item.spec.question;
        if (!printout.may_be_of(section.question, item) || (is_elsewhere && !may_be_in_words(printout, item))) continue;
        for (const PrintedLine& line : std::span(section.lines).first(std::min(section.lines.size(), most_lines))) {
            if (!has_unread_words(printout, section, line, item)) continue;
            const bool is_outside = line.number <= first || line.number >= last;
            if (is_outside && (is_guess || !may_be_in_words(printout, item))) continue;
            const bool is_title = section.question != 0 && &line == &section.lines.front();
            const int rank = (is_outside ? 4 : 0) + (tells_of_hits(line.text) ? 0 : 2) + (is_title ? 1 : 0);
            if (!best || rank < best->first) best = {rank, line.number};
        }
    }
    return best ? best->second : 0;
}

}  // namespace harness
