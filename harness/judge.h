// The verdict on each item, before points.
#pragma once

#include <vector>

#include "harness/follow.h"
#include "harness/score.h"

namespace harness {

/// Judges items one by one in the handout's order; later items may follow from what was printed for earlier ones.
class Judge {
  public:
    /// `matched` must outlive the judge.
    Judge(const std::vector<MatchedItem>& matched, const reference::AnswerKey& key, const reference::Assignment& assignment);

    /// Everything of the item's score but its points.
    ItemScore judge(const reference::KeyItem& item);

  private:
    const MatchedItem* readable(const ItemId& id) const;
    Target target_with_allowance(const reference::KeyItem& item, const reference::Answer& answer) const;
    ItemVerdict judge_value(const reference::KeyItem& item, const MatchedItem& printed, ItemScore& score);
    bool is_right(const reference::KeyItem& item, const MatchedItem& printed, ItemScore& score);
    bool is_right_quadratic(const MatchedItem& printed, ItemScore& score) const;
    bool is_right_matrix(const reference::KeyItem& item, const MatchedItem& printed, ItemScore& score);
    bool is_right_multiplied(const reference::KeyItem& item, const MatchedItem& printed, ItemScore& score);
    bool is_right_rhs(const reference::KeyItem& item, const MatchedItem& printed, ItemScore& score) const;
    ItemVerdict judge_verdict(const reference::KeyItem& item, const PrintedVerdict& printed, ItemScore& score) const;
    void remember(const MatchedItem& printed, const ItemScore& score);

    const std::vector<MatchedItem>& matched_;
    const reference::AnswerKey& key_;
    const reference::Rubric& rubric_;
    Evidence evidence_;
};

}  // namespace harness
