// Which of the vector instructions that the walk is written for this machine has.
#pragma once

#include <vector>

namespace reference::render {

/// The vector instructions that rays are walked through a tree with. All decide alike.
enum class Instructions { portable, avx2 };

/// The fastest instructions of this machine.
Instructions best_instructions();
/// Those that it has, the portable ones first.
std::vector<Instructions> all_instructions();

}  // namespace reference::render
