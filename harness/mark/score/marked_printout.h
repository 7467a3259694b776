// What doubts are decided on: a printout, what was read from it, and how that was marked.
#pragma once

#include <set>
#include <vector>

#include "harness/mark/score/score.h"
#include "harness/match/matched_item.h"
#include "harness/read/transcript.h"
#include "reference/key/answer_key.h"

namespace harness {

struct MarkedPrintout {
    MarkedPrintout(const Transcript& printed, const std::vector<MatchedItem>& read, const reference::AnswerKey& right,
                   const reference::Rubric& points, const Score& marked);

    const Transcript& transcript;
    const std::vector<MatchedItem>& matched;
    const reference::AnswerKey& key;
    const reference::Rubric& rubric;
    const Score& score;
    std::set<int> headings;  ///< the questions that have one

    /// Whether what stands under this heading may be meant for the item: under the heading of its question, or, if
    /// there is none, under any.
    bool may_be_of(int question, const ItemScore& item) const {
        return question == item.spec.question || !headings.contains(item.spec.question);
    }
    ItemVerdict verdict_of(const reference::ItemId& id) const;
    const reference::KeyItem& key_item(const reference::ItemSpec& spec) const;
    /// What was matched to the item; null if the assignment has no such item.
    const MatchedItem* matched_to(const reference::ItemId& id) const;
};

}  // namespace harness
