#include "harness/mark/score/unread_words.h"

#include <algorithm>
#include <span>

#include "harness/match/question_match.h"
#include "harness/read/no_value.h"
#include "harness/read/words/hit_words.h"

namespace harness {
namespace {

/// As many lines of words are looked at.
constexpr std::size_t most_lines = 500;

bool tells_of_hits(std::string_view line) {
    return std::ranges::any_of(hit_words(line), [](const HitWord& word) {
        return object_of(word.meaning) || negates(word.meaning) || word.meaning == Meaning::hit ||
               word.meaning == Meaning::miss || word.meaning == Meaning::first || word.meaning == Meaning::nearest;
    });
}

/// Whether a value, its title or the answer to what is hit first was read from this line.
bool is_read(const MarkedPrintout& printout, const Section& section, const PrintedLine& line) {
    return std::ranges::any_of(section.values,
                               [&](const PrintedValue& value) {
                                   const bool is_title = value.label.empty() && !value.above.empty() &&
                                                         line.number < value.line && line.text.starts_with(value.above);
                                   return is_title || (value.line <= line.number && line.number <= value.last_line);
                               }) ||
           std::ranges::any_of(printout.matched, [&](const MatchedItem& item) {
               return item.first_object && item.first_object->line == line.number;
           });
}

}  // namespace

int line_of_unread_words(const MarkedPrintout& printout, const ItemScore& item) {
    const bool is_verdict = item.spec.shape == reference::Shape::first_object;
    if (item.verdict != ItemVerdict::missing || (!is_verdict && !is_of_hit(item.spec))) return 0;
    int found = 0;
    for (const Section& section : printout.transcript.sections) {
        if (!printout.may_be_of(section.question, item)) continue;
        const auto lines = std::span(section.lines).first(std::min(section.lines.size(), most_lines));
        for (const PrintedLine& line : lines) {
            const bool has_words = std::ranges::any_of(line.text, is_letter) && !says_not_answered(line.text);
            if (!has_words || is_read(printout, section, line)) continue;
            if (tells_of_hits(line.text)) return line.number;
            const bool is_title = section.question != 0 && &line == lines.data();
            if (found == 0 && !is_title) found = line.number;
        }
    }
    return found;
}

}  // namespace harness
