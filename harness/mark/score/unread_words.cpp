#include "harness/mark/score/unread_words.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include "harness/match/question_match.h"
#include "harness/read/no_value.h"
#include "harness/read/words/hit_words.h"

namespace harness {
namespace {

using reference::Shape;

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

}  // namespace

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

}  // namespace harness
