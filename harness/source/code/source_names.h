// The names that a source gives to its lists and values.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "harness/source/code/words.h"

namespace harness::source {

/// The variable that a list initializes, and the type or function before it; both may be empty.
struct Naming {
    std::string name;
    std::string_view callee;
};

class SourceNames {
  public:
    /// `words` must outlive this object.
    explicit SourceNames(const std::vector<Word>& words);

    /// Whether the bracket at `open` contains statements rather than a list.
    bool is_block(std::size_t open) const { return is_block_[open]; }

    /// The name on the left of '=' at `equals`: "eye", "eye.x", "eye[0]".
    std::string left_of(std::size_t equals) const;

    /// The names of the list that begins with the bracket at `open`. The bracket must have a partner.
    Naming of_list(std::size_t open) const;

    /// By name, the words that give the variable its value: an '=', or the bracket after the name. "hit.x = 1" sets
    /// "hit".
    std::map<std::string, std::vector<std::size_t>, std::less<>> settings() const;

  private:
    bool is(std::size_t at, std::string_view text) const { return is_symbol(words_, at, text); }
    std::size_t before_index(std::size_t at) const;
    bool is_declared(std::size_t at) const;
    Naming one_bracket_further_out(std::size_t open) const;

    const std::vector<Word>& words_;
    std::vector<bool> is_block_;  ///< by index of the opening bracket
};

}  // namespace harness::source
