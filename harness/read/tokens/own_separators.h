// What a program writes between the numbers of a list where it is not a comma, a blank or a bar: "1 / 2 / 3",
// "1 in x, 2 in y, 3 in z", "1 i + 2 j - 3 k".
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "harness/read/tokens/token.h"

namespace harness {

/// Whether token i is the index in "[0] = 1.5".
bool is_bracketed_index(const std::vector<Token>& tokens, std::size_t i);

/// A program prints all its lists through the same lines of code. So what stands between the numbers of three lists,
/// the same within each list, separates numbers everywhere in its output.
class OwnSeparators {
  public:
    OwnSeparators() = default;
    explicit OwnSeparators(const std::vector<std::string_view>& lines);

    /// Puts commas for the separators of each list of three or more numbers, and brackets around a list whose
    /// components have names. The tokens stay in order and still point to their bytes of the line.
    void replace_in(std::vector<Token>& tokens, std::string_view line) const;

  private:
    std::set<std::string> separators_;
};

}  // namespace harness
