// The line that says what is hit first, found by how it changes with the scene.
#pragma once

#include <optional>
#include <span>

#include "harness/experiment/identify/claims.h"
#include "harness/experiment/identify/printed_words.h"

namespace harness::experiment {

/// The line whose words change with the object that is hit first, and what it says: in words that are known, or that
/// the program uses where it prints what belongs to one object only. Empty if there is none, if lines disagree, or if
/// the same object is first on every other scene.
std::optional<ItemPlace> find_verdict(const reference::ItemSpec& item, const Slots& slots,
                                      std::span<const Observation> others, const Claims& claims,
                                      const PrintedWords& words);

}  // namespace harness::experiment
