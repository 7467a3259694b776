#include "harness/grade/repetition.h"

#include <fmt/format.h>

namespace harness {
namespace {

std::string printed(const ItemScore& item) {
    return item.printed.empty() ? "nothing" : item.printed;
}

std::optional<std::string> difference(const Score& first, const Score& later, std::size_t number) {
    for (std::size_t q = 0; q < first.questions.size(); ++q) {
        const QuestionScore& question = first.questions[q];
        for (std::size_t i = 0; i < question.items.size(); ++i) {
            const ItemScore& item = question.items[i];
            const ItemScore& other = later.questions.at(q).items.at(i);
            if (item.printed == other.printed) continue;
            return fmt::format("Question {}, {}: run 1 printed {}, run {} printed {}.", question.number, item.spec.name,
                               printed(item), number, printed(other));
        }
    }
    return {};
}

}  // namespace

std::optional<std::string> difference(const std::vector<Repetition>& runs) {
    for (std::size_t i = 1; i < runs.size(); ++i) {
        if (auto found = difference(runs.front().score, runs[i].score, i + 1)) return found;
        if (runs[i].ended != runs.front().ended) return fmt::format("Run {} ended differently from run 1.", i + 1);
    }
    return {};
}

}  // namespace harness
