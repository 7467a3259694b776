// Finds the line that names the first object hit, from its changes with the scene.
#pragma once

#include <optional>
#include <span>

#include "harness/experiment/identify/claims.h"
#include "harness/experiment/identify/printed_words.h"

namespace harness::experiment {

/// The line whose words change with the first object hit, and the object it names, in known words or in words that the
/// program uses when it prints values of only that object. Empty if there is no such line, if lines disagree, or if the
/// same object is first on every other scene.
std::optional<ItemPlace> find_verdict(const reference::ItemSpec& item, const Slots& slots,
                                      std::span<const Observation> others, const Claims& claims,
                                      const PrintedWords& words);

}  // namespace harness::experiment
