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

    /// A value that is right on every other scene: where the item is named, then on the fewest lines. If its question
    /// has a heading, only under that.
    void find_right(const reference::ItemSpec& item);
    /// A value that is right in another form, follows, or is what a named mistake gives. Only numbers under the heading
    /// of the question are tried, because there are many ways to be wrong.
    void find_derived(const reference::ItemSpec& item);
    /// What is left under the heading of the question, if it has the item's shape. Nothing explains it, but what is
    /// computed with it may follow from it.
    void find_rest(const reference::ItemSpec& item);
    /// A number that is the same on every scene, as a = 1 is: beside the number of the item before it or behind it in
    /// its question, or as the only such number there, if nothing else is left that may be the item.
    void find_constant(const reference::ItemSpec& item);

    /// Whether numbers that may be the item were found to be nothing: enough of them, one of which changes from scene
    /// to scene.
    bool is_left_for(const reference::ItemSpec& item);
    /// Whether a number that never changes may be the item, of which nothing can be shown.
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
