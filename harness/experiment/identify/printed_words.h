// Uses the words of an output to rule out numbers. Words may say that a number is not an item, but never that it is.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "harness/experiment/identify/candidate.h"
#include "harness/experiment/identify/slots.h"
#include "harness/match/matched_item.h"
#include "harness/match/question_match.h"

namespace harness::experiment {

class PrintedWords {
  public:
    /// All arguments must outlive this object. `matched` are the items as read by labels, order and layout.
    PrintedWords(const Transcript& transcript, const std::vector<MatchedItem>& matched, const Slots& slots,
                 std::span<const reference::ItemSpec> items);

    /// The value that was read for the item; null if there is none or it has another shape.
    const MatchedItem* value_of(const reference::ItemId& id) const;
    /// The slots that a value was read from; empty if they are unknown.
    std::vector<std::size_t> slots_of(const PrintedValue& value) const;
    /// The value that was read from the slot; null if none was.
    const PrintedValue* value_at(std::size_t slot) const { return values_[slot]; }

    /// How well the words before the number name the item: the reader's label or the words on its line.
    LabelFit fit(std::size_t slot, const reference::ItemSpec& item);
    /// Whether the words of the number's line, or its label, say that it is not an answer.
    bool is_no_answer(std::size_t slot, const reference::ItemSpec& item);
    /// Whether words rule out the number for this item: is_no_answer, or the name of another item in the question.
    bool is_barred(std::size_t slot, const reference::ItemSpec& item);
    bool is_barred(const Candidate& candidate, const reference::ItemSpec& item);
    /// Whether some number has the item's own name. Then numbers without that name are ruled out.
    bool is_named_somewhere(const reference::ItemSpec& item);
    /// Whether the item's name may appear at the slot: under its question's heading or, if there is no such heading,
    /// anywhere, unless another item has the same name.
    bool may_be_named_at(std::size_t slot, const reference::ItemSpec& item);
    /// The order stated by the labels of a matrix's rows, or the order of the value read from these numbers.
    MatrixOrder stated_order(const std::vector<std::size_t>& slots, const reference::ItemSpec& item) const;
    /// Whether each minus sign that is separate from its digits is a dash after a label, so that the reader ignored it.
    bool has_only_dashes(const Candidate& candidate) const;
    bool has_signs_apart(const Candidate& candidate) const;

    /// Discards the headings, because they are rows of a matrix that begin with "1)".
    void forget_headings() { headings_.clear(); }
    bool has_heading(int question) const { return headings_.contains(question); }
    /// 0 under the heading of the item's question, 1 if the question has no heading, 2 under another heading; the
    /// maximum over the slots.
    int distance_from_question(const std::vector<std::size_t>& slots, const reference::ItemSpec& item) const;

  private:
    const std::vector<MatchedItem>& matched_;
    const Slots& slots_;
    std::span<const reference::ItemSpec> items_;
    Fits fits_;
    std::set<int> headings_;
    std::vector<const PrintedValue*> values_;  ///< by slot
    std::map<int, bool> no_answer_;            ///< by line
};

}  // namespace harness::experiment
