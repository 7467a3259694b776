// Every number of a printout, and its relation to the answers.
#pragma once

#include <set>
#include <vector>

#include "harness/mark/score/score.h"
#include "harness/match/matched_item.h"
#include "harness/read/tokens/token.h"
#include "harness/read/transcript.h"
#include "reference/key/answer_key.h"

namespace harness {

/// The input for finding doubts: a printout, the answers read from it, and their score.
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

/// A number anywhere in the printout.
struct ListedNumber {
    PrintedNumber number;
    int question;
    int line;
    bool in_answer = false;  ///< it is part of the value read for an item
    bool in_right_answer = false;
    bool is_scalar = false;              ///< it is an answer with one number that is right or follows
    const MatchedItem* named = nullptr;  ///< the item that it was read for, if its label names it
    bool is_aside = false;               ///< its words say that it is not an answer, or it is a counter
    bool repeats = false;                ///< an answer has the same number
    bool has_loose_sign = false;         ///< a minus sign before it was not read as part of it: "-'6.7'"

    /// Whether the number is unexplained.
    bool is_left() const { return !in_answer && !is_aside; }
};

/// Whether the value read for the item includes this number of the printout.
bool was_read_from(const MatchedItem& item, const ListedNumber& listed);

/// Whether the label of the value read for `item` names the item `other`.
bool names(const MatchedItem& item, const reference::ItemSpec& other);

class ListedNumbers {
  public:
    explicit ListedNumbers(const MarkedPrintout& printout);

    /// At most a few thousand; a longer printout comes from an endless loop.
    const std::vector<ListedNumber>& all() const { return numbers_; }

    /// Whether `size` numbers from `first` on, `stride` apart, are printed as one value: on one line, on consecutive
    /// whole lines, or as a column of lines with `stride` numbers each. Otherwise they are pieces of several values.
    bool is_one_value(std::size_t first, std::size_t size, std::size_t stride) const;

  private:
    void list(const Transcript& transcript);
    void account_for_answers(const MarkedPrintout& printout);
    void account_for_asides(const MarkedPrintout& printout);
    bool begins_line(std::size_t i) const { return i == 0 || numbers_[i - 1].line != numbers_[i].line; }
    bool ends_line(std::size_t i) const { return i + 1 == numbers_.size() || begins_line(i + 1); }

    std::vector<ListedNumber> numbers_;
    std::set<int> sentences_;       ///< the lines with a word of two letters or more
    std::set<int> equations_;       ///< the lines with a number directly behind "=" or ":"
    std::vector<double> answered_;  ///< the numbers read for items, sorted
};

}  // namespace harness
