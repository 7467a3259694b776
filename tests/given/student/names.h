// What students call the answers that they print.
#pragma once

#include <string>
#include <vector>

#include "reference/stages/items.h"

namespace student {

using Words = std::vector<std::string>;

/// What students call an item: with symbols, with words, as the handout does, as a variable.
const Words& names_of(const reference::ItemId& id);

}  // namespace student
