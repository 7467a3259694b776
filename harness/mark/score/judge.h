// The verdict on each item, before points.
#pragma once

#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "harness/mark/compare/first_hit.h"
#include "harness/mark/score/gather.h"
#include "harness/mark/score/score.h"

namespace harness {

/// Added to the advice on a mistake that costs no points until an earlier answer is wrong.
inline constexpr std::string_view made_visible = " This shows only because of your earlier mistake.";

/// An item's score without its points, and facts for judging later items.
struct Judgement {
    ItemScore score;
    std::optional<SystemForm> system;   ///< the layout of the student's linear system, if the item shows it
    std::optional<QuadraticForm> form;  ///< of the student's quadratic, if the item follows in this form
    bool says_nothing = false;          ///< a wrong "none" or nan: nothing can follow from it
};

/// Adds a judgement's facts to the evidence.
void learn(Evidence& evidence, const Judgement& judgement);

/// Judges each item on its own first, then by the answers printed for earlier items.
class Judge {
  public:
    /// The arguments must outlive the judge.
    Judge(const std::vector<MatchedItem>& matched, const std::map<ItemId, Finding>& findings,
          const reference::AnswerKey& key, const reference::Assignment& assignment)
        : matched_(matched), findings_(findings), key_(key), rubric_(assignment.rubric) {}

    /// Call it in the handout's order. `evidence` comes from gather, plus everything learned since.
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
    /// Whether the student wrongly calls an object missed, and the sentence names the first of the other objects.
    bool follows_wrong_miss(const PrintedFirstObject& printed, const Evidence& evidence) const;
    /// Whether two objects have the same printed t, which is wrong for at least one of them, and no other object is
    /// nearer. Such values do not decide the order.
    bool is_same_wrong_t(const Evidence& evidence) const;

    const std::vector<MatchedItem>& matched_;
    const std::map<ItemId, Finding>& findings_;
    const reference::AnswerKey& key_;
    const reference::Rubric& rubric_;
};

}  // namespace harness
