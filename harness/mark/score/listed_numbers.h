// Every number of a printout, and what it is to the answers.
#pragma once

#include <set>
#include <vector>

#include "harness/mark/score/marked_printout.h"
#include "harness/read/tokens/token.h"

namespace harness {

/// A number of the printout, wherever it stands.
struct ListedNumber {
    PrintedNumber number;
    int question;
    int line;
    bool in_answer = false;  ///< it belongs to what was read for an item
    bool in_right_answer = false;
    bool is_scalar = false;              ///< it is an answer of one number, which is right or follows
    const MatchedItem* named = nullptr;  ///< the item that it was read for, if its label names it
    bool is_aside = false;               ///< it is said to be no answer, or counts something
    bool repeats = false;                ///< an answer has the same number

    /// Whether nothing says what it is.
    bool is_left() const { return !in_answer && !is_aside; }
};

/// Whether what was read for the item includes this number of the printout.
bool was_read_from(const MatchedItem& item, const ListedNumber& listed);

/// Whether the label of what was read for `item` names the item `other`.
bool names(const MatchedItem& item, const reference::ItemSpec& other);

class ListedNumbers {
  public:
    explicit ListedNumbers(const MarkedPrintout& printout);

    /// At most some thousand; beyond them a printout is an endless loop's.
    const std::vector<ListedNumber>& all() const { return numbers_; }

    /// Whether `size` numbers from `first` on, a stride apart, are printed as one value: in one line, in whole lines
    /// one after the other, or as a column of lines that have as many numbers as the stride. Others are pieces of
    /// several values.
    bool is_one_value(std::size_t first, std::size_t size, std::size_t stride) const;

  private:
    void list(const Transcript& transcript);
    void account_for_answers(const MarkedPrintout& printout);
    void account_for_asides(const MarkedPrintout& printout);
    bool begins_line(std::size_t i) const { return i == 0 || numbers_[i - 1].line != numbers_[i].line; }
    bool ends_line(std::size_t i) const { return i + 1 == numbers_.size() || begins_line(i + 1); }

    std::vector<ListedNumber> numbers_;
    std::set<int> equations_;       ///< the lines with a number directly behind "=" or ":"
    std::vector<double> answered_;  ///< the numbers that were read for items, sorted
};

}  // namespace harness
