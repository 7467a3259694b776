#include "harness/mark/score/doubts_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "harness/text/listed.h"

namespace harness {
namespace {

/// What else was read from the line with the right value: ", read as question 6 (t)".
std::string read_there(const Score& score, const ItemScore& doubted) {
    constexpr std::size_t most = 3;
    std::vector<std::pair<int, std::string>> others;
    bool is_its_own = false;
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items) {
            if (item.line > doubted.doubt->line || doubted.doubt->line > item.last_line) continue;
            if (item.spec.id == doubted.spec.id) {
                is_its_own = true;
            } else {
                others.emplace_back(question.number, item.spec.name);
            }
        }
    }
    if (is_its_own) return ", next to the number that was read";
    if (others.empty()) return ", not read as any answer";
    return ", read as " +
           (others.size() <= most ? items_in_words(others) : fmt::format("{} other answers", others.size()));
}

std::string phrase_of(const Score& score, const ItemScore& item, const Doubt& doubt, Audience audience) {
    const bool may_tell = audience == Audience::instructor;
    switch (doubt.why) {
        case Doubt::Why::right_elsewhere:
            return fmt::format("the right value {} on line {}{}",
                               item.spec.shape == reference::Shape::scalar ? "is" : "begins", doubt.line,
                               read_there(score, item));
        case Doubt::Why::numbers_left:
            return may_tell ? fmt::format("line {} has numbers that were not used for any answer", doubt.line)
                            : fmt::format("the answer may be on line {}", doubt.line);
        case Doubt::Why::words_left: return fmt::format("line {} has words that were not understood", doubt.line);
        case Doubt::Why::printed_again:
            return fmt::format("the question was printed more than once, also on line {}", doubt.line);
        case Doubt::Why::another_answer:
            return fmt::format("line {} gives another answer or takes this one back", doubt.line);
        case Doubt::Why::little_read: return "fewer than half of the answers were found";
        case Doubt::Why::by_order:
            return fmt::format("line {} has no label for this answer; the value was matched by its order", doubt.line);
        case Doubt::Why::by_columns:
            return fmt::format("the rows of the matrix on line {} may be its columns{}", doubt.line,
                               may_tell ? " (read that way, other answers fit)" : "");
    }
    return "";
}

}  // namespace

std::string_view name_in_words(std::string_view item) {
    return item == reference::item::first_object.name ? "which object is hit first" : item;
}

std::string items_in_words(const std::vector<std::pair<int, std::string>>& items) {
    std::map<int, std::string> names;
    for (const auto& [question, item] : items) {
        std::string& list = names[question];
        list += fmt::format("{}{}", list.empty() ? "" : ", ", name_in_words(item));
    }
    std::vector<std::string> questions;
    for (const auto& [question, list] : names) questions.push_back(fmt::format("question {} ({})", question, list));
    return listed(questions);
}

std::string doubts_text(const Score& score, Audience audience) {
    using Items = std::vector<std::pair<int, std::string>>;
    std::vector<std::pair<Items, std::string>> items_by_phrase;
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items) {
            const std::optional<Doubt>& doubt = audience == Audience::instructor ? item.doubt : told_doubt(item);
            if (!doubt) continue;
            const std::string phrase = phrase_of(score, item, *doubt, audience);
            auto found = std::find_if(items_by_phrase.begin(), items_by_phrase.end(),
                                      [&](const auto& each) { return each.second == phrase; });
            if (found == items_by_phrase.end()) {
                items_by_phrase.emplace_back(Items(), phrase);
                found = items_by_phrase.end() - 1;
            }
            found->first.emplace_back(question.number, item.spec.name);
        }
    }
    std::string text;
    for (const auto& [items, phrase] : items_by_phrase)
        text += (text.empty() ? "" : "; ") + items_in_words(items) + ": " + phrase;
    return text;
}

}  // namespace harness
