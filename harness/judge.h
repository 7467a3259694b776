// The verdict on each item, before points.
#pragma once

#include <vector>

#include "harness/close_call.h"
#include "harness/score.h"

namespace harness {

/// Judges items: first each by itself, right or not; then, where it is not right, by what was printed for the others.
class Judge {
  public:
    /// The three must outlive the judge.
    Judge(const std::vector<MatchedItem>& matched, const reference::AnswerKey& key,
          const reference::Assignment& assignment);

    /// Everything of the item's score but its points. Every item of the key once, in the handout's order.
    ItemScore judge(const reference::KeyItem& item);

  private:
    const MatchedItem* readable(const ItemId& id) const;
    void collect_evidence();
    void remember(const reference::KeyItem& item, const MatchedItem& printed);
    void forget(const ItemId& id);
    ItemVerdict judge_value(const reference::KeyItem& item, const MatchedItem& printed, ItemScore& score);
    ItemScore start_score(const reference::KeyItem& item) const;
    bool is_right(const reference::KeyItem& item, const MatchedItem& printed, ItemScore& score);
    /// Whether the key rounds to what was printed, which has fewer decimals than the rubric's min_decimals.
    bool is_right_but_coarse(const reference::KeyItem& item, const MatchedItem& printed) const;
    bool is_right_quadratic(const reference::KeyItem& item, const MatchedItem& printed, ItemScore& score) const;
    bool is_right_matrix(const reference::KeyItem& item, const MatchedItem& printed, ItemScore& score);
    bool is_right_multiplied(const MatchedItem& printed, ItemScore& score);
    bool is_right_rhs(const reference::KeyItem& item, const MatchedItem& printed, ItemScore& score) const;
    ItemVerdict judge_verdict(const reference::KeyItem& item, const PrintedVerdict& printed, ItemScore& score) const;
    std::optional<HitValues> own_hits() const;
    /// The same number for both objects, which is not right for both: nothing is first by it.
    bool is_same_wrong_t() const;

    const std::vector<MatchedItem>& matched_;
    const reference::AnswerKey& key_;
    const reference::Rubric& rubric_;
    Evidence evidence_;
};

}  // namespace harness
