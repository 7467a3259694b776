#include "harness/mark/score/marked_printout.h"

#include <algorithm>

namespace harness {

MarkedPrintout::MarkedPrintout(const Transcript& printed, const std::vector<MatchedItem>& read,
                               const reference::AnswerKey& right, const reference::Rubric& points, const Score& marked)
    : transcript(printed), matched(read), key(right), rubric(points), score(marked) {
    for (const Section& section : transcript.sections) headings.insert(section.question);
}

ItemVerdict MarkedPrintout::verdict_of(const reference::ItemId& id) const {
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items) {
            if (item.spec.id == id) return item.verdict;
        }
    }
    return ItemVerdict::missing;
}

const reference::KeyItem& MarkedPrintout::key_item(const reference::ItemSpec& spec) const {
    const reference::KeyItem* item = reference::asked_item(key, spec.id);
    return item == nullptr ? key.questions.front().items.front() : *item;
}

const MatchedItem* MarkedPrintout::matched_to(const reference::ItemId& id) const {
    const auto own = std::ranges::find_if(matched, [&](const MatchedItem& item) { return item.spec.id == id; });
    return own == matched.end() ? nullptr : &*own;
}

}  // namespace harness
