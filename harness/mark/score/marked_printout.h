// The input for finding doubts: a printout, the answers read from it, and their score.
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
    std::set<int> headings;  ///< the questions that have a heading

    /// Whether text under this question's heading may be meant for the item. It may under the heading of the item's
    /// question or, if that question has no heading, under any.
    bool may_be_of(int question, const ItemScore& item) const {
        return question == item.spec.question || !headings.contains(item.spec.question);
    }
    ItemVerdict verdict_of(const reference::ItemId& id) const;
    const reference::KeyItem& key_item(const reference::ItemSpec& spec) const;
    /// The matched item; null if the assignment has no such item.
    const MatchedItem* matched_to(const reference::ItemId& id) const;
};

}  // namespace harness
