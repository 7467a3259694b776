// What the words of an output say of its numbers. They may forbid that a number is an item, but never decide it.
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
    /// All must outlive this. `matched` are the items as they were read by labels, order and layout.
    PrintedWords(const Transcript& transcript, const std::vector<MatchedItem>& matched, const Slots& slots,
                 std::span<const reference::ItemSpec> items);

    /// What was read for the item; null if nothing was, or nothing of its shape.
    const MatchedItem* value_of(const reference::ItemId& id) const;
    /// The slots that a value was read from; empty if they can't be told.
    std::vector<std::size_t> slots_of(const PrintedValue& value) const;
    /// The value that was read from the slot; null if none was.
    const PrintedValue* value_at(std::size_t slot) const { return values_[slot]; }

    /// How well the words before the number name the item, as the reader took them or as they are on its line.
    LabelFit fit(std::size_t slot, const reference::ItemSpec& item);
    /// Whether the words of the number's line, or its label, say that it is no answer.
    bool is_no_answer(std::size_t slot, const reference::ItemSpec& item);
    /// Whether words say that a number is not this item's: those above, or the name of another item of the
    /// question.
    bool is_barred(std::size_t slot, const reference::ItemSpec& item);
    bool is_barred(const Candidate& candidate, const reference::ItemSpec& item);
    /// Whether a number has the item's own name, so that one without it can't be meant.
    bool is_named_somewhere(const reference::ItemSpec& item);
    /// Whether the slot is where the item may be named: under its question's heading; if it has none, anywhere, unless
    /// the name is also another item's.
    bool may_be_named_at(std::size_t slot, const reference::ItemSpec& item);
    /// The order that the labels of a matrix's rows state, or that of the value which was read from these numbers.
    MatrixOrder stated_order(const std::vector<std::size_t>& slots, const reference::ItemSpec& item) const;
    /// Whether each minus sign apart from its digits is a dash behind a label: the reader took the number without it.
    bool has_only_dashes(const Candidate& candidate) const;
    bool has_signs_apart(const Candidate& candidate) const;

    /// Says that what was read as headings are none: rows of a matrix that begin with "1)".
    void forget_headings() { headings_.clear(); }
    bool has_heading(int question) const { return headings_.contains(question); }
    /// 0 under the heading of the item's question, 1 if it has none, 2 under another heading; the largest of the
    /// slots'.
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
