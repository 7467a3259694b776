// The verdict on each item, before points.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "harness/mark/compare/first_hit.h"
#include "harness/mark/score/gather.h"
#include "harness/mark/score/score.h"

namespace harness {

/// An item's score without its points, and what it tells about the items after it.
struct Judgement {
    ItemScore score;
    std::optional<SystemForm> system;   ///< the layout of the student's linear system, if this item shows it
    std::optional<QuadraticForm> form;  ///< of the student's quadratic, if this item follows in it
    bool says_nothing = false;          ///< a wrong "none" or nan: nothing can follow from it
};

/// Adds what a judgement tells to what is known.
void learn(Evidence& evidence, const Judgement& judgement);

/// Judges items: by themselves first, then by what was printed for the items before them.
class Judge {
  public:
    /// The arguments must outlive the judge.
    Judge(const std::vector<MatchedItem>& matched, const std::map<ItemId, Finding>& findings,
          const reference::AnswerKey& key, const reference::Assignment& assignment)
        : matched_(matched), findings_(findings), key_(key), rubric_(assignment.rubric) {}

    /// Items are judged in the handout's order; `evidence` is what gather gave and what was learnt since.
    Judgement judge(const reference::KeyItem& item, const Evidence& evidence) const;

  private:
    void judge_value(const reference::KeyItem& item, const MatchedItem& printed, const Evidence& evidence,
                     Judgement& judgement) const;
    void name_mistake(const MatchedItem& printed, const Evidence& evidence, double allowance,
                      Judgement& judgement) const;
    bool is_right_rhs(const reference::KeyItem& item, const MatchedItem& printed, const Evidence& evidence) const;
    std::optional<SystemForm> multiplied_form(const MatchedItem& printed, const Evidence& evidence,
                                              double allowance) const;
    // judge_first_hit.cpp
    ItemVerdict judge_first_object(const reference::KeyItem& item, const PrintedFirstObject& printed,
                                   const Evidence& evidence, ItemScore& score) const;
    std::optional<HitValues> own_hits(const Evidence& evidence) const;
    /// Whether the sentence names the first of the objects that the student does not call missed, where one is so
    /// called though it is not.
    bool follows_wrong_miss(const PrintedFirstObject& printed, const Evidence& evidence) const;
    /// Whether two objects have the same printed t, it is wrong for at least one of them, and no other object is
    /// nearer. Such values decide no order.
    bool is_same_wrong_t(const Evidence& evidence) const;

    const std::vector<MatchedItem>& matched_;
    const std::map<ItemId, Finding>& findings_;
    const reference::AnswerKey& key_;
    const reference::Rubric& rubric_;
};

}  // namespace harness
