#include "harness/report/text/verdict_words.h"

#include <algorithm>

namespace harness::report {

std::string_view word_of(ItemVerdict verdict) {
    return verdict == ItemVerdict::follow ? "consistent" : to_string(verdict);
}

std::string word_of(const QuestionScore& question) {
    const bool all_unreadable = std::all_of(question.items.begin(), question.items.end(), [](const ItemScore& item) {
        return item.verdict == ItemVerdict::unreadable;
    });
    return std::string(all_unreadable ? word_of(ItemVerdict::unreadable) : word_of(question.verdict));
}

std::string outcome_words(Outcome outcome) {
    if (outcome == Outcome::graded) return "finished";
    std::string words(to_string(outcome));
    std::ranges::replace(words, '_', ' ');
    return words;
}

std::string_view symbol_of(const QuestionScore& question) {
    switch (question.verdict) {
        case ItemVerdict::right: return "✓";
        case ItemVerdict::follow: return "↳";
        case ItemVerdict::missing: return "–";
        case ItemVerdict::wrong:
        case ItemVerdict::unreadable: return "✗";
    }
    return "";
}

std::string_view class_of(const QuestionScore& question) {
    return question.verdict == ItemVerdict::unreadable ? "wrong" : to_string(question.verdict);
}

}  // namespace harness::report
