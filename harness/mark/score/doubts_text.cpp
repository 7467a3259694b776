#include "harness/mark/score/doubts_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "harness/text/listed.h"

namespace harness {
namespace {

/// What else was read from the line where the right value stands: ", read as 6.t".
std::string read_there(const Score& score, const ItemScore& doubted) {
    constexpr std::size_t most = 3;
    std::vector<std::string> others;
    bool is_its_own = false;
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items) {
            if (item.line > doubted.doubt->line || doubted.doubt->line > item.last_line) continue;
            if (item.spec.id == doubted.spec.id) {
                is_its_own = true;
            } else {
                others.push_back(fmt::format("{}.{}", question.number, item.spec.name));
            }
        }
    }
    if (is_its_own) return ", beside what was read for it";
    if (others.empty()) return ", read as no answer";
    return ", read as " + (others.size() <= most ? listed(others) : fmt::format("{} other answers", others.size()));
}

std::string phrase_of(const Score& score, const ItemScore& item, const Doubt& doubt, Audience audience) {
    const bool may_tell = audience == Audience::instructor;
    switch (doubt.why) {
        case Doubt::Why::right_elsewhere:
            return fmt::format("the right value {} on line {}{}",
                               item.spec.shape == reference::Shape::scalar ? "stands" : "begins", doubt.line,
                               read_there(score, item));
        case Doubt::Why::numbers_left:
            return may_tell ? fmt::format("line {} has numbers that were used for no answer", doubt.line)
                            : fmt::format("line {} may have been meant", doubt.line);
        case Doubt::Why::words_left: return fmt::format("line {} has words that were not understood", doubt.line);
        case Doubt::Why::printed_again:
            return fmt::format("the question was printed more than once, also on line {}", doubt.line);
        case Doubt::Why::another_answer:
            return fmt::format("line {} offers another answer, or withdraws it", doubt.line);
        case Doubt::Why::little_read: return "less than half of the answers were found";
        case Doubt::Why::by_columns: {
            const std::string text = fmt::format("the matrix on line {} may have been printed by {}", doubt.line,
                                                 item.by_columns ? "rows" : "columns");
            return may_tell ? text + ": read so, it suits the other answers" : text;
        }
    }
    return "";
}

}  // namespace

std::string doubts_text(const Score& score, Audience audience) {
    std::vector<std::pair<std::string, std::string>> items_by_phrase;
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items) {
            const std::optional<Doubt>& doubt = audience == Audience::instructor ? item.doubt : told_doubt(item);
            if (!doubt) continue;
            const std::string phrase = phrase_of(score, item, *doubt, audience);
            const std::string name = fmt::format("{}.{}", question.number, item.spec.name);
            const auto found = std::find_if(items_by_phrase.begin(), items_by_phrase.end(),
                                            [&](const auto& each) { return each.second == phrase; });
            if (found == items_by_phrase.end()) {
                items_by_phrase.emplace_back(name, phrase);
            } else {
                found->first += ", " + name;
            }
        }
    }
    std::string text;
    for (const auto& [items, phrase] : items_by_phrase) text += (text.empty() ? "" : "; ") + items + ": " + phrase;
    return text;
}

}  // namespace harness
