// Looks for doubtful items among the numbers of an output.
#pragma once

#include <cstddef>
#include <span>
#include <utility>

#include "harness/experiment/identify/claims.h"
#include "harness/experiment/identify/printed_words.h"

namespace harness::experiment {

/// Each function adds a claim for one item, or none.
class Search {
  public:
    Search(const Slots& slots, std::span<const reference::ItemSpec> items, PrintedWords& words, Claims& claims)
        : slots_(slots.numbers), items_(items), words_(words), claims_(claims) {}

    /// Claims a value that is right on every other scene. Prefers places with the item's name, then values on the
    /// fewest lines. If the question has a heading, searches only below it.
    void find_right(const reference::ItemSpec& item);
    /// Claims a value that is right in another form, follows, or results from a named mistake. Tries only numbers under
    /// the question's heading, because there are many ways to be wrong.
    void find_derived(const reference::ItemSpec& item);
    /// Claims the remaining numbers under the question's heading if they have the item's shape. Nothing explains them,
    /// but later items may follow from them.
    void find_rest(const reference::ItemSpec& item);
    /// Claims a number that is the same on every scene, such as a = 1. It must be next to the number of the previous or
    /// next item of the question, or the only such number there, and no other number that may be the item may be left.
    void find_constant(const reference::ItemSpec& item);

    /// Whether enough unclaimed numbers are left that may be the item, at least one of which changes between scenes.
    bool is_left_for(const reference::ItemSpec& item);
    /// Whether a number that never changes may be the item. Runs on other scenes can't show that.
    bool may_be_constant(const reference::ItemSpec& item);

  private:
    template <class Then>
    void for_each_candidate(const reference::ItemSpec& item, std::span<const Pattern> patterns, Then then);
    std::pair<std::size_t, std::size_t> extent_of(const reference::ItemSpec& item) const;
    std::vector<std::size_t> constants_of(const reference::ItemSpec& item);
    bool has_headings_inside(const Candidate& candidate) const;
    bool is_beside_neighbor(std::size_t slot, const reference::ItemSpec& item) const;

    const std::vector<Slot>& slots_;
    std::span<const reference::ItemSpec> items_;
    PrintedWords& words_;
    Claims& claims_;
};

}  // namespace harness::experiment
