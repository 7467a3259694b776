#include "harness/mark/score/score.h"

namespace harness {

std::string_view to_string(ItemVerdict verdict) {
    switch (verdict) {
        case ItemVerdict::right: return "right";
        case ItemVerdict::follow: return "follow";
        case ItemVerdict::wrong: return "wrong";
        case ItemVerdict::missing: return "missing";
        case ItemVerdict::unreadable: return "unreadable";
    }
    return "";
}

std::string_view to_string(Doubt::Why why) {
    switch (why) {
        case Doubt::Why::right_elsewhere: return "right_elsewhere";
        case Doubt::Why::numbers_left: return "numbers_left";
        case Doubt::Why::words_left: return "words_left";
        case Doubt::Why::printed_again: return "printed_again";
        case Doubt::Why::little_read: return "little_read";
        case Doubt::Why::another_answer: return "another_answer";
        case Doubt::Why::by_order: return "by_order";
        case Doubt::Why::by_columns: return "by_columns";
    }
    return "";
}

std::pair<std::string, std::string> in_words(const std::vector<std::pair<std::string, std::string>>& mistakes) {
    std::pair<std::string, std::string> words;
    for (const auto& [name, advice] : mistakes) {
        words.first += (words.first.empty() ? "" : " or ") + name;
        words.second += (words.second.empty() ? "" : " Or: ") + advice;
    }
    return words;
}

bool is_settled(const ItemScore& item) {
    return !item.reread.empty() || !item.experiment.empty();
}

const std::optional<Doubt>& told_doubt(const ItemScore& item) {
    const bool is_by_key = item.doubt && item.doubt->why == Doubt::Why::right_elsewhere;
    return is_by_key ? item.layout_doubt : item.doubt;
}

std::vector<reference::ItemSpec> asked_items(const Score& score) {
    std::vector<reference::ItemSpec> items;
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items) items.push_back(item.spec);
    }
    return items;
}

int last_question(const Score& score) {
    return score.questions.empty() ? 0 : score.questions.back().number;
}

}  // namespace harness
