// By which names a source calls the lists and values it states.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "harness/variants/words.h"

namespace harness::variants {

/// What a list initialises, and the type or function before it; both may be empty.
struct Naming {
    std::string name;
    std::string_view callee;
};

class SourceNames {
  public:
    /// `words` must outlive it.
    explicit SourceNames(const std::vector<Word>& words);

    /// Whether that bracket holds statements rather than a list.
    bool is_block(std::size_t open) const { return is_block_[open]; }

    /// The name on the left of '=' at `equals`: "eye", "eye.x", "eye[0]".
    std::string left_of(std::size_t equals) const;

    /// Of the list that the bracket `open`, which has its end, begins.
    Naming of_list(std::size_t open) const;

  private:
    bool is(std::size_t at, std::string_view text) const { return is_symbol(words_, at, text); }
    std::size_t before_index(std::size_t at) const;
    bool is_declared(std::size_t at) const;
    Naming one_bracket_further_out(std::size_t open) const;

    const std::vector<Word>& words_;
    std::vector<bool> is_block_;  ///< by place of the bracket
};

}  // namespace harness::variants
